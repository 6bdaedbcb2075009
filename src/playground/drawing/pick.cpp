#include "playground/drawing/pick.hpp"

#include "playground/drawing/placements.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace playground::drawing {

namespace {

constexpr double TURN = 6.283185307179586;
constexpr int SAMPLES = 96, REFINEMENTS = 40;

std::optional<Touch> touch_point(const Vector &point, const PickRay &ray) {
	const Vector to = point - ray.origin;
	const double depth = glm::dot(to, ray.direction);
	const double pixel = ray.pixel(depth);
	if (depth <= 0.0 || !(pixel > 0.0)) {
		return std::nullopt;
	}
	return Touch{ glm::length(to - ray.direction * depth) / pixel, depth, false };
}

void keep_nearest(std::optional<Touch> &best, const std::optional<Touch> &other) {
	if (!other) {
		return;
	}
	// Lines and points within a few pixels go before surfaces.
	constexpr double REACH = 8.0;
	const auto rank = [](const Touch &touch) { return touch.on_surface ? REACH : touch.pixels; };
	if (!best || rank(*other) < rank(*best)) {
		best = other;
	}
}

// Of a curve with parameter `from`..`to`: sampled, then refined around the best sample.
template <class Curve>
std::optional<Touch> touch_curve(const Curve &curve, double from, double to, int samples, const PickRay &ray) {
	std::optional<Touch> best;
	const double step = (to - from) / samples;
	double at = from;
	for (int i = 0; i <= samples; ++i) {
		const std::optional<Touch> here = touch_point(curve(from + i * step), ray);
		if (here && (!best || here->pixels < best->pixels)) {
			best = here;
			at = from + i * step;
		}
	}
	if (!best) {
		return best;
	}
	double low = std::max(at - step, from), high = std::min(at + step, to);
	for (int i = 0; i < REFINEMENTS; ++i) {
		const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
		const std::optional<Touch> at_a = touch_point(curve(a), ray), at_b = touch_point(curve(b), ray);
		(at_a && (!at_b || at_a->pixels < at_b->pixels) ? high : low) = at_a && (!at_b || at_a->pixels < at_b->pixels) ? b : a;
	}
	const std::optional<Touch> refined = touch_point(curve(0.5 * (low + high)), ray);
	return refined && refined->pixels < best->pixels ? refined : best;
}

std::optional<Touch> touch_segment(const Vector &a, const Vector &b, const PickRay &ray) {
	const Vector along = b - a;
	return touch_curve([&](double s) { return a + along * s; }, 0.0, 1.0, 16, ray);
}

// Where the line comes nearest to the ray.
std::optional<Touch> touch_line(const Placement &line, const PickRay &ray) {
	const Vector between = line.origin - ray.origin;
	const double cosine = glm::dot(line.x, ray.direction);
	const double across = 1.0 - cosine * cosine;
	const double along_ray = glm::dot(between, ray.direction), along_line = glm::dot(between, line.x);
	if (across < 1e-12) {
		return touch_point(line.origin + line.x * (-along_line + 1e3), ray);
	}
	return touch_point(line.origin + line.x * ((cosine * along_ray - along_line) / across), ray);
}

// The angle is measured from the point nearest to the eye, and samples are denser there.
std::optional<Touch> touch_ring(const Part &part, const PickRay &ray) {
	const double radius = std::abs(part.radius);
	const Placement &at = part.placement;
	const Vector to = ray.origin - at.origin;
	const double nearest = std::atan2(glm::dot(to, at.x), glm::dot(to, at.z) + radius);
	const auto curve = [&](double s) {
		const double angle = nearest + 0.5 * TURN * s * std::abs(s), half_sine = std::sin(0.5 * angle);
		return at.origin + at.x * (radius * std::sin(angle)) - at.z * (2.0 * radius * half_sine * half_sine);
	};
	return touch_curve(curve, -1.0, 1.0, 4 * SAMPLES, ray);
}

std::optional<Touch> touch_globe(const Part &part, const PickRay &ray) {
	const double radius = std::abs(part.radius);
	const Vector to_anchor = part.placement.origin - ray.origin;
	const Vector to_center = to_anchor - part.placement.z * radius;
	const double depth = glm::dot(to_center, ray.direction);
	// |eye - centre|^2 - r^2 without the difference of large squares.
	const double power = glm::dot(to_anchor, to_anchor) - 2.0 * radius * glm::dot(to_anchor, part.placement.z);
	const double discriminant = depth * depth - power;
	if (discriminant >= 0.0) {
		const double root = std::sqrt(discriminant);
		const double enters = power > 0.0 ? power / (depth + root) : depth + root;
		if (depth <= 0.0 && power > 0.0) {
			return std::nullopt;
		}
		const std::optional<Touch> at = touch_point(ray.origin + ray.direction * enters, ray);
		return at ? std::optional<Touch>({ 0.0, enters, true }) : std::nullopt;
	}
	if (depth <= 0.0) {
		return std::nullopt;
	}
	return Touch{ (glm::length(to_center - ray.direction * depth) - radius) / ray.pixel(depth), depth, false };
}

std::optional<Touch> touch_plane(const Placement &plane, const PickRay &ray) {
	const double toward = glm::dot(ray.direction, plane.z);
	const double depth = glm::dot(plane.origin - ray.origin, plane.z) / toward;
	if (!std::isfinite(depth) || depth <= 0.0) {
		return std::nullopt;
	}
	return Touch{ 0.0, depth, true };
}

// Of forms that have a constant size on the screen.
std::optional<Touch> touch_sign(const Placement &at, double from, double to, const PickRay &ray) {
	const double pixel = ray.pixel(glm::dot(at.origin - ray.origin, ray.direction));
	return touch_segment(at.origin + at.z * (from * pixel), at.origin + at.z * (to * pixel), ray);
}

std::optional<Touch> touch_strokes(const Strokes &strokes, const Placement &at, const PickRay &ray) {
	std::optional<Touch> best;
	for (size_t i = 0; i + 2 < strokes.indices.size(); i += 3) {
		const Vector a = at.apply(Vector(strokes.vertices[size_t(strokes.indices[i])].position));
		const Vector b = at.apply(Vector(strokes.vertices[size_t(strokes.indices[i + 2])].position));
		keep_nearest(best, a == b ? touch_point(a, ray) : touch_segment(a, b, ray));
	}
	return best;
}

std::optional<Touch> touch_part(const Part &part, const Strokes &own, const PickRay &ray) {
	const Placement &at = part.placement;
	switch (part.form) {
		case Form::pair:
			return touch_segment(at.origin - at.x, at.origin + at.x, ray);
		case Form::line:
			return touch_line(at, ray);
		case Form::ring:
			return touch_ring(part, ray);
		case Form::globe:
			return touch_globe(part, ray);
		case Form::plane:
			return touch_plane(at, ray);
		case Form::normal:
		case Form::tangent_along:
			return touch_sign(at, 0.0, 36.0, ray);
		case Form::direction_along:
			return touch_sign(at, -26.0, 26.0, ray);
		case Form::own:
			return touch_strokes(own, at, ray);
		default:
			return touch_point(at.origin, ray);
	}
}

} // namespace

std::optional<Touch> touch(const Figure &figure, const PickRay &ray) {
	std::optional<Touch> best;
	for (const Part &part : figure.parts) {
		keep_nearest(best, touch_part(part, figure.own, ray));
	}
	return best;
}

} // namespace playground::drawing
