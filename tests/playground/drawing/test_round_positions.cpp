#include "shader_functions.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>

using namespace playground::drawing::shader_functions;
using glm::dot;
using glm::length;
using glm::normalize;

namespace {

constexpr float RADII[] = { 1e-3f, 0.5f, 1.0f, 30.0f, 1e3f, 1e5f };

// In double precision, so that the test is more precise than the shader.
double distance_from_center(const vec3 &p, float radius) {
	const double x = p.x, y = p.y, z = double(p.z) + radius;
	return std::sqrt(x * x + y * y + z * z);
}

} // namespace

TEST_CASE("great circles lie on the sphere, and the tangent is the derivative") {
	for (const float radius : RADII) {
		for (float ring = 0.0f; ring < 3.0f; ring += 1.0f) {
			for (float angle = -3.1f; angle < 3.15f; angle += 0.31f) {
				const vec3 point = ring_point(radius, angle, ring);
				CHECK(distance_from_center(point, radius) == doctest::Approx(radius).epsilon(1e-5));
				const vec3 ahead = ring_point(1.0f, angle + 1e-2f, ring), behind = ring_point(1.0f, angle - 1e-2f, ring);
				CHECK(length((ahead - behind) / 2e-2f - ring_tangent(angle, ring)) < 1e-3f);
			}
		}
		CHECK(ring_point(radius, 0.0f, 0.0f) == vec3(0.0f));
	}
}

TEST_CASE("a huge circle is precise near the anchor") {
	// 10 m along a circle with a radius of 100 km, the distance from its tangent is 0.5 mm.
	const vec3 point = ring_point(1e5f, 1e-4f, 0.0f);
	CHECK(point.x == doctest::Approx(10.0).epsilon(1e-6));
	CHECK(point.z == doctest::Approx(-5e-4).epsilon(1e-5));
}

TEST_CASE("nearest_angle gives the point of a ring nearest to the eye") {
	for (const float radius : RADII) {
		for (const vec3 &eye : { vec3(3.0f, 2.0f, 5.0f), vec3(-7.0f, 0.5f, -3.0f), vec3(0.0f, -2.0f, 40.0f) }) {
			for (float ring = 0.0f; ring < 3.0f; ring += 1.0f) {
				const float angle = nearest_angle(eye, radius, ring);
				const float best = length(eye - ring_point(radius, angle, ring));
				for (float other = -3.1f; other < 3.15f; other += 0.1f) {
					CHECK(best <= length(eye - ring_point(radius, other, ring)) * 1.0001f + 1e-6f);
				}
			}
		}
	}
}

TEST_CASE("chords of a ring deviate from the circle by at most a thousandth of the distance to the eye") {
	constexpr int STEPS = 160;
	for (const float radius : RADII) {
		for (const float distance : { 0.5f, 3.0f, 40.0f }) {
			double previous = -4.0;
			for (int i = 0; i < STEPS; ++i) {
				const double from = spread_angle(2.0f * float(i) / STEPS - 1.0f, radius, distance), to = spread_angle(2.0f * float(i + 1) / STEPS - 1.0f, radius, distance);
				CHECK(from > previous);
				previous = from;
				// The distance of a point of the chord from the circle, and that from the eye.
				for (const double part : { 0.1, 0.5, 0.9 }) {
					const double angle = from + part * (to - from);
					const double inside = 0.5 * radius * (angle - from) * (to - angle);
					const double away = std::hypot(double(distance), 2.0 * radius * std::sin(0.5 * std::abs(angle)));
					CHECK(inside <= 1e-3 * away);
				}
			}
			CHECK(spread_angle(1.0f, radius, distance) - spread_angle(-1.0f, radius, distance) == doctest::Approx(6.2831853).epsilon(1e-5));
		}
	}
}

TEST_CASE("arrowheads stay in place when the eye moves a little, and are denser near it") {
	for (float index = -1.0f; index < 2.5f; index += 1.0f) {
		CHECK(ring_arrow_angle(index, 0.1f, 1.0f, 5.0f) == ring_arrow_angle(index, 0.3f, 1.0f, 4.5f));
	}
	const float far_gap = ring_arrow_angle(1.0f, 0.0f, 1e5f, 100.0f) - ring_arrow_angle(0.0f, 0.0f, 1e5f, 100.0f);
	const float near_gap = ring_arrow_angle(1.0f, 0.0f, 1e5f, 1.0f) - ring_arrow_angle(0.0f, 0.0f, 1e5f, 1.0f);
	CHECK(far_gap * 1e5f < 110.0f);
	CHECK(near_gap * 1e5f < 1.1f);
}

TEST_CASE("the visible cap lies on the sphere and ends at the outline") {
	for (const float radius : RADII) {
		for (const float height : { 0.3f, 2.0f, 50.0f }) {
			const vec3 eye = normalize(vec3(0.3f, -0.4f, 1.0f)) * height;
			const float above = height_above_sphere(eye, radius);
			CHECK(above == doctest::Approx(distance_from_center(eye, radius) - radius).epsilon(0.02));
			for (float azimuth = 0.0f; azimuth < 6.3f; azimuth += 0.7f) {
				for (const float s : { 0.0f, 0.4f, 1.0f }) {
					const vec3 point = cap_point(s, azimuth, eye, radius);
					CHECK(distance_from_center(point, radius) == doctest::Approx(radius).epsilon(1e-5));
				}
				// At the outline the view ray is tangent to the sphere. The tolerance allows for rounding at large radii.
				const vec3 outline = cap_point(1.0f, azimuth, eye, radius);
				const vec3 normal = (outline + vec3(0.0f, 0.0f, radius)) / radius;
				CHECK(std::abs(dot(normal, normalize(eye - outline))) < 5e-3f);
			}
		}
	}
}

TEST_CASE("from inside the sphere, the cap is the whole sphere") {
	const vec3 eye(0.2f, 0.1f, -0.8f); // the center is at z = -1
	CHECK(height_above_sphere(eye, 1.0f) < 0.0f);
	const vec3 away = cap_point(1.0f, 0.0f, eye, 1.0f);
	CHECK(dot(normalize(away + vec3(0.0f, 0.0f, 1.0f)), normalize(eye + vec3(0.0f, 0.0f, 1.0f))) == doctest::Approx(-1.0));
}
