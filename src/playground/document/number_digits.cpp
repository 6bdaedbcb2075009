#include "playground/document/number_digits.hpp"

#include "cga/text/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace playground {

namespace {

constexpr int DRAGGED_DIGITS = 7;
constexpr size_t TYPED_DIGITS = 10;
// The largest exponent whose power of ten is exact in a double, so that dividing by it gives the nearest decimal.
constexpr int MAX_EXACT_POWER = 22;

std::string shortest(double value) {
	std::string text;
	cga::append_number(text, value == 0.0 ? 0.0 : value);
	return text;
}

// The number of significant digits, without trailing zeros.
size_t digit_count(std::string_view text) {
	size_t count = 0;
	size_t zeros = 0;
	for (const char character : text.substr(0, text.find('e'))) {
		if (character == '0' && count > 0) {
			++zeros;
		} else if (character >= '1' && character <= '9') {
			count += zeros + 1;
			zeros = 0;
		}
	}
	return count;
}

double rounded(double value, double size) {
	const int decimals = DRAGGED_DIGITS - 1 - int(std::floor(std::log10(size)));
	if (decimals > MAX_EXACT_POWER || decimals < -MAX_EXACT_POWER) {
		return value;
	}
	const double power = std::pow(10.0, std::abs(decimals));
	return decimals >= 0 ? std::round(value * power) / power : std::round(value / power) * power;
}

} // namespace

std::string number_text(double value, double size) {
	std::string text = shortest(value);
	if (digit_count(text) <= TYPED_DIGITS) {
		return text;
	}
	return shortest(rounded(value, std::max(std::abs(value), size)));
}

} // namespace playground
