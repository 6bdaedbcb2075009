#include "playground/drawing/figure.hpp"

#include "cga/motor/motor_multivector.hpp"
#include "cga/object/classify.hpp"
#include "cga/object/conformal_parts.hpp"
#include "playground/drawing/motor_strokes.hpp"
#include "playground/drawing/placements.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace playground::drawing {

namespace {

using cga::Classification;
using cga::Kind;

constexpr double UNBOUNDED = 1e6, MARKER_SIZE = 0.1; // meters

bool is_finite(const Vector &v) {
	return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// False if coefficients that differ by hundreds of orders of magnitude overflowed in the classification.
bool is_in_range(const Classification &found) {
	const Vector nothing(0.0);
	return is_finite(found.center.value_or(nothing)) && is_finite(found.normal.value_or(nothing)) && is_finite(found.direction.value_or(nothing)) && std::isfinite(found.radius.value_or(0.0)) && std::isfinite(found.distance.value_or(0.0));
}

// The `origin` part of sphere(center, radius) is -E123; that of the opposite orientation is +E123.
bool points_inward(const cga::Multivector &x, bool ipns) {
	return cga::parts_of(ipns ? x.undual() : x).origin[cga::E123] > 0.0;
}

void add_motor(Figure &figure, const cga::Multivector &x) {
	const cga::Multivector scaled = x.times_power_of_two(-std::ilogb(x.max_abs()));
	const std::optional<cga::Motor<double>> motor = cga::to_motor(scaled);
	const std::optional<cga::Pose<double>> pose = motor ? motor->to_pose() : std::nullopt;
	if (!pose || !is_finite(pose->translation) || !std::isfinite(pose->scale)) {
		return;
	}
	Strokes strokes = motor_strokes(*pose);
	// Their vertices have single precision: a motor beyond its range is not drawn.
	if (!std::all_of(strokes.vertices.begin(), strokes.vertices.end(), [](const StrokeVertex &vertex) { return is_finite(Vector(vertex.position)) && is_finite(Vector(vertex.tangent)) && std::isfinite(vertex.arc); })) {
		return;
	}
	if (const std::optional<MotorAxis> axis = axis_of(*pose)) {
		const Vector foot = axis->point - axis->direction * glm::dot(axis->point, axis->direction);
		figure.parts.push_back({ Form::LINE, along(foot, axis->direction), 1.0, true });
	}
	figure.parts.push_back({ Form::CUSTOM, {}, 1.0, false });
	figure.custom = std::move(strokes);
	figure.label_position = pose->translation;
}

// The highest point of a circle; an arbitrary point of a horizontal circle.
Vector top_of(const Vector &center, const Vector &normal, double radius) {
	Vector up = Vector(0.0, 1.0, 0.0) - normal * normal.y;
	up = glm::length(up) > 1e-3 ? glm::normalize(up) : Vector(1.0, 0.0, 0.0);
	return center + radius * up;
}

} // namespace

Figure figure_of(const cga::Multivector &x, bool ipns) {
	const Classification found = cga::classify(x, ipns);
	Figure figure;
	if (!is_in_range(found)) {
		return figure;
	}
	figure.imaginary = found.imaginary;
	figure.dual = found.ipns;
	const Vector center = found.center.value_or(Vector(0.0));
	const double radius = found.radius.value_or(1.0);
	figure.label_position = center;
	switch (found.kind) {
		case Kind::POINT:
			figure.parts.push_back({ Form::POINT, across(center, { 0.0, 0.0, 1.0 }), 1.0, false });
			break;
		case Kind::FLAT_POINT:
			figure.parts.push_back({ Form::FLAT_POINT, across(center, { 0.0, 0.0, 1.0 }), 1.0, false });
			break;
		case Kind::POINT_PAIR:
			figure.parts.push_back({ Form::POINT_PAIR, between(center, *found.direction, radius), 1.0, false });
			figure.label_position = center + radius * *found.direction;
			break;
		case Kind::LINE:
			figure.parts.push_back({ Form::LINE, along(center, *found.direction), 1.0, false });
			break;
		case Kind::CIRCLE:
			figure.parts.push_back({ Form::CIRCLE, around(center, *found.normal, radius), radius, false });
			figure.label_position = radius < LARGE_RADIUS ? top_of(center, *found.normal, radius) : figure.parts[0].placement.origin;
			break;
		case Kind::SPHERE:
			figure.parts.push_back({ Form::SPHERE, on_sphere(center, radius), points_inward(x, found.ipns) ? -radius : radius, false });
			figure.label_position = figure.parts[0].placement.origin;
			break;
		case Kind::PLANE:
			figure.label_position = *found.normal * *found.distance;
			figure.parts.push_back({ Form::PLANE, across(*figure.label_position, *found.normal), 1.0, false });
			figure.parts.push_back({ Form::NORMAL, across(*figure.label_position, *found.normal), 1.0, false });
			break;
		case Kind::TANGENT:
			figure.parts.push_back({ found.direction ? Form::TANGENT_ALONG : Form::TANGENT_ACROSS, across(center, found.direction ? *found.direction : *found.normal), 1.0, false });
			break;
		case Kind::DIRECTION:
			if (found.direction || found.normal) {
				figure.parts.push_back({ found.direction ? Form::DIRECTION_ALONG : Form::DIRECTION_ACROSS, across(center, found.direction ? *found.direction : *found.normal), 1.0, false });
			}
			break;
		case Kind::ROTOR:
		case Kind::TRANSLATOR:
		case Kind::DILATOR:
		case Kind::MOTOR:
			figure.dual = false;
			figure.label_position.reset();
			add_motor(figure, x);
			break;
		case Kind::SCALAR:
		case Kind::NONE:
			break;
	}
	if (figure.parts.empty()) {
		figure.label_position.reset();
	}
	return figure;
}

Box placed(const Box &box, const Placement &placement) {
	const Vector half = 0.5 * (box.max - box.min);
	const Vector center = placement.apply(box.min + half);
	const Vector reach = glm::abs(placement.x) * half.x + glm::abs(placement.y) * half.y + glm::abs(placement.z) * half.z;
	return { center - reach, center + reach };
}

Placement placed(const Placement &inner, const Placement &space) {
	const auto rotated = [&](const Vector &axis) {
		return space.x * axis.x + space.y * axis.y + space.z * axis.z;
	};
	return { rotated(inner.x), rotated(inner.y), rotated(inner.z), space.apply(inner.origin) };
}

Box merged(const Box &a, const Box &b) {
	return { glm::min(a.min, b.min), glm::max(a.max, b.max) };
}

bool contains(const Box &outer, const Box &inner) {
	return glm::all(glm::lessThanEqual(outer.min, inner.min)) && glm::all(glm::lessThanEqual(inner.max, outer.max));
}

Box bounds_of(const Part &part, const Strokes &custom) {
	constexpr double MAX_RADIUS = 1e30; // so that the box is finite in single precision, too
	const double r = std::min(std::abs(part.radius), MAX_RADIUS);
	switch (part.form) {
		case Form::LINE:
		case Form::PLANE:
			return { Vector(-UNBOUNDED), Vector(UNBOUNDED) };
		case Form::CIRCLE:
			return { { -r, -MARKER_SIZE, -2.0 * r }, { r, MARKER_SIZE, 0.0 } };
		case Form::SPHERE:
			return { { -1.2 * r, -1.2 * r, -2.2 * r }, { 1.2 * r, 1.2 * r, 0.2 * r } };
		case Form::POINT_PAIR:
			return { { -1.0, -MARKER_SIZE, -MARKER_SIZE }, { 1.0, MARKER_SIZE, MARKER_SIZE } };
		case Form::CUSTOM: {
			Box box{ Vector(0.0), Vector(0.0) };
			for (const StrokeVertex &vertex : custom.vertices) {
				box.min = glm::min(box.min, Vector(vertex.position));
				box.max = glm::max(box.max, Vector(vertex.position));
			}
			return box;
		}
		case Form::POINT:
		case Form::FLAT_POINT:
			return { Vector(-MARKER_SIZE), Vector(MARKER_SIZE) };
		default:
			return { Vector(-10.0 * MARKER_SIZE), Vector(10.0 * MARKER_SIZE) };
	}
}

} // namespace playground::drawing
