#include "playground/handles/constraint.hpp"

#include "cga/motor/axis_angle.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace playground::handles {

namespace {

using Place = std::optional<Vector>;

constexpr double TURN = 6.283185307179586;
// Of the sine or cosine of an angle between directions: below it they count as along or across each other.
constexpr double MIN_SINE = 1e-6;

Place on_plane(const ViewRay &ray, const Constraint &constraint) {
	const double size = cga::detail::length(ray.view);
	if (!(size > 0.0)) {
		return std::nullopt;
	}
	const Vector normal = ray.view / size;
	const double cosine = glm::dot(ray.direction, normal);
	if (!(std::abs(cosine) > MIN_SINE)) {
		return std::nullopt;
	}
	const double depth = glm::dot(constraint.place - ray.origin, normal) / cosine;
	return depth > 0.0 ? Place(ray.origin + ray.direction * depth) : std::nullopt;
}

Place on_line(const ViewRay &ray, const Constraint &constraint) {
	const Vector &axis = constraint.axis;
	const double cosine = glm::dot(ray.direction, axis);
	const double across = 1.0 - cosine * cosine;
	if (!(across > MIN_SINE * MIN_SINE)) {
		return std::nullopt;
	}
	const Vector between = ray.origin - constraint.place;
	const double along = (glm::dot(between, axis) - cosine * glm::dot(between, ray.direction)) / across;
	const Vector place = constraint.place + axis * along;
	return glm::dot(place - ray.origin, ray.direction) > 0.0 ? Place(place) : std::nullopt;
}

Place on_sphere(const ViewRay &ray, const Constraint &constraint) {
	const double radius = glm::length(constraint.place - constraint.center);
	const Vector to_center = constraint.center - ray.origin;
	const double nearest = glm::dot(to_center, ray.direction);
	const Vector beside = ray.direction * nearest - to_center;
	const double distance = glm::length(beside);
	if (!(radius > 0.0)) {
		return std::nullopt;
	}
	if (distance >= radius) {
		return nearest > 0.0 ? Place(constraint.center + beside * (radius / distance)) : std::nullopt;
	}
	const double half = std::sqrt((radius - distance) * (radius + distance));
	const bool is_behind = glm::dot(constraint.place - constraint.center, ray.direction) > 0.0;
	const double depth = is_behind || nearest - half <= 0.0 ? nearest + half : nearest - half;
	return depth > 0.0 ? Place(ray.origin + ray.direction * depth) : std::nullopt;
}

// The distance of a circle's points to the ray, by their angle from where the handle is.
class CircleDistance {
public:
	CircleDistance(const ViewRay &ray, const Constraint &circle) :
			_ray(ray), _circle(circle), _x(circle.place - circle.center) {
		_x -= circle.axis * glm::dot(_x, circle.axis);
		_y = glm::cross(circle.axis, _x);
	}

	[[nodiscard]] double radius() const { return glm::length(_x); }
	[[nodiscard]] Vector place(double angle) const { return _circle.center + _x * std::cos(angle) + _y * std::sin(angle); }
	// Infinite behind the eye.
	[[nodiscard]] double at(double angle) const {
		const Vector to = place(angle) - _ray.origin;
		const double depth = glm::dot(to, _ray.direction);
		return depth > 0.0 ? glm::length(to - _ray.direction * depth) : HUGE_VAL;
	}
	// The least one near an angle.
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

// A circle seen from the side is met twice: what counts is then the place nearer to the one where it is.
Place on_circle(const ViewRay &ray, const Constraint &constraint) {
	const CircleDistance distance(ray, constraint);
	const double radius = distance.radius();
	if (!(radius > 0.0)) {
		return std::nullopt;
	}
	constexpr int SAMPLES = 128;
	constexpr double STEP = TURN / SAMPLES;
	double best_angle = 0.0, best = HUGE_VAL;
	for (int i = 0; i < SAMPLES; ++i) {
		// 0, 1, -1, 2, -2, ...
		const double angle = STEP * ((i + 1) / 2) * (i % 2 == 1 ? 1 : -1);
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
	return std::isfinite(best) ? Place(distance.place(best_angle)) : std::nullopt;
}

} // namespace

Place place_under(const ViewRay &ray, const Constraint &constraint) {
	const double length = cga::detail::length(ray.direction);
	if (!(length > 0.0) || !std::isfinite(length)) {
		return std::nullopt;
	}
	const ViewRay unit{ ray.origin, ray.direction / length, ray.view };
	Place place;
	switch (constraint.motion) {
		case Motion::FREE:
			place = on_plane(unit, constraint);
			break;
		case Motion::LINE:
			place = on_line(unit, constraint);
			break;
		case Motion::CIRCLE:
			place = on_circle(unit, constraint);
			break;
		case Motion::SPHERE:
			place = on_sphere(unit, constraint);
			break;
	}
	// Written so that NaN is none.
	return place && cga::detail::length(*place) <= FARTHEST ? place : std::nullopt;
}

} // namespace playground::handles
