#include "playground/drawing/placements.hpp"

#include <glm/geometric.hpp>

#include <cmath>

namespace playground::drawing {

namespace {

// A unit vector perpendicular to a unit vector, as documented at across().
Vector beside(const Vector &normal) {
	const Vector axis = std::abs(normal.x) < 0.9 ? Vector(1.0, 0.0, 0.0) : Vector(0.0, 0.0, 1.0);
	return glm::normalize(axis - normal * glm::dot(axis, normal));
}

} // namespace

Placement across(const Vector &origin, const Vector &normal) {
	const Vector x = beside(normal);
	return { x, glm::cross(normal, x), normal, origin };
}

Placement along(const Vector &origin, const Vector &direction) {
	const Vector y = beside(direction);
	return { direction, y, glm::cross(direction, y), origin };
}

Placement between(const Vector &center, const Vector &direction, double radius) {
	Placement placement = along(center, direction);
	placement.x *= radius;
	return placement;
}

Placement around(const Vector &center, const Vector &normal, double radius) {
	Vector outward = beside(normal);
	if (radius >= LARGE_RADIUS) {
		const Vector to_origin = -center + normal * glm::dot(center, normal);
		if (glm::length(to_origin) > 1e-9 * radius) {
			outward = glm::normalize(to_origin);
		}
	}
	return { glm::cross(normal, outward), normal, outward, center + radius * outward };
}

Placement on_sphere(const Vector &center, double radius) {
	Vector outward(0.0, 1.0, 0.0);
	if (radius >= LARGE_RADIUS && glm::length(center) > 1e-9 * radius) {
		outward = -glm::normalize(center);
	}
	return across(center + radius * outward, outward);
}

} // namespace playground::drawing
