#include "cga/text/number_text.hpp"

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

#ifdef __cpp_lib_to_chars
constexpr bool is_digit(char character) {
	return character >= '0' && character <= '9';
}

// Whether a decimal outside the range of double is too small for it rather than too large: the power of ten of its first
// nonzero digit is below zero.
bool is_too_small(std::string_view decimal) {
	const size_t mark = decimal.find_first_of("eE");
	const std::string_view digits = decimal.substr(0, mark);
	const size_t point = std::min(digits.find('.'), digits.size());
	const size_t first = digits.find_first_of("123456789");
	if (first == std::string_view::npos) {
		return true;
	}
	// The power of ten of the first digit.
	double power = first < point ? double(point - first) - 1.0 : -double(first - point);
	if (mark != std::string_view::npos) {
		double exponent = 0.0;
		for (const char digit : decimal.substr(mark + 1)) {
			exponent = is_digit(digit) ? exponent * 10.0 + (digit - '0') : exponent;
		}
		power += decimal[mark + 1] == '-' ? -exponent : exponent;
	}
	return power < 0.0;
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
	// Overflow sets failbit.
	return stream.fail() ? std::nullopt : std::optional<double>(value);
}

} // namespace detail

#ifdef __cpp_lib_to_chars

void append_number(std::string &text, double value) {
	char digits[64];
	const std::chars_format format = is_plain(value) ? std::chars_format::fixed : std::chars_format::scientific;
	text.append(digits, std::to_chars(digits, digits + sizeof(digits), value, format).ptr);
}

std::optional<double> read_number(std::string_view decimal) {
	double value = 0.0;
	const std::from_chars_result read = std::from_chars(decimal.data(), decimal.data() + decimal.size(), value);
	if (read.ec == std::errc::result_out_of_range) {
		return is_too_small(decimal) ? std::optional<double>(decimal[0] == '-' ? -0.0 : 0.0) : std::nullopt;
	}
	return value;
}

#else

void append_number(std::string &text, double value) {
	detail::append_number_by_stream(text, value);
}

std::optional<double> read_number(std::string_view decimal) {
	return detail::read_number_by_stream(decimal);
}

#endif

} // namespace cga
