#pragma once

#include <glm/vec3.hpp>

// Functions of the vertex shaders, compiled as C++: src/playground/drawing/shaders/ documents them.

namespace playground::drawing::shader_functions {

using glm::vec3;

float unbounded_extent(float step, float near_extent, float far_plane);
float line_arrow_position(float index, float eye_position, float distance);

vec3 ring_point(float radius, float angle, float ring);
vec3 ring_tangent(float angle, float ring);
float nearest_angle(vec3 eye, float radius, float ring);
float spread_angle(float s, float radius, float distance);
float ring_arrow_angle(float index, float eye_angle, float radius, float distance);
float height_above_sphere(vec3 eye, float radius);
vec3 cap_point(float s, float azimuth, vec3 eye, float radius);

} // namespace playground::drawing::shader_functions
