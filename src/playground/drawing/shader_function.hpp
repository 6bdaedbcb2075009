#pragma once

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

// Where the view decides what is drawn (a line through the whole view, the part of a huge circle that is near), the
// vertex shader places the vertices, for each view anew. Its formulas are written once, in what C++ with GLM and
// Godot's shader language have in common: SHADER_FUNCTION(name, definition) is an inline function here, which tests
// and picking call, and name_source, its text for the shader.
//
// In such a function: no preprocessor, no out parameters, `f` after every number; names other than C++'s std.
#define SHADER_FUNCTION(m_name, ...) \
	inline __VA_ARGS__ inline constexpr const char *m_name##_source = #__VA_ARGS__ "\n";

namespace playground::drawing::shared {

using glm::abs;
using glm::asin;
using glm::atan;
using glm::ceil;
using glm::clamp;
using glm::cos;
using glm::cross;
using glm::dot;
using glm::exp2;
using glm::floor;
using glm::length;
using glm::log2;
using glm::max;
using glm::min;
using glm::mix;
using glm::normalize;
using glm::sin;
using glm::sqrt;
using glm::vec2;
using glm::vec3;

} // namespace playground::drawing::shared
