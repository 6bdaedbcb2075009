#pragma once

#include "playground/drawing/shader_function.hpp"

// Vertices of lines and planes, which have no end: they go beyond what any camera sees, and are dense near the eye.

namespace playground::drawing::shared {

// clang-format off

// How far from the eye's foot the vertex of `step` is: 0, near, half of what the camera sees, far beyond it.
SHADER_FUNCTION(endless_extent,
float endless_extent(float step, float near_extent, float far_plane) {
	if (step < 0.5f) {
		return 0.0f;
	}
	if (step < 1.5f) {
		return min(near_extent, 0.25f * far_plane);
	}
	return step < 2.5f ? 0.5f * far_plane : 200.0f * far_plane;
})

// Where along a line arrowhead `index` sits: at fixed places, a power of two metres apart, denser the closer the eye.
SHADER_FUNCTION(line_arrow_place,
float line_arrow_place(float index, float place_of_eye, float distance) {
	float gap = exp2(ceil(log2(max(0.25f * distance, 1e-6f))));
	return (floor(place_of_eye / gap) + index + 0.5f) * gap;
})

// clang-format on

} // namespace playground::drawing::shared
