#include "cga/object/construct.hpp"

#include "cga/object/conformal_parts.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cga {

namespace {

using Vector = Vector3<double>;

// Differences of positions below this, relative to the positions, are rounding.
constexpr double ROUNDING = 16.0 * std::numeric_limits<double>::epsilon();

double largest(const Vector &v) {
	return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

bool is_finite(const Vector &v) {
	return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Empty for zero and vectors that are not finite. Scales first, so that no square overflows or underflows.
std::optional<Vector> unit(const Vector &v) {
	const double size = largest(v);
	if (!(size > 0.0) || !std::isfinite(size)) {
		return std::nullopt;
	}
	return glm::normalize(v / size);
}

bool coincide(const Vector &a, const Vector &b) {
	return largest(b - a) <= ROUNDING * std::max(largest(a), largest(b));
}

MultivectorResult checked(const Multivector &x) {
	if (!x.is_finite()) {
		return AlgebraError::OBJECT_OVERFLOW;
	}
	return x;
}

Multivector volume() {
	return Multivector::basis_blade(E123);
}

// The round with this attitude, or the error.
template <class Attitude>
MultivectorResult round_of(const Vector &center, const Vector &axis, double radius, double sign, Attitude attitude) {
	const std::optional<Vector> u = unit(axis);
	if (!is_finite(center) || !is_finite(axis)) {
		return AlgebraError::NOT_FINITE;
	}
	if (!u) {
		return AlgebraError::ZERO_DIRECTION;
	}
	if (!(radius > 0.0) || !std::isfinite(radius)) {
		return AlgebraError::RADIUS_NOT_POSITIVE;
	}
	return checked(round_blade(center, attitude(*u), sign * radius * radius));
}

template <class Attitude>
MultivectorResult tangent_of(const Vector &position, const Vector &axis, Attitude attitude) {
	const std::optional<Vector> u = unit(axis);
	if (!is_finite(position) || !is_finite(axis)) {
		return AlgebraError::NOT_FINITE;
	}
	return u ? checked(round_blade(position, attitude(*u), 0.0)) : AlgebraError::ZERO_DIRECTION;
}

// Constructed relative to a point on it and then translated, so that even a very large round passes through its points.
MultivectorResult round_through(const Vector &a, const Vector &to_center, const Multivector &attitude) {
	return checked(from_parts(round_parts(translated(RoundParameters{ to_center, {}, attitude, 0.0 }, a))));
}

Multivector along(const Vector &u) {
	return euclidean(u);
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
	if (!is_finite(a) || !is_finite(b)) {
		return AlgebraError::NOT_FINITE;
	}
	if (coincide(a, b)) {
		return AlgebraError::COINCIDENT_POINTS;
	}
	const Vector half = 0.5 * (b - a);
	return checked(round_blade(a + half, euclidean(b - a), glm::dot(half, half)));
}

MultivectorResult line(const Vector &position, const Vector &direction) {
	const std::optional<Vector> u = unit(direction);
	if (!is_finite(position) || !is_finite(direction)) {
		return AlgebraError::NOT_FINITE;
	}
	return u ? checked(flat_blade(position, euclidean(*u))) : AlgebraError::ZERO_DIRECTION;
}

MultivectorResult line_through(const Vector &a, const Vector &b) {
	if (!is_finite(a) || !is_finite(b)) {
		return AlgebraError::NOT_FINITE;
	}
	return coincide(a, b) ? AlgebraError::COINCIDENT_POINTS : checked(flat_blade(a, euclidean(b - a)));
}

MultivectorResult circle(const Vector &center, const Vector &normal, double radius) {
	return round_of(center, normal, radius, 1.0, plane_across);
}

// With u = b - a, v = c - a, n = u x v: center - a = (v^2 n x u + u^2 v x n) / (2 n^2).
MultivectorResult circle_through(const Vector &a, const Vector &b, const Vector &c) {
	if (!is_finite(a) || !is_finite(b) || !is_finite(c)) {
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
	const std::optional<Vector> n = unit(normal);
	if (!is_finite(normal) || !std::isfinite(distance)) {
		return AlgebraError::NOT_FINITE;
	}
	if (!n) {
		return AlgebraError::ZERO_DIRECTION;
	}
	return checked(from_parts({ {}, volume() * distance, {}, -plane_across(*n) }));
}

MultivectorResult plane_through(const Vector &a, const Vector &b, const Vector &c) {
	if (!is_finite(a) || !is_finite(b) || !is_finite(c)) {
		return AlgebraError::NOT_FINITE;
	}
	const Vector u = b - a, v = c - a, n = glm::cross(u, v);
	if (largest(n) <= area_rounding(a, u, v)) {
		return AlgebraError::COLLINEAR_POINTS;
	}
	return checked(flat_blade(a, plane_across(n)));
}

MultivectorResult sphere(const Vector &center, double radius) {
	return round_of(center, Vector(1.0, 0.0, 0.0), radius, 1.0, [](const Vector &) { return volume(); });
}

// With u, v, w from a to the others and V = u . (v x w): center - a = (u^2 v x w + v^2 w x u + w^2 u x v) / (2 V).
MultivectorResult sphere_through(const Vector &a, const Vector &b, const Vector &c, const Vector &d) {
	if (!is_finite(a) || !is_finite(b) || !is_finite(c) || !is_finite(d)) {
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
	return round_of(center, direction, radius, -1.0, along);
}

MultivectorResult imaginary_circle(const Vector &center, const Vector &normal, double radius) {
	return round_of(center, normal, radius, -1.0, plane_across);
}

MultivectorResult imaginary_sphere(const Vector &center, double radius) {
	return round_of(center, Vector(1.0, 0.0, 0.0), radius, -1.0, [](const Vector &) { return volume(); });
}

MultivectorResult tangent_along(const Vector &position, const Vector &direction) {
	return tangent_of(position, direction, along);
}

MultivectorResult tangent_across(const Vector &position, const Vector &normal) {
	return tangent_of(position, normal, plane_across);
}

MultivectorResult direction(const Vector &vector) {
	const std::optional<Vector> u = unit(vector);
	if (!u) {
		return is_finite(vector) ? AlgebraError::ZERO_DIRECTION : AlgebraError::NOT_FINITE;
	}
	return from_parts({ {}, euclidean(*u), {}, {} });
}

MultivectorResult direction_across(const Vector &normal) {
	const std::optional<Vector> n = unit(normal);
	if (!n) {
		return is_finite(normal) ? AlgebraError::ZERO_DIRECTION : AlgebraError::NOT_FINITE;
	}
	return from_parts({ {}, plane_across(*n), {}, {} });
}

} // namespace cga
