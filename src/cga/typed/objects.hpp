#pragma once

#include "cga/typed/sparse.hpp"
#include "cga/vector.hpp"

// Objects (OPNS) as sparse elements, with the products of sparse.hpp:
//
//   Point<> a = point(x), b = point(y);            5 coefficients each
//   a.outer_product(b)                             a PointPair<>
//   a.outer_product(b).outer_product(infinity())   a Line<>
//   squared_distance(a, b)                         5 multiplications, and a division by the weights
//   s.regressive_product(t)                        the Circle<> in which two spheres meet, real or imaginary
//   moved(line, motor)                             a Line<> again (motion.hpp)
//
// Nothing is checked here. For input that may be degenerate or invalid, use Multivector with construct.hpp, incidence.hpp and
// classify.hpp.

namespace cga::typed {

// The null blades of a grade.
[[nodiscard]] constexpr BladeSet blades_of_grade(int grade) {
	BladeSet blades = 0;
	for (int index = 0; index < BLADE_COUNT; ++index) {
		blades |= BladeSet(blade_grade(index) == grade) << index;
	}
	return blades;
}

inline constexpr BladeSet INFINITY_BLADE = BladeSet(1) << E4;

// Rounds, and any other element of their grade: 5 or 10 coefficients.
template <int GRADE, class T = double>
using Round = Sparse<blades_of_grade(GRADE), T>;
// Elements of a grade with the factor e_inf: 4 or 6 coefficients.
template <int GRADE, class T = double>
using Flat = Sparse<product_blades(Product::OUTER, blades_of_grade(GRADE - 1), INFINITY_BLADE), T>;

template <class T = double>
using Point = Round<1, T>;
template <class T = double>
using PointPair = Round<2, T>;
template <class T = double>
using Circle = Round<3, T>;
template <class T = double>
using Sphere = Round<4, T>;
template <class T = double>
using FlatPoint = Flat<2, T>;
template <class T = double>
using Line = Flat<3, T>;
template <class T = double>
using Plane = Flat<4, T>;

// e_inf.
template <class T = double>
[[nodiscard]] constexpr Sparse<INFINITY_BLADE, T> infinity() noexcept {
	return { { T(1) } };
}

// e_o + c + (c^2 - r^2)/2 e_inf: the negated dual of a sphere; a point if r = 0.
template <class T>
[[nodiscard]] constexpr Round<1, T> dual_sphere(const Vector3<T> &center, T radius) noexcept {
	Round<1, T> result;
	result.template at<E1>() = center.x;
	result.template at<E2>() = center.y;
	result.template at<E3>() = center.z;
	result.template at<E4>() = (center.x * center.x + center.y * center.y + center.z * center.z - radius * radius) / T(2);
	result.template at<E5>() = T(1);
	return result;
}

// x + x^2/2 e_inf + e_o.
template <class T>
[[nodiscard]] constexpr Point<T> point(const Vector3<T> &position) noexcept {
	return dual_sphere(position, T(0));
}

template <class T>
[[nodiscard]] constexpr Sphere<T> sphere(const Vector3<T> &center, T radius) noexcept {
	return dual_sphere(center, radius).dual();
}

// All p with n . p = distance; `normal` of unit length. Its dual is -(n + distance e_inf).
template <class T>
[[nodiscard]] constexpr Plane<T> plane(const Vector3<T> &normal, T distance) noexcept {
	decltype(Plane<T>().dual()) dual;
	dual.template at<E1>() = normal.x;
	dual.template at<E2>() = normal.y;
	dual.template at<E3>() = normal.z;
	dual.template at<E4>() = distance;
	return dual.dual();
}

// The position of a point of any weight but zero.
template <class T>
[[nodiscard]] constexpr Vector3<T> position_of(const Point<T> &point) noexcept {
	return Vector3<T>(point.template at<E1>(), point.template at<E2>(), point.template at<E3>()) / point.template at<E5>();
}

// -2 a . b for points of any nonzero weight. Loses digits far from the origin, where the squares in a . b cancel.
template <class T>
[[nodiscard]] constexpr T squared_distance(const Point<T> &a, const Point<T> &b) noexcept {
	return T(-2) * a.scalar_product(b) / (a.template at<E5>() * b.template at<E5>());
}

// X e_inf X is the center, up to weight. Not defined for flats.
template <BladeSet BLADES, class T>
[[nodiscard]] constexpr Vector3<T> center(const Sparse<BLADES, T> &round) noexcept {
	return position_of(multiply_into<blades_of_grade(1), Product::GEOMETRIC>(round.geometric_product(infinity<T>()), round));
}

// X gradeinv(X) / (e_inf . X)^2; negative for imaginary rounds. Not defined for flats.
template <BladeSet BLADES, class T>
[[nodiscard]] constexpr T squared_radius(const Sparse<BLADES, T> &round) noexcept {
	const auto carrier = infinity<T>().left_contraction(round);
	return round.scalar_product(round.grade_involution()) / carrier.scalar_product(carrier);
}

} // namespace cga::typed
