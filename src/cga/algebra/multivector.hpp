#pragma once

#include "cga/algebra/blade.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace cga {

// An element of Cl(4,1): 32 coefficients, in the order of blade.hpp: 1, e1 .. e5, e12 .. e45, e123 .. e12345.
class Multivector {
public:
	using Coefficients = std::array<double, BLADE_COUNT>;

	// Zero.
	constexpr Multivector() :
			_coefficients{} {}
	constexpr explicit Multivector(const Coefficients &coefficients) :
			_coefficients(coefficients) {}

	[[nodiscard]] static Multivector scalar(double value);
	// `index` 0..31.
	[[nodiscard]] static Multivector basis_blade(int index, double value = 1.0);
	// "1", "e12", "e21" (which is -e12), "eo", "einf", "E", "I". Empty for other names.
	[[nodiscard]] static std::optional<Multivector> basis(std::string_view name);

	[[nodiscard]] constexpr double operator[](int index) const { return _coefficients[size_t(index)]; }
	[[nodiscard]] constexpr double &operator[](int index) { return _coefficients[size_t(index)]; }
	[[nodiscard]] constexpr const Coefficients &coefficients() const { return _coefficients; }

	Multivector &operator+=(const Multivector &other);
	Multivector &operator-=(const Multivector &other);
	Multivector &operator*=(double factor);

	[[nodiscard]] Multivector geometric_product(const Multivector &right) const;
	[[nodiscard]] Multivector outer_product(const Multivector &right) const;
	// The fat dot product: for parts of grades i and j, grade |i - j| of their geometric product, scalars included.
	[[nodiscard]] Multivector inner_product(const Multivector &right) const;
	// Likewise grade j - i.
	[[nodiscard]] Multivector left_contraction(const Multivector &right) const;
	// Likewise grade i - j.
	[[nodiscard]] Multivector right_contraction(const Multivector &right) const;
	// A & B, dual to the outer product: undual(dual(A) ^ dual(B)). The meet of blades that together span the whole space.
	[[nodiscard]] Multivector regressive_product(const Multivector &right) const;
	// (A B - B A) / 2.
	[[nodiscard]] Multivector commutator_product(const Multivector &right) const;
	// The scalar part of the geometric product.
	[[nodiscard]] double scalar_product(const Multivector &right) const;

	// The signs of grades 0..5: + + - - + +.
	[[nodiscard]] Multivector reverse() const;
	// + - + - + -.
	[[nodiscard]] Multivector grade_involution() const;
	// + - - + + -: the product of the two above.
	[[nodiscard]] Multivector clifford_conjugate() const;
	// X I^-1.
	[[nodiscard]] Multivector dual() const;
	// X I, so that undual(dual(X)) = X.
	[[nodiscard]] Multivector undual() const;
	// The part of grade k; zero if k is not in 0..5.
	[[nodiscard]] Multivector grade(int k) const;

	// The scalar part of X X~; negative and zero are possible in this metric.
	[[nodiscard]] double norm_squared() const;
	// sqrt(|norm_squared|); zero for null elements.
	[[nodiscard]] double norm() const;
	// The sum of the squares of the coefficients.
	[[nodiscard]] double sum_of_squares() const;
	// X 2^exponent, without rounding within the range of double.
	[[nodiscard]] Multivector times_power_of_two(int exponent) const;
	// The largest absolute value of a coefficient. Tolerances are relative to it.
	[[nodiscard]] double max_abs() const;

	// X^-1 = X~ / (X X~) if X X~ is a nonzero scalar, as for all versors and all blades that are not null. Empty
	// otherwise; versor/inverse.hpp has the inverse of any element.
	[[nodiscard]] std::optional<Multivector> inverse_of_versor(double tolerance = 1e-10) const;
	// This versor V applied to x: V x V^-1 if V is even, V gradeinv(x) V^-1 if it is odd, so that a reflection keeps the
	// orientation of elements that it maps to themselves. Empty if V is neither or has no inverse.
	[[nodiscard]] std::optional<Multivector> sandwich(const Multivector &x, double tolerance = 1e-10) const;

	// Whether corresponding coefficients differ by at most `tolerance` (absolute).
	[[nodiscard]] bool is_equal_approx(const Multivector &other, double tolerance = 1e-9) const;
	[[nodiscard]] bool is_finite() const;
	// Whether all coefficients of odd (for is_odd: even) grade are at most `tolerance` times max_abs.
	[[nodiscard]] bool is_even(double tolerance = 1e-10) const;
	[[nodiscard]] bool is_odd(double tolerance = 1e-10) const;

	[[nodiscard]] friend Multivector operator+(Multivector left, const Multivector &right) { return left += right; }
	[[nodiscard]] friend Multivector operator-(Multivector left, const Multivector &right) { return left -= right; }
	[[nodiscard]] friend Multivector operator-(Multivector operand) { return operand *= -1.0; }
	[[nodiscard]] friend Multivector operator*(Multivector left, double factor) { return left *= factor; }
	[[nodiscard]] friend Multivector operator*(double factor, Multivector right) { return right *= factor; }
	friend bool operator==(const Multivector &left, const Multivector &right) { return left._coefficients == right._coefficients; }
	friend bool operator!=(const Multivector &left, const Multivector &right) { return !(left == right); }

private:
	// For results whose coefficients are all assigned: setting 256 bytes to zero takes a fifth of the time of a geometric product.
	struct Uninitialized {};
	explicit Multivector(Uninitialized) noexcept {}
	[[nodiscard]] Multivector multiply_with_avx2(const Multivector &right) const;

	Coefficients _coefficients;
};

} // namespace cga
