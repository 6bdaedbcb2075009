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

namespace playground::drawing {

namespace {

using cga::Classification;
using cga::Kind;

constexpr double ENDLESS = 1e6, SIGN = 0.1;

bool is_finite(const Vector &v) {
	return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Coefficients hundreds of orders of magnitude apart leave the range of doubles on the way to a centre.
bool is_in_range(const Classification &found) {
	const Vector nothing(0.0);
	return is_finite(found.center.value_or(nothing)) && is_finite(found.normal.value_or(nothing)) && is_finite(found.direction.value_or(nothing)) && std::isfinite(found.radius.value_or(0.0)) && std::isfinite(found.distance.value_or(0.0));
}

// Of the sphere as in sphere(center, radius), R is -E123.
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
	if (const std::optional<MotorAxis> axis = axis_of(*pose)) {
		const Vector foot = axis->point - axis->direction * glm::dot(axis->point, axis->direction);
		figure.parts.push_back({ Form::line, along(foot, axis->direction), 1.0, true });
	}
	figure.parts.push_back({ Form::own, {}, 1.0, false });
	figure.own = motor_strokes(*pose);
	figure.label_place = pose->translation;
}

// The highest point of a circle.
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
	figure.label_place = center;
	switch (found.kind) {
		case Kind::POINT:
			figure.parts.push_back({ Form::point, across(center, { 0.0, 0.0, 1.0 }), 1.0, false });
			break;
		case Kind::FLAT_POINT:
			figure.parts.push_back({ Form::flat_point, across(center, { 0.0, 0.0, 1.0 }), 1.0, false });
			break;
		case Kind::POINT_PAIR:
			figure.parts.push_back({ Form::pair, between(center, *found.direction, radius), 1.0, false });
			figure.label_place = center + radius * *found.direction;
			break;
		case Kind::LINE:
			figure.parts.push_back({ Form::line, along(center, *found.direction), 1.0, false });
			break;
		case Kind::CIRCLE:
			figure.parts.push_back({ Form::ring, around(center, *found.normal, radius), radius, false });
			figure.label_place = radius < LARGE_RADIUS ? top_of(center, *found.normal, radius) : figure.parts[0].placement.origin;
			break;
		case Kind::SPHERE:
			figure.parts.push_back({ Form::globe, globe(center, radius), points_inward(x, found.ipns) ? -radius : radius, false });
			figure.label_place = figure.parts[0].placement.origin;
			break;
		case Kind::PLANE:
			figure.label_place = *found.normal * *found.distance;
			figure.parts.push_back({ Form::plane, across(*figure.label_place, *found.normal), 1.0, false });
			figure.parts.push_back({ Form::normal, across(*figure.label_place, *found.normal), 1.0, false });
			break;
		case Kind::TANGENT:
			figure.parts.push_back({ found.direction ? Form::tangent_along : Form::tangent_across, across(center, found.direction ? *found.direction : *found.normal), 1.0, false });
			break;
		case Kind::DIRECTION:
			if (found.direction || found.normal) {
				figure.parts.push_back({ found.direction ? Form::direction_along : Form::direction_across, across(center, found.direction ? *found.direction : *found.normal), 1.0, false });
			}
			break;
		case Kind::ROTOR:
		case Kind::TRANSLATOR:
		case Kind::DILATOR:
		case Kind::MOTOR:
			figure.dual = false;
			figure.label_place.reset();
			add_motor(figure, x);
			break;
		case Kind::SCALAR:
		case Kind::NONE:
			break;
	}
	if (figure.parts.empty()) {
		figure.label_place.reset();
	}
	return figure;
}

Box placed(const Box &box, const Placement &placement) {
	const Vector half = 0.5 * (box.greatest - box.least);
	const Vector middle = placement.apply(box.least + half);
	const Vector reach = glm::abs(placement.x) * half.x + glm::abs(placement.y) * half.y + glm::abs(placement.z) * half.z;
	return { middle - reach, middle + reach };
}

Placement placed(const Placement &inner, const Placement &space) {
	const auto turned = [&](const Vector &axis) {
		return space.x * axis.x + space.y * axis.y + space.z * axis.z;
	};
	return { turned(inner.x), turned(inner.y), turned(inner.z), space.apply(inner.origin) };
}

Box around_both(const Box &a, const Box &b) {
	return { glm::min(a.least, b.least), glm::max(a.greatest, b.greatest) };
}

bool contains(const Box &outer, const Box &inner) {
	return glm::all(glm::lessThanEqual(outer.least, inner.least)) && glm::all(glm::lessThanEqual(inner.greatest, outer.greatest));
}

Box box_of(const Part &part, const Strokes &own) {
	const double r = std::abs(part.radius);
	switch (part.form) {
		case Form::line:
		case Form::plane:
			return { Vector(-ENDLESS), Vector(ENDLESS) };
		case Form::ring:
			return { { -r, -SIGN, -2.0 * r }, { r, SIGN, 0.0 } };
		case Form::globe:
			return { { -1.2 * r, -1.2 * r, -2.2 * r }, { 1.2 * r, 1.2 * r, 0.2 * r } };
		case Form::pair:
			return { { -1.0, -SIGN, -SIGN }, { 1.0, SIGN, SIGN } };
		case Form::own: {
			Box box{ Vector(0.0), Vector(0.0) };
			for (const StrokeVertex &vertex : own.vertices) {
				box.least = glm::min(box.least, Vector(vertex.position));
				box.greatest = glm::max(box.greatest, Vector(vertex.position));
			}
			return box;
		}
		case Form::point:
		case Form::flat_point:
			return { Vector(-SIGN), Vector(SIGN) };
		default:
			return { Vector(-10.0 * SIGN), Vector(10.0 * SIGN) };
	}
}

} // namespace playground::drawing
