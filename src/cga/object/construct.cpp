#include "cga/object/construct.hpp"

#include "cga/object/conformal_parts.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cga {

namespace {

using Vector = Vector3<double>;

// Differences of positions below this, relative to the positions, are rounding.
constexpr double ROUNDING = 16.0 * std::numeric_limits<double>::epsilon();

double largest(const Vector &v) {
	return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

template <class... Vectors>
bool are_finite(const Vectors &...vectors) {
	return (is_finite(vectors) && ...);
}

bool coincide(const Vector &a, const Vector &b) {
	return largest(b - a) <= ROUNDING * std::max(largest(a), largest(b));
}

MultivectorResult checked(const Multivector &x) {
	return x.is_finite() ? MultivectorResult(x) : AlgebraError::OBJECT_OVERFLOW;
}

Multivector volume() {
	return Multivector::basis_blade(E123);
}

// The result of `construct` for the unit vector along `axis`, or the error. `other` is the rest of the input: it must be finite.
template <class Construct>
MultivectorResult with_unit(const Vector &axis, const Vector &other, Construct construct) {
	if (!are_finite(axis, other)) {
		return AlgebraError::NOT_FINITE;
	}
	// Scaled first, so that no square overflows or underflows.
	const double size = largest(axis);
	return size > 0.0 ? construct(glm::normalize(axis / size)) : AlgebraError::ZERO_DIRECTION;
}

// `sign` is the sign of the squared radius.
MultivectorResult round_of(const Vector &center, const Multivector &attitude, double radius, double sign) {
	if (!is_finite(center)) {
		return AlgebraError::NOT_FINITE;
	}
	if (!(radius > 0.0) || !std::isfinite(radius)) {
		return AlgebraError::RADIUS_NOT_POSITIVE;
	}
	return checked(round_blade(center, attitude, sign * radius * radius));
}

MultivectorResult circle_of(const Vector &center, const Vector &normal, double radius, double sign) {
	return with_unit(normal, center, [&](const Vector &n) { return round_of(center, plane_across(n), radius, sign); });
}

// Constructed relative to a point on it and then translated, so that even a very large round passes through its points.
MultivectorResult round_through(const Vector &a, const Vector &to_center, const Multivector &attitude) {
	return checked(from_parts(round_parts(translated(RoundParameters{ to_center, {}, attitude, 0.0 }, a))));
}

// A bound on the rounding error of u x v, u and v being differences of points near a.
double area_rounding(const Vector &a, const Vector &u, const Vector &v) {
	const double size = std::max(largest(u), largest(v));
	return ROUNDING * size * (largest(a) + size);
}

} // namespace

MultivectorResult flat_point(const Vector &position) {
	if (!is_finite(position)) {
		return AlgebraError::NOT_FINITE;
	}
	return checked(flat_blade(position, Multivector::scalar(1.0)));
}

MultivectorResult point_pair(const Vector &a, const Vector &b) {
	if (!are_finite(a, b)) {
		return AlgebraError::NOT_FINITE;
	}
	if (coincide(a, b)) {
		return AlgebraError::COINCIDENT_POINTS;
	}
	const Vector half = 0.5 * (b - a);
	return checked(round_blade(a + half, euclidean(b - a), glm::dot(half, half)));
}

MultivectorResult line(const Vector &position, const Vector &direction) {
	return with_unit(direction, position, [&](const Vector &u) { return checked(flat_blade(position, euclidean(u))); });
}

MultivectorResult line_through(const Vector &a, const Vector &b) {
	if (!are_finite(a, b)) {
		return AlgebraError::NOT_FINITE;
	}
	return coincide(a, b) ? AlgebraError::COINCIDENT_POINTS : checked(flat_blade(a, euclidean(b - a)));
}

MultivectorResult circle(const Vector &center, const Vector &normal, double radius) {
	return circle_of(center, normal, radius, 1.0);
}

// With u = b - a, v = c - a, n = u x v: center - a = (v^2 n x u + u^2 v x n) / (2 n^2).
MultivectorResult circle_through(const Vector &a, const Vector &b, const Vector &c) {
	if (!are_finite(a, b, c)) {
		return AlgebraError::NOT_FINITE;
	}
	if (coincide(a, b) || coincide(a, c) || coincide(b, c)) {
		return AlgebraError::COINCIDENT_POINTS;
	}
	const Vector u = b - a, v = c - a, n = glm::cross(u, v);
	if (largest(n) <= area_rounding(a, u, v)) {
		return line_through(a, glm::dot(u, u) >= glm::dot(v, v) ? b : c);
	}
	const Vector to_center = (glm::dot(v, v) * glm::cross(n, u) + glm::dot(u, u) * glm::cross(v, n)) / (2.0 * glm::dot(n, n));
	return round_through(a, to_center, plane_across(n));
}

MultivectorResult plane(const Vector &normal, double distance) {
	return with_unit(normal, Vector(distance), [&](const Vector &n) { return checked(from_parts({ {}, volume() * distance, {}, -plane_across(n) })); });
}

MultivectorResult plane_through(const Vector &a, const Vector &b, const Vector &c) {
	if (!are_finite(a, b, c)) {
		return AlgebraError::NOT_FINITE;
	}
	const Vector u = b - a, v = c - a, n = glm::cross(u, v);
	if (largest(n) <= area_rounding(a, u, v)) {
		return AlgebraError::COLLINEAR_POINTS;
	}
	return checked(flat_blade(a, plane_across(n)));
}

MultivectorResult sphere(const Vector &center, double radius) {
	return round_of(center, volume(), radius, 1.0);
}

// With u, v, w from a to the others and V = u . (v x w): center - a = (u^2 v x w + v^2 w x u + w^2 u x v) / (2 V).
MultivectorResult sphere_through(const Vector &a, const Vector &b, const Vector &c, const Vector &d) {
	if (!are_finite(a, b, c, d)) {
		return AlgebraError::NOT_FINITE;
	}
	if (coincide(a, b) || coincide(a, c) || coincide(a, d) || coincide(b, c) || coincide(b, d) || coincide(c, d)) {
		return AlgebraError::COINCIDENT_POINTS;
	}
	const double size = std::max({ largest(b - a), largest(c - a), largest(d - a) });
	const Vector u = (b - a) / size, v = (c - a) / size, w = (d - a) / size;
	const double rounding = ROUNDING * (1.0 + largest(a) / size);
	const double volume_of_edges = glm::dot(u, glm::cross(v, w));
	const Vector across = glm::dot(u, u) * glm::cross(v, w) + glm::dot(v, v) * glm::cross(w, u) + glm::dot(w, w) * glm::cross(u, v);
	if (std::abs(volume_of_edges) > rounding) {
		const Vector to_center = across * (size / (2.0 * volume_of_edges));
		return round_through(a, to_center, volume() * (volume_of_edges * size * size * size));
	}
	if (largest(across) <= rounding) {
		return AlgebraError::CONCYCLIC_POINTS;
	}
	return checked(flat_blade(a, plane_across(across * (0.5 * std::pow(size, 4.0)))));
}

MultivectorResult imaginary_point_pair(const Vector &center, const Vector &direction, double radius) {
	return with_unit(direction, center, [&](const Vector &u) { return round_of(center, euclidean(u), radius, -1.0); });
}

MultivectorResult imaginary_circle(const Vector &center, const Vector &normal, double radius) {
	return circle_of(center, normal, radius, -1.0);
}

MultivectorResult imaginary_sphere(const Vector &center, double radius) {
	return round_of(center, volume(), radius, -1.0);
}

MultivectorResult tangent_along(const Vector &position, const Vector &direction) {
	return with_unit(direction, position, [&](const Vector &u) { return checked(round_blade(position, euclidean(u), 0.0)); });
}

MultivectorResult tangent_across(const Vector &position, const Vector &normal) {
	return with_unit(normal, position, [&](const Vector &n) { return checked(round_blade(position, plane_across(n), 0.0)); });
}

MultivectorResult direction(const Vector &vector) {
	return with_unit(vector, Vector(0.0), [](const Vector &u) { return checked(from_parts({ {}, euclidean(u), {}, {} })); });
}

MultivectorResult direction_across(const Vector &normal) {
	return with_unit(normal, Vector(0.0), [](const Vector &n) { return checked(from_parts({ {}, plane_across(n), {}, {} })); });
}

} // namespace cga
