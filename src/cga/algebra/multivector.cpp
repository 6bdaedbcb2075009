#include "cga/algebra/multivector.hpp"

#include "cga/algebra/geometric_product_avx2.hpp"
#include "cga/algebra/multivector_product.hpp"
#include "cga/algebra/null_basis.hpp"
#include "cga/platform/compiler.hpp"
#include "cga/platform/processor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cga {

namespace {

// A norm below this fraction of the sum of squares is zero within rounding.
constexpr double ROUNDING = 16.0 * std::numeric_limits<double>::epsilon();

// The pseudoscalar I as a bitmap.
constexpr unsigned PSEUDOSCALAR = BLADE_COUNT - 1;

// I^2 = -1.
constexpr int PSEUDOSCALAR_SQUARED = product_sign(PSEUDOSCALAR, PSEUDOSCALAR);

// X I times a sign: each blade becomes its complement.
Multivector times_pseudoscalar(const Multivector &x, int sign) {
	Multivector result;
	for (unsigned bitmap = 0; bitmap < BLADE_COUNT; ++bitmap) {
		const double coefficient = x[BLADE_INDICES[bitmap]];
		result[BLADE_INDICES[bitmap ^ PSEUDOSCALAR]] = sign * product_sign(bitmap, PSEUDOSCALAR) > 0 ? coefficient : -coefficient;
	}
	return result;
}

// `x` with a sign for each grade.
template <class SignOfGrade>
Multivector signed_by_grade(const Multivector &x, SignOfGrade sign_of_grade) {
	Multivector result = x;
	for (int index = 0; index < BLADE_COUNT; ++index) {
		if (sign_of_grade(blade_grade(index)) < 0) {
			result[index] = -result[index];
		}
	}
	return result;
}

// The largest absolute coefficient of the grades of one parity (0 even, 1 odd).
double max_abs_of_parity(const Multivector &x, int parity) {
	double largest = 0.0;
	for (int index = 0; index < BLADE_COUNT; ++index) {
		if (blade_grade(index) % 2 == parity) {
			largest = std::max(largest, std::abs(x[index]));
		}
	}
	return largest;
}

} // namespace

Multivector Multivector::scalar(double value) {
	return basis_blade(0, value);
}

Multivector Multivector::basis_blade(int index, double value) {
	Multivector result;
	result[index] = value;
	return result;
}

std::optional<Multivector> Multivector::basis(std::string_view name) {
	if (name == "eo") {
		return e_origin();
	}
	if (name == "einf") {
		return e_infinity();
	}
	if (name == "E") {
		return e_infinity().outer_product(e_origin());
	}
	if (name == "I") {
		return basis_blade(BLADE_INDICES[PSEUDOSCALAR]);
	}
	if (const std::optional<SignedBlade> blade = parse_blade(name)) {
		return basis_blade(blade->index, blade->sign);
	}
	return std::nullopt;
}

Multivector &Multivector::operator+=(const Multivector &other) {
	for (int index = 0; index < BLADE_COUNT; ++index) {
		(*this)[index] += other[index];
	}
	return *this;
}

Multivector &Multivector::operator-=(const Multivector &other) {
	for (int index = 0; index < BLADE_COUNT; ++index) {
		(*this)[index] -= other[index];
	}
	return *this;
}

Multivector &Multivector::operator*=(double factor) {
	for (double &coefficient : _coefficients) {
		coefficient *= factor;
	}
	return *this;
}

#if CGA_X86_64
Multivector Multivector::multiply_with_avx2(const Multivector &right) const {
	Multivector product{ Uninitialized() };
	geometric_product_avx2(_coefficients.data(), right._coefficients.data(), product._coefficients.data());
	return product;
}
#endif

Multivector Multivector::geometric_product(const Multivector &right) const {
#if CGA_X86_64
	static const bool HAS_AVX2 = processor_features().avx2;
	if (HAS_AVX2) {
		return multiply_with_avx2(right);
	}
#endif
	return multiply<Product::GEOMETRIC>(*this, right);
}

Multivector Multivector::outer_product(const Multivector &right) const {
	return multiply<Product::OUTER>(*this, right);
}

Multivector Multivector::inner_product(const Multivector &right) const {
	return multiply<Product::INNER>(*this, right);
}

Multivector Multivector::left_contraction(const Multivector &right) const {
	return multiply<Product::LEFT_CONTRACTION>(*this, right);
}

Multivector Multivector::right_contraction(const Multivector &right) const {
	return multiply<Product::RIGHT_CONTRACTION>(*this, right);
}

// undual(dual(A) ^ dual(B))
Multivector Multivector::regressive_product(const Multivector &right) const {
	return dual().outer_product(right.dual()).undual();
}

Multivector Multivector::commutator_product(const Multivector &right) const {
	return multiply<Product::COMMUTATOR>(*this, right);
}

double Multivector::scalar_product(const Multivector &right) const {
	return multiply<Product::SCALAR>(*this, right)[0];
}

// (-1)^(k (k - 1) / 2)
Multivector Multivector::reverse() const {
	return signed_by_grade(*this, [](int k) { return k * (k - 1) / 2 % 2 == 0 ? 1 : -1; });
}

// (-1)^k
Multivector Multivector::grade_involution() const {
	return signed_by_grade(*this, [](int k) { return k % 2 == 0 ? 1 : -1; });
}

// (-1)^(k (k + 1) / 2)
Multivector Multivector::clifford_conjugate() const {
	return signed_by_grade(*this, [](int k) { return k * (k + 1) / 2 % 2 == 0 ? 1 : -1; });
}

// I^-1 = I / I^2
Multivector Multivector::dual() const {
	return times_pseudoscalar(*this, PSEUDOSCALAR_SQUARED);
}

Multivector Multivector::undual() const {
	return times_pseudoscalar(*this, 1);
}

Multivector Multivector::grade(int k) const {
	Multivector result;
	for (int index = 0; index < BLADE_COUNT; ++index) {
		if (blade_grade(index) == k) {
			result[index] = (*this)[index];
		}
	}
	return result;
}

double Multivector::norm_squared() const {
	return scalar_product(reverse());
}

double Multivector::norm() const {
	return std::sqrt(std::abs(norm_squared()));
}

double Multivector::sum_of_squares() const {
	double sum = 0.0;
	for (const double coefficient : _coefficients) {
		sum += coefficient * coefficient;
	}
	return sum;
}

Multivector Multivector::times_power_of_two(int exponent) const {
	Multivector result;
	for (int index = 0; index < BLADE_COUNT; ++index) {
		result[index] = std::ldexp((*this)[index], exponent);
	}
	return result;
}

double Multivector::max_abs() const {
	return std::max(max_abs_of_parity(*this, 0), max_abs_of_parity(*this, 1));
}

std::optional<Multivector> Multivector::inverse_of_versor(double tolerance) const {
	if (!(max_abs() > 0.0) || !is_finite()) {
		return std::nullopt;
	}
	// At unit size, squares neither overflow nor underflow.
	const int exponent = std::ilogb(max_abs());
	const Multivector unit = times_power_of_two(-exponent);
	const Multivector square = unit.geometric_product(unit.reverse());
	const double weight = square[0];
	const double rounding = ROUNDING * unit.sum_of_squares();
	const double residue = (square - scalar(weight)).max_abs();
	if (std::abs(weight) <= rounding || residue > std::max(rounding, tolerance * std::abs(weight))) {
		return std::nullopt;
	}
	const Multivector inverse = (unit.reverse() * (1.0 / weight)).times_power_of_two(-exponent);
	return inverse.is_finite() ? std::optional(inverse) : std::nullopt;
}

std::optional<Multivector> Multivector::sandwich(const Multivector &x, double tolerance) const {
	const std::optional<Multivector> inverse = inverse_of_versor(tolerance);
	const bool even = is_even(tolerance);
	if (!inverse || !(even || is_odd(tolerance))) {
		return std::nullopt;
	}
	return geometric_product(even ? x : x.grade_involution()).geometric_product(*inverse);
}

bool Multivector::is_equal_approx(const Multivector &other, double tolerance) const {
	for (int index = 0; index < BLADE_COUNT; ++index) {
		if (!(std::abs((*this)[index] - other[index]) <= tolerance)) {
			return false;
		}
	}
	return true;
}

bool Multivector::is_finite() const {
	return std::all_of(_coefficients.begin(), _coefficients.end(), [](double coefficient) { return std::isfinite(coefficient); });
}

bool Multivector::is_even(double tolerance) const {
	return max_abs_of_parity(*this, 1) <= tolerance * max_abs();
}

bool Multivector::is_odd(double tolerance) const {
	return max_abs_of_parity(*this, 0) <= tolerance * max_abs();
}

} // namespace cga
