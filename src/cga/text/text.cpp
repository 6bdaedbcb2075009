#include "cga/text/text.hpp"

#include "cga/algebra/null_coefficients.hpp"
#include "cga/text/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace cga {

namespace {

std::string plain_number(double value) {
	std::string text;
	append_number(text, value);
	return text;
}

// "1.5e-07" as "1.5 \times 10^{-7}".
std::string latex_number(double value) {
	std::string text = plain_number(value);
	const size_t mark = text.find('e');
	if (mark == std::string::npos) {
		return text;
	}
	const std::string sign = text[mark + 1] == '-' ? "-" : "";
	const size_t exponent = text.find_first_not_of('0', mark + 2);
	return text.substr(0, mark) + " \\times 10^{" + sign + text.substr(exponent) + "}";
}

// How a format writes the parts of a term.
struct Format {
	std::string (*number)(double);
	std::string_view before_indices, after_indices; // of a Euclidean blade
	std::string_view infinity, origin, wedge;

	// Empty for the scalar. In the null basis, the outer product of a Euclidean blade, e_inf and e_o.
	[[nodiscard]] std::string blade(int index, bool null_basis) const {
		const BladeName name = blade_name(index);
		const std::string_view digits = name.view().substr(1);
		const size_t euclidean = null_basis ? std::min(digits.find_first_of("45"), digits.size()) : digits.size();
		std::string text;
		if (euclidean > 0) {
			text.append(before_indices).append(digits.substr(0, euclidean)).append(after_indices);
		}
		for (const char digit : digits.substr(euclidean)) {
			text += text.empty() ? "" : wedge;
			text += digit == '4' ? infinity : origin;
		}
		return text;
	}
};

constexpr Format PLAIN = { plain_number, "e", "", "einf", "eo", "^" };
constexpr Format LATEX = { latex_number, "\\mathbf{e}_{", "}", "\\mathbf{e}_{\\infty}", "\\mathbf{e}_{o}", " \\wedge " };

std::string sum(const Multivector &x, bool null_basis, const Format &format) {
	Multivector::Coefficients coefficients = null_basis ? to_null_coefficients(x) : x.coefficients();
	if (null_basis && !Multivector(coefficients).is_finite()) {
		return sum(x, false, format);
	}
	std::string text;
	for (int index = 0; index < BLADE_COUNT; ++index) {
		const double value = coefficients[size_t(index)];
		if (value == 0.0) {
			continue;
		}
		if (text.empty()) {
			text = value < 0.0 ? "-" : "";
		} else {
			text += value < 0.0 ? " - " : " + ";
		}
		const double size = std::abs(value);
		const std::string blade = format.blade(index, null_basis);
		if (size != 1.0 || blade.empty()) {
			text += format.number(size);
			text += blade.empty() ? "" : " ";
		}
		text += blade;
	}
	return text.empty() ? "0" : text;
}

} // namespace

std::string to_text(const Multivector &x, bool null_basis) {
	return sum(x, null_basis, PLAIN);
}

std::string to_latex(const Multivector &x, bool null_basis) {
	return sum(x, null_basis, LATEX);
}

} // namespace cga
