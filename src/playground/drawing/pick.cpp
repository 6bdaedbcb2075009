#include "playground/drawing/pick.hpp"

#include "playground/drawing/placements.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace playground::drawing {

namespace {

constexpr double TAU = 6.283185307179586;
constexpr int SAMPLES = 96, REFINEMENTS = 40;

std::optional<PickHit> pick_point(const Vector &point, const PickRay &ray) {
	const Vector to = point - ray.origin;
	const double depth = glm::dot(to, ray.direction);
	const double pixels = glm::length(to - ray.direction * depth) / ray.pixel(depth);
	// Beyond the range of double, the distance is not finite.
	if (depth <= 0.0 || !(ray.pixel(depth) > 0.0) || !std::isfinite(pixels)) {
		return std::nullopt;
	}
	return PickHit{ pixels, depth, false };
}

void keep_nearest(std::optional<PickHit> &best, const std::optional<PickHit> &other) {
	if (!other) {
		return;
	}
	// Lines and points within this many pixels take precedence over surfaces.
	constexpr double REACH = 8.0;
	const auto rank = [](const PickHit &hit) { return hit.on_surface ? REACH : hit.pixels; };
	if (!best || rank(*other) < rank(*best)) {
		best = other;
	}
}

// Samples a curve with parameter `from`..`to`, then refines around the best sample.
template <class Curve>
std::optional<PickHit> pick_curve(const Curve &curve, double from, double to, int samples, const PickRay &ray) {
	std::optional<PickHit> best;
	const double step = (to - from) / samples;
	double at = from;
	for (int i = 0; i <= samples; ++i) {
		const std::optional<PickHit> here = pick_point(curve(from + i * step), ray);
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
		const std::optional<PickHit> at_a = pick_point(curve(a), ray), at_b = pick_point(curve(b), ray);
		const bool is_a_closer = at_a && (!at_b || at_a->pixels < at_b->pixels);
		(is_a_closer ? high : low) = is_a_closer ? b : a;
	}
	const std::optional<PickHit> refined = pick_point(curve(0.5 * (low + high)), ray);
	return refined && refined->pixels < best->pixels ? refined : best;
}

std::optional<PickHit> pick_segment(const Vector &a, const Vector &b, const PickRay &ray) {
	const Vector along = b - a;
	return pick_curve([&](double s) { return a + along * s; }, 0.0, 1.0, 16, ray);
}

// Picks the point of the line nearest to the ray.
std::optional<PickHit> pick_line(const Placement &line, const PickRay &ray) {
	const Vector between = line.origin - ray.origin;
	const double cosine = glm::dot(line.x, ray.direction);
	const double across = 1.0 - cosine * cosine;
	const double along_ray = glm::dot(between, ray.direction), along_line = glm::dot(between, line.x);
	if (across < 1e-12) {
		return pick_point(line.origin + line.x * (-along_line + 1e3), ray);
	}
	return pick_point(line.origin + line.x * ((cosine * along_ray - along_line) / across), ray);
}

// Measures the angle from the point of the circle nearest to the eye, where samples are denser.
std::optional<PickHit> pick_circle(const Part &part, const PickRay &ray) {
	const double radius = std::abs(part.radius);
	const Placement &at = part.placement;
	const Vector to = ray.origin - at.origin;
	const double nearest = std::atan2(glm::dot(to, at.x), glm::dot(to, at.z) + radius);
	const auto curve = [&](double s) {
		const double angle = nearest + 0.5 * TAU * s * std::abs(s), half_sine = std::sin(0.5 * angle);
		return at.origin + at.x * (radius * std::sin(angle)) - at.z * (2.0 * radius * half_sine * half_sine);
	};
	return pick_curve(curve, -1.0, 1.0, 4 * SAMPLES, ray);
}

std::optional<PickHit> pick_sphere(const Part &part, const PickRay &ray) {
	const double radius = std::abs(part.radius);
	const Vector to_anchor = part.placement.origin - ray.origin;
	const Vector to_center = to_anchor - part.placement.z * radius;
	const double depth = glm::dot(to_center, ray.direction);
	// |eye - center|^2 - r^2 without cancellation.
	const double power = glm::dot(to_anchor, to_anchor) - 2.0 * radius * glm::dot(to_anchor, part.placement.z);
	const double discriminant = depth * depth - power;
	if (discriminant >= 0.0) {
		const double root = std::sqrt(discriminant);
		const double enters = power > 0.0 ? power / (depth + root) : depth + root;
		if (depth <= 0.0 && power > 0.0) {
			return std::nullopt;
		}
		const std::optional<PickHit> at = pick_point(ray.origin + ray.direction * enters, ray);
		return at ? std::optional<PickHit>({ 0.0, enters, true }) : std::nullopt;
	}
	const double pixels = (glm::length(to_center - ray.direction * depth) - radius) / ray.pixel(depth);
	if (depth <= 0.0 || !std::isfinite(pixels)) {
		return std::nullopt;
	}
	return PickHit{ std::max(pixels, 0.0), depth, false }; // rounding can make it negative
}

std::optional<PickHit> pick_plane(const Placement &plane, const PickRay &ray) {
	const double toward = glm::dot(ray.direction, plane.z);
	const double depth = glm::dot(plane.origin - ray.origin, plane.z) / toward;
	if (!std::isfinite(depth) || depth <= 0.0) {
		return std::nullopt;
	}
	return PickHit{ 0.0, depth, true };
}

// Picks an arrow along z with constant size on the screen; `from` and `to` are in pixels.
std::optional<PickHit> pick_arrow(const Placement &at, double from, double to, const PickRay &ray) {
	const double pixel = ray.pixel(glm::dot(at.origin - ray.origin, ray.direction));
	return pick_segment(at.origin + at.z * (from * pixel), at.origin + at.z * (to * pixel), ray);
}

std::optional<PickHit> pick_strokes(const Strokes &strokes, const Placement &at, const PickRay &ray) {
	std::optional<PickHit> best;
	for (size_t i = 0; i + 2 < strokes.indices.size(); i += 3) {
		const Vector a = at.apply(Vector(strokes.vertices[size_t(strokes.indices[i])].position));
		const Vector b = at.apply(Vector(strokes.vertices[size_t(strokes.indices[i + 2])].position));
		keep_nearest(best, a == b ? pick_point(a, ray) : pick_segment(a, b, ray));
	}
	return best;
}

std::optional<PickHit> pick_part(const Part &part, const Strokes &custom, const PickRay &ray) {
	const Placement &at = part.placement;
	switch (part.form) {
		case Form::POINT_PAIR:
			return pick_segment(at.origin - at.x, at.origin + at.x, ray);
		case Form::LINE:
			return pick_line(at, ray);
		case Form::CIRCLE:
			return pick_circle(part, ray);
		case Form::SPHERE:
			return pick_sphere(part, ray);
		case Form::PLANE:
			return pick_plane(at, ray);
		case Form::NORMAL:
		case Form::TANGENT_ALONG:
			return pick_arrow(at, 0.0, 36.0, ray);
		case Form::DIRECTION_ALONG:
			return pick_arrow(at, -26.0, 26.0, ray);
		case Form::CUSTOM:
			return pick_strokes(custom, at, ray);
		default:
			return pick_point(at.origin, ray);
	}
}

} // namespace

std::optional<PickHit> pick(const Figure &figure, const PickRay &ray) {
	std::optional<PickHit> best;
	for (const Part &part : figure.parts) {
		keep_nearest(best, pick_part(part, figure.custom, ray));
	}
	return best;
}

} // namespace playground::drawing
