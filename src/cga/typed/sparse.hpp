#pragma once

#include "cga/algebra/null_coefficients.hpp"
#include "cga/platform/compiler.hpp"
#include "cga/typed/kernel.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

// Multivectors that store only the coefficients of their type: of the 32, a line has 6, a sphere 5 and a motor 12.
//
// The type of a product follows from the types of its factors, and its code is straight-line: one multiplication for each term
// that can be nonzero, no branch, no loop. Coefficients are those of e_inf and e_o, not of e4 and e5: flats are then
// sparse, and objects far from the origin keep their precision.
//
// Methods have the names of Multivector's; every element converts to and from Multivector.

namespace cga::typed {

template <BladeSet SET, class T = double>
class Sparse;

// The part of a product in the blades of RESULT.
template <BladeSet RESULT, Product PRODUCT, BladeSet LEFT, BladeSet RIGHT, class T>
[[nodiscard]] constexpr Sparse<RESULT, T> multiply_into(const Sparse<LEFT, T> &left, const Sparse<RIGHT, T> &right) noexcept;

// The whole product.
template <Product PRODUCT, BladeSet LEFT, BladeSet RIGHT, class T>
[[nodiscard]] constexpr Sparse<product_blades(PRODUCT, LEFT, RIGHT), T> multiply(const Sparse<LEFT, T> &left, const Sparse<RIGHT, T> &right) noexcept {
	return multiply_into<product_blades(PRODUCT, LEFT, RIGHT), PRODUCT>(left, right);
}

template <BladeSet SET, class T>
class Sparse {
public:
	static constexpr BladeSet BLADES = SET;
	static constexpr size_t SIZE = size_t(size_of(SET));

	// In the order of the blades' indices.
	std::array<T, SIZE> coefficients{};

	// The coefficient of a null blade: E1 of e1, E4 of e_inf, E5 of e_o, E14 of e1 ^ e_inf.
	template <int INDEX>
	[[nodiscard]] constexpr T &at() noexcept {
		static_assert(contains(SET, INDEX), "elements of this type have no such blade");
		return coefficients[slot_of(SET, INDEX)];
	}
	template <int INDEX>
	[[nodiscard]] constexpr T at() const noexcept {
		static_assert(contains(SET, INDEX), "elements of this type have no such blade");
		return coefficients[slot_of(SET, INDEX)];
	}

	// Empty if `x` has a coefficient of another blade above `tolerance` times its largest one (in the null basis), or is not
	// finite.
	[[nodiscard]] static std::optional<Sparse> from(const Multivector &x, double tolerance = 1e-10);
	[[nodiscard]] Multivector to_multivector() const;

	template <BladeSet RIGHT>
	[[nodiscard]] constexpr auto geometric_product(const Sparse<RIGHT, T> &right) const noexcept { return multiply<Product::GEOMETRIC>(*this, right); }
	template <BladeSet RIGHT>
	[[nodiscard]] constexpr auto outer_product(const Sparse<RIGHT, T> &right) const noexcept { return multiply<Product::OUTER>(*this, right); }
	template <BladeSet RIGHT>
	[[nodiscard]] constexpr auto inner_product(const Sparse<RIGHT, T> &right) const noexcept { return multiply<Product::INNER>(*this, right); }
	template <BladeSet RIGHT>
	[[nodiscard]] constexpr auto left_contraction(const Sparse<RIGHT, T> &right) const noexcept { return multiply<Product::LEFT_CONTRACTION>(*this, right); }
	template <BladeSet RIGHT>
	[[nodiscard]] constexpr auto right_contraction(const Sparse<RIGHT, T> &right) const noexcept { return multiply<Product::RIGHT_CONTRACTION>(*this, right); }
	template <BladeSet RIGHT>
	[[nodiscard]] constexpr auto commutator_product(const Sparse<RIGHT, T> &right) const noexcept { return multiply<Product::COMMUTATOR>(*this, right); }
	template <BladeSet RIGHT>
	[[nodiscard]] constexpr T scalar_product(const Sparse<RIGHT, T> &right) const noexcept { return multiply_into<1u, Product::SCALAR>(*this, right).coefficients[0]; }
	// undual(dual(A) ^ dual(B)): the meet of blades that together span the whole space.
	template <BladeSet RIGHT>
	[[nodiscard]] constexpr auto regressive_product(const Sparse<RIGHT, T> &right) const noexcept { return dual().outer_product(right.dual()).undual(); }

	[[nodiscard]] constexpr Sparse reverse() const noexcept {
		return with_signs([](int grade) { return grade % 4 < 2; });
	}
	[[nodiscard]] constexpr Sparse grade_involution() const noexcept {
		return with_signs([](int grade) { return grade % 2 == 0; });
	}
	// X I^-1 and X I, with I^-1 = -I.
	[[nodiscard]] constexpr auto dual() const noexcept { return -undual(); }
	[[nodiscard]] constexpr auto undual() const noexcept {
		return geometric_product(Sparse<BladeSet(1) << E12345, T>{ { T(1) } });
	}

	friend constexpr Sparse operator+(Sparse left, const Sparse &right) noexcept {
		for (size_t i = 0; i < SIZE; ++i) {
			left.coefficients[i] += right.coefficients[i];
		}
		return left;
	}
	friend constexpr Sparse operator*(Sparse left, T factor) noexcept {
		for (size_t i = 0; i < SIZE; ++i) {
			left.coefficients[i] *= factor;
		}
		return left;
	}
	friend constexpr Sparse operator*(T factor, const Sparse &right) noexcept { return right * factor; }
	friend constexpr Sparse operator-(const Sparse &operand) noexcept { return operand * T(-1); }
	friend constexpr Sparse operator-(const Sparse &left, const Sparse &right) noexcept { return left + -right; }

private:
	template <class KeepsSign>
	[[nodiscard]] constexpr Sparse with_signs(KeepsSign keeps_sign) const noexcept {
		Sparse result = *this;
		for (int index = 0; index < BLADE_COUNT; ++index) {
			if (contains(SET, index) && !keeps_sign(blade_grade(index))) {
				T &coefficient = result.coefficients[slot_of(SET, index)];
				coefficient = -coefficient;
			}
		}
		return result;
	}
};

namespace detail {

template <class Kernel, size_t INDEX, class Result, class Left, class Right>
CGA_ALWAYS_INLINE constexpr void add_term(Result &result, const Left &left, const Right &right) noexcept {
	constexpr Term TERM = Kernel::TERMS[INDEX];
	if constexpr (TERM.sign > 0) {
		result.coefficients[TERM.result] += left.coefficients[TERM.left] * right.coefficients[TERM.right];
	} else {
		result.coefficients[TERM.result] -= left.coefficients[TERM.left] * right.coefficients[TERM.right];
	}
}

template <class Kernel, class Result, class Left, class Right, size_t... INDICES>
CGA_ALWAYS_INLINE constexpr void add_terms(Result &result, const Left &left, const Right &right, std::index_sequence<INDICES...>) noexcept {
	(add_term<Kernel, INDICES>(result, left, right), ...);
}

} // namespace detail

template <BladeSet RESULT, Product PRODUCT, BladeSet LEFT, BladeSet RIGHT, class T>
constexpr Sparse<RESULT, T> multiply_into(const Sparse<LEFT, T> &left, const Sparse<RIGHT, T> &right) noexcept {
	using Kernel = Kernel<PRODUCT, LEFT, RIGHT, RESULT>;
	Sparse<RESULT, T> result;
	detail::add_terms<Kernel>(result, left, right, std::make_index_sequence<Kernel::COUNT>());
	return result;
}

template <BladeSet SET, class T>
std::optional<Sparse<SET, T>> Sparse<SET, T>::from(const Multivector &x, double tolerance) {
	const Multivector::Coefficients null = to_null_coefficients(x);
	Sparse result;
	double included = 0.0, excluded = 0.0;
	for (int index = 0; index < BLADE_COUNT; ++index) {
		const double coefficient = null[size_t(index)];
		if (!std::isfinite(coefficient)) {
			return std::nullopt;
		}
		double &largest = contains(SET, index) ? included : excluded;
		largest = std::max(largest, std::abs(coefficient));
		if (contains(SET, index)) {
			result.coefficients[slot_of(SET, index)] = T(coefficient);
		}
	}
	return excluded <= tolerance * std::max(included, excluded) ? std::optional<Sparse>(result) : std::nullopt;
}

template <BladeSet SET, class T>
Multivector Sparse<SET, T>::to_multivector() const {
	Multivector::Coefficients null{};
	for (int index = 0; index < BLADE_COUNT; ++index) {
		if (contains(SET, index)) {
			null[size_t(index)] = double(coefficients[slot_of(SET, index)]);
		}
	}
	return from_null_coefficients(null);
}

} // namespace cga::typed
