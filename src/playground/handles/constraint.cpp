#include "playground/handles/constraint.hpp"

#include "cga/motor/axis_angle.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace playground::handles {

namespace {

using Position = std::optional<Vector>;

constexpr double TAU = 6.283185307179586;
// Directions count as parallel or perpendicular below this sine or cosine of their angle.
constexpr double MIN_SINE = 1e-6;

Position on_plane(const ViewRay &ray, const Constraint &constraint) {
	const double size = cga::detail::length(ray.view);
	if (!(size > 0.0)) {
		return std::nullopt;
	}
	const Vector normal = ray.view / size;
	const double cosine = glm::dot(ray.direction, normal);
	if (!(std::abs(cosine) > MIN_SINE)) {
		return std::nullopt;
	}
	const double depth = glm::dot(constraint.position - ray.origin, normal) / cosine;
	return depth > 0.0 ? Position(ray.origin + ray.direction * depth) : std::nullopt;
}

Position on_line(const ViewRay &ray, const Constraint &constraint) {
	const Vector &axis = constraint.axis;
	const double cosine = glm::dot(ray.direction, axis);
	const double across = 1.0 - cosine * cosine;
	if (!(across > MIN_SINE * MIN_SINE)) {
		return std::nullopt;
	}
	const Vector between = ray.origin - constraint.position;
	const double along = (glm::dot(between, axis) - cosine * glm::dot(between, ray.direction)) / across;
	const Vector position = constraint.position + axis * along;
	return glm::dot(position - ray.origin, ray.direction) > 0.0 ? Position(position) : std::nullopt;
}

Position on_sphere(const ViewRay &ray, const Constraint &constraint) {
	const double radius = glm::length(constraint.position - constraint.center);
	const Vector to_center = constraint.center - ray.origin;
	const double nearest = glm::dot(to_center, ray.direction);
	const Vector beside = ray.direction * nearest - to_center;
	const double distance = glm::length(beside);
	if (!(radius > 0.0)) {
		return std::nullopt;
	}
	if (distance >= radius) {
		return nearest > 0.0 ? Position(constraint.center + beside * (radius / distance)) : std::nullopt;
	}
	const double half = std::sqrt((radius - distance) * (radius + distance));
	const bool is_behind = glm::dot(constraint.position - constraint.center, ray.direction) > 0.0;
	const double depth = is_behind || nearest - half <= 0.0 ? nearest + half : nearest - half;
	return depth > 0.0 ? Position(ray.origin + ray.direction * depth) : std::nullopt;
}

// The distance between the ray and a point of the circle, as a function of its angle from the handle.
class CircleDistance {
public:
	CircleDistance(const ViewRay &ray, const Constraint &circle) :
			_ray(ray), _circle(circle), _x(circle.position - circle.center) {
		_x -= circle.axis * glm::dot(_x, circle.axis);
		_y = glm::cross(circle.axis, _x);
	}

	[[nodiscard]] double radius() const { return glm::length(_x); }
	[[nodiscard]] Vector point(double angle) const { return _circle.center + _x * std::cos(angle) + _y * std::sin(angle); }
	// Infinite for points behind the eye.
	[[nodiscard]] double at(double angle) const {
		const Vector to = point(angle) - _ray.origin;
		const double depth = glm::dot(to, _ray.direction);
		return depth > 0.0 ? glm::length(to - _ray.direction * depth) : HUGE_VAL;
	}
	// The angle of the local minimum within `step` of an angle, by ternary search.
	[[nodiscard]] double refined(double angle, double step) const {
		constexpr int REFINEMENTS = 90;
		double low = angle - step, high = angle + step;
		for (int i = 0; i < REFINEMENTS; ++i) {
			const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
			(at(a) < at(b) ? high : low) = at(a) < at(b) ? b : a;
		}
		return 0.5 * (low + high);
	}

private:
	const ViewRay &_ray;
	const Constraint &_circle;
	Vector _x, _y;
};

// A circle seen edge-on can have two points equally close to the ray: choose the one nearer to the handle.
Position on_circle(const ViewRay &ray, const Constraint &constraint) {
	const CircleDistance distance(ray, constraint);
	const double radius = distance.radius();
	if (!(radius > 0.0)) {
		return std::nullopt;
	}
	constexpr int SAMPLES = 128;
	constexpr double STEP = TAU / SAMPLES;
	double best_angle = 0.0, best = HUGE_VAL;
	for (int i = 0; i < SAMPLES; ++i) {
		// Search outward from the handle: 0, 1, -1, 2, -2, ...
		const int step = i % 2 == 1 ? (i + 1) / 2 : -i / 2;
		const double angle = STEP * step;
		const double here = distance.at(angle);
		if (!std::isfinite(here) || here > distance.at(angle - STEP) || here > distance.at(angle + STEP)) {
			continue;
		}
		const double refined = distance.refined(angle, STEP);
		if (distance.at(refined) < best - 1e-6 * radius) {
			best = distance.at(refined);
			best_angle = refined;
		}
	}
	return std::isfinite(best) ? Position(distance.point(best_angle)) : std::nullopt;
}

} // namespace

Position position_on(const ViewRay &ray, const Constraint &constraint) {
	const double length = cga::detail::length(ray.direction);
	if (!(length > 0.0) || !std::isfinite(length)) {
		return std::nullopt;
	}
	const ViewRay unit{ ray.origin, ray.direction / length, ray.view };
	Position position;
	switch (constraint.motion) {
		case Motion::FREE:
			position = on_plane(unit, constraint);
			break;
		case Motion::LINE:
			position = on_line(unit, constraint);
			break;
		case Motion::CIRCLE:
			position = on_circle(unit, constraint);
			break;
		case Motion::SPHERE:
			position = on_sphere(unit, constraint);
			break;
	}
	// NaN fails the comparison.
	return position && cga::detail::length(*position) <= MAX_DISTANCE ? position : std::nullopt;
}

} // namespace playground::handles
