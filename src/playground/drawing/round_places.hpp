#pragma once

#include "playground/drawing/shader_function.hpp"

// Vertices of circles and spheres of any size, by their distance from one point of theirs, the anchor: near it they
// keep their digits, however far away the centre is. The anchor is the origin, the centre is at (0, 0, -radius).

namespace playground::drawing::shared {

// clang-format off

// A point of one of three great circles: 0 turns from z to x, 1 from z to y, 2 is the equator, from y to x.
SHADER_FUNCTION(ring_point,
vec3 ring_point(float radius, float angle, float ring) {
	float half_sine = sin(0.5f * angle);
	float across = radius * sin(angle);
	float down = -2.0f * radius * half_sine * half_sine;
	if (ring > 1.5f) {
		return vec3(across, radius + down, -radius);
	}
	return ring > 0.5f ? vec3(0.0f, across, down) : vec3(across, 0.0f, down);
})

// Its derivative by the angle, of length 1.
SHADER_FUNCTION(ring_tangent,
vec3 ring_tangent(float angle, float ring) {
	if (ring > 1.5f) {
		return vec3(cos(angle), -sin(angle), 0.0f);
	}
	return ring > 0.5f ? vec3(0.0f, cos(angle), -sin(angle)) : vec3(cos(angle), 0.0f, -sin(angle));
})

// The angle of the ring's point that is nearest to the eye.
SHADER_FUNCTION(nearest_angle,
float nearest_angle(vec3 eye, float radius, float ring) {
	if (ring > 1.5f) {
		return atan(eye.x, eye.y);
	}
	return ring > 0.5f ? atan(eye.y, eye.z + radius) : atan(eye.x, eye.z + radius);
})

// The angle from there, -pi..pi, of the vertex at s = -1..1: even where the eye is as far as the circle is large, denser
// near the eye where it is closer, so that the chords stay within a pixel of the circle.
SHADER_FUNCTION(spread_angle,
float spread_angle(float s, float radius, float distance) {
	float even = clamp(1.5f * sqrt(distance / radius), 0.003f, 1.0f);
	return 3.14159265f * s * mix(abs(s), 1.0f, even);
})

// Where arrowhead `index` sits: at fixed angles, a power of two of them, more the closer the eye.
SHADER_FUNCTION(ring_arrow_angle,
float ring_arrow_angle(float index, float angle_of_eye, float radius, float distance) {
	float steps = exp2(clamp(ceil(log2(6.0f * radius / distance)), 2.0f, 30.0f));
	float gap = 6.28318531f / steps;
	return (floor(angle_of_eye / gap + 0.5f) + index) * gap;
})

// Height of the eye above the sphere, negative inside.
SHADER_FUNCTION(height_above_sphere,
float height_above_sphere(vec3 eye, float radius) {
	return (dot(eye, eye) + 2.0f * radius * eye.z) / (length(eye + vec3(0.0f, 0.0f, radius)) + radius);
})

// A point of the visible cap: s = 0 faces the eye, s = 1 is the outline, `turn` goes around. From inside the cap is the
// whole sphere. For a parallel view the eye is a direction's end far away.
SHADER_FUNCTION(cap_point,
vec3 cap_point(float s, float turn, vec3 eye, float radius) {
	vec3 pole = normalize(eye + vec3(0.0f, 0.0f, radius));
	float height = height_above_sphere(eye, radius);
	float half_sine = height > 0.0f ? sqrt(height / (2.0f * (radius + height))) : 1.0f;
	float outline = 2.0f * asin(clamp(half_sine, 0.0f, 1.0f));
	float even = clamp(1.5f * sqrt(abs(height) / radius), 0.01f, 1.0f);
	float angle = outline * s * (height > 0.0f ? 1.0f : mix(s, 1.0f, even));
	vec3 side = normalize(abs(pole.y) < 0.9f ? vec3(pole.z, 0.0f, -pole.x) : vec3(0.0f, -pole.z, pole.y));
	vec3 around = cos(turn) * side + sin(turn) * cross(pole, side);
	float sine = sin(0.5f * angle);
	return eye - height * pole - 2.0f * radius * sine * sine * pole + radius * sin(angle) * around;
})

// clang-format on

} // namespace playground::drawing::shared
