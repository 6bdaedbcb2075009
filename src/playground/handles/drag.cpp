#include "playground/handles/drag.hpp"

#include "cga/motor/axis_angle.hpp"
#include "cga/motor/motor_factors.hpp"
#include "playground/drawing/motor_strokes.hpp"
#include "playground/drawing/placements.hpp"
#include "playground/handles/free_object.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace playground::handles {

namespace {

constexpr double TAU = 6.283185307179586;
constexpr std::string_view POSITIONS[] = { "position", "center", "point", "a", "b", "c", "d", "offset", "vector", "translation" };

std::optional<Drag> dragged_direction(const FreeObject &object, const Handle &start, const Vector &position, const Steps &steps) {
	Vector direction = glm::normalize(position - start.constraint.center);
	// The arm of a plane's normal points away from the origin, which may be opposite to the normal.
	if (start.key == "normal" && object.number("distance").value_or(0.0) < 0.0) {
		direction = -direction;
	}
	direction = rounded_direction(direction, steps.angle);
	if (object.can_set(start.key)) {
		return Drag{ start.key, direction };
	}
	// The axis of a rotation given as a quaternion.
	const cga::Quaternion<double> *rotation = object.rotation();
	if (start.key != "axis" || !rotation) {
		return std::nullopt;
	}
	return Drag{ "rotation", glm::angleAxis(cga::short_axis_angle(*rotation).angle, glm::normalize(direction)) };
}

std::optional<Drag> dragged_angle(const FreeObject &object, const Handle &start, const Vector &position, const Steps &steps) {
	const drawing::Placement frame = drawing::across(start.constraint.center, start.constraint.axis);
	const Vector arm = position - start.constraint.center;
	double angle = rounded(std::atan2(glm::dot(arm, frame.y), glm::dot(arm, frame.x)), steps.angle);
	if (const std::optional<double> old = object.number("angle"); old && object.can_set("angle")) {
		// Continue from the old angle, which may exceed a full rotation.
		angle += TAU * std::round((*old - angle) / TAU);
		return Drag{ "angle", angle };
	}
	return object.rotation() ? std::optional<Drag>(Drag{ "rotation", glm::angleAxis(angle, start.constraint.axis) }) : std::nullopt;
}

// Snaps to the grid. If the view direction is along an axis, the coordinate on that axis does not change.
Vector rounded_position(const Handle &start, const ViewRay &ray, const Vector &position, double step) {
	Vector on_grid = rounded(position, step);
	const double size = cga::detail::length(ray.view);
	for (int axis = 0; axis < 3; ++axis) {
		if (start.constraint.motion == Motion::FREE && std::abs(ray.view[axis]) > (1.0 - 1e-6) * size) {
			on_grid[axis] = start.constraint.position[axis];
		}
	}
	return on_grid;
}

std::optional<Drag> moved_object(const FreeObject &object, const Vector &position, const Vector &on_grid, const Steps &steps) {
	const cga::Classification &old = object.classification();
	const cga::Multivector *coefficients = object.coefficients();
	if (!coefficients) {
		return std::nullopt;
	}
	Vector offset(0.0);
	if (old.kind == cga::Kind::PLANE) {
		offset = *old.normal * (rounded(glm::dot(position, *old.normal), steps.length) - *old.distance);
	} else if (old.center) {
		offset = on_grid - *old.center;
	}
	// The dual and sign applied to the literal commute with the motion.
	const cga::Multivector motion = cga::translator(offset);
	return Drag{ "coefficients", motion.geometric_product(*coefficients).geometric_product(motion.reverse()) };
}

std::optional<Drag> dragged_length(const FreeObject &object, const Handle &start, const Vector &position, const Steps &steps) {
	if (!object.can_set(start.key)) {
		return std::nullopt;
	}
	const Vector &axis = start.constraint.axis;
	const bool is_coordinate = start.key == "x" || start.key == "y" || start.key == "z";
	if (is_coordinate || start.key == "distance") {
		return Drag{ start.key, rounded(glm::dot(position, axis), steps.length) };
	}
	// Radii and scales must be positive.
	const double length = glm::dot(position - start.stem, axis) / (start.key == "scale" ? drawing::FRAME_SIZE : 1.0);
	const double on_grid = std::max(rounded(length, steps.length), steps.length);
	return on_grid > 0.0 ? std::optional<Drag>(Drag{ start.key, on_grid }) : std::nullopt;
}

} // namespace

std::optional<Drag> drag(const Document &document, std::string_view name, const Handle &start, const ViewRay &ray, const Steps &steps) {
	const std::optional<FreeObject> object = FreeObject::find(document, name);
	Constraint grabbed = start.constraint;
	const bool has_grab_offset = grabbed.motion == Motion::FREE || grabbed.motion == Motion::LINE;
	if (has_grab_offset) {
		grabbed.position += start.grab;
	}
	std::optional<Vector> position = position_on(ray, grabbed);
	if (!object || !position) {
		return std::nullopt;
	}
	if (has_grab_offset) {
		*position -= start.grab;
	}
	std::optional<Drag> result;
	if (std::find(std::begin(POSITIONS), std::end(POSITIONS), start.key) != std::end(POSITIONS)) {
		result = object->can_set(start.key) ? std::optional<Drag>(Drag{ start.key, rounded_position(start, ray, *position, steps.length) }) : std::nullopt;
	} else if (start.key == "object") {
		result = moved_object(*object, *position, rounded_position(start, ray, *position, steps.length), steps);
	} else if (start.key == "angle") {
		result = dragged_angle(*object, start, *position, steps);
	} else if (grabbed.motion == Motion::SPHERE) {
		result = dragged_direction(*object, start, *position, steps);
	} else {
		result = dragged_length(*object, start, *position, steps);
	}
	return result && is_finite(result->value) ? result : std::nullopt;
}

} // namespace playground::handles
