#include "cga/text/number_text.hpp"

#include "cga/platform/compiler.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

namespace cga {

namespace {

// Numbers outside this range are written with an exponent.
constexpr double MIN_PLAIN = 1e-4;
constexpr double MAX_PLAIN = 1e15;

bool is_plain(double value) {
	const double size = std::abs(value);
	return size == 0.0 || (size >= MIN_PLAIN && size < MAX_PLAIN);
}

#if CGA_HAS_CHARCONV

// Whether a decimal other than zero is below 1, apart from its sign.
bool is_below_one(std::string_view decimal) {
	const size_t exponent_start = std::min(decimal.find_first_of("eE"), decimal.size());
	const std::string_view digits = decimal.substr(0, exponent_start);
	const size_t first = digits.find_first_of("123456789");
	const size_t point = std::min(digits.find('.'), digits.size());
	// Of the first digit that counts: 0 for the last one before the point.
	const int64_t position = first < point ? int64_t(point - first) - 1 : int64_t(point) - int64_t(first);
	// from_chars() reads no plus.
	const size_t exponent_digits = decimal.find_first_of("-0123456789", exponent_start);
	if (exponent_digits == std::string_view::npos) {
		return position < 0;
	}
	int64_t exponent = 0;
	const char *end = decimal.data() + decimal.size();
	if (std::from_chars(decimal.data() + exponent_digits, end, exponent).ec == std::errc::result_out_of_range) {
		return decimal[exponent_digits] == '-';
	}
	return position + exponent < 0;
}

#endif

} // namespace

namespace detail {

void append_number_by_stream(std::string &text, double value) {
	std::ostringstream stream;
	stream.imbue(std::locale::classic());
	for (int digits = 1; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
		stream.str({});
		if (is_plain(value)) {
			stream.unsetf(std::ios_base::floatfield);
			stream.precision(std::max(digits, int(std::floor(std::log10(std::max(std::abs(value), 1.0)))) + 1));
		} else {
			stream.setf(std::ios_base::scientific, std::ios_base::floatfield);
			stream.precision(digits - 1);
		}
		stream << value;
		if (read_number_by_stream(stream.str()) == value) {
			break;
		}
	}
	text += stream.str();
}

std::optional<double> read_number_by_stream(std::string_view decimal) {
	std::istringstream stream{ std::string(decimal) };
	stream.imbue(std::locale::classic());
	double value = 0.0;
	stream >> value;
	// The stream fails on overflow and, in some libraries, on underflow.
	return stream.fail() && std::abs(value) > 1.0 ? std::nullopt : std::optional(value);
}

} // namespace detail

void append_number(std::string &text, double value) {
#if CGA_HAS_CHARCONV
	char digits[64];
	const std::chars_format format = is_plain(value) ? std::chars_format::fixed : std::chars_format::scientific;
	text.append(digits, std::to_chars(digits, digits + sizeof(digits), value, format).ptr);
#else
	detail::append_number_by_stream(text, value);
#endif
}

std::optional<double> read_number(std::string_view decimal) {
#if CGA_HAS_CHARCONV
	double value = 0.0;
	if (std::from_chars(decimal.data(), decimal.data() + decimal.size(), value).ec != std::errc::result_out_of_range) {
		return value;
	}
	// from_chars() does not distinguish overflow from underflow.
	return is_below_one(decimal) ? std::optional(decimal[0] == '-' ? -0.0 : 0.0) : std::nullopt;
#else
	return detail::read_number_by_stream(decimal);
#endif
}

} // namespace cga
