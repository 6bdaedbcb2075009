#pragma once

#include "cga/motor/motor.hpp"
#include "cga/motor/motor_packing.hpp"
#include "cga/typed/sparse.hpp"

// Motors applied to typed elements: M X M^-1 with the twelve coefficients of M.

namespace cga::typed {

// The generators of motors: e12, e13, e23 (rotation), e1, e2, e3 ^ e_inf (translation), E (dilation).
inline constexpr BladeSet GENERATORS = [] {
	BladeSet blades = 0;
	for (const int index : { E12, E13, E23, E14, E24, E34, E45 }) {
		blades |= BladeSet(1) << index;
	}
	return blades;
}();

inline constexpr BladeSet MOTOR_BLADES = product_blades(Product::GEOMETRIC, GENERATORS | 1u, GENERATORS | 1u);
static_assert(product_blades(Product::GEOMETRIC, MOTOR_BLADES, MOTOR_BLADES) == MOTOR_BLADES, "motors are closed under multiplication");

template <class T = double>
using Versor = Sparse<MOTOR_BLADES, T>;

// Whether motors map elements of a set of blades to the same set: true if the commutator with each generator does.
[[nodiscard]] constexpr bool is_closed_under_motors(BladeSet set) {
	return (product_blades(Product::COMMUTATOR, GENERATORS, set) & ~set) == 0;
}

namespace detail {

template <size_t... I, class T>
[[nodiscard]] constexpr Versor<T> unpacked(const Motor<T> &motor, std::index_sequence<I...>) noexcept {
	const T a[] = { motor.a.w, motor.a.x, motor.a.y, motor.a.z };
	const T b[] = { motor.b.w, motor.b.x, motor.b.y, motor.b.z };
	const T v[] = { motor.v.w, motor.v.x, motor.v.y, motor.v.z };
	Versor<T> result;
	((result.template at<MOTOR_PAIRS[I].euclidean>() = T(0.5 * MOTOR_PAIRS[I].sign) * (a[I] + b[I])), ...);
	((result.template at<MOTOR_PAIRS[I].with_e45>() = T(0.5 * MOTOR_PAIRS[I].sign) * (a[I] - b[I])), ...);
	((result.template at<MOTOR_NULL_PAIRS[I].with_e4>() = v[I]), ...);
	return result;
}

} // namespace detail

template <class T>
[[nodiscard]] constexpr Versor<T> versor(const Motor<T> &motor) noexcept {
	return detail::unpacked(motor, std::make_index_sequence<4>());
}

// M x M^-1. The weight of the motor must not be zero.
template <BladeSet BLADES, class T>
[[nodiscard]] Sparse<BLADES, T> moved(const Sparse<BLADES, T> &x, const Motor<T> &motor) noexcept {
	static_assert(is_closed_under_motors(BLADES), "motors do not preserve this type; use a Round or a Flat");
	const Versor<T> m = versor(motor);
	return multiply_into<BLADES, Product::GEOMETRIC>(m.geometric_product(x), m.reverse()) * (T(1) / motor.norm_squared());
}

} // namespace cga::typed
