#pragma once

#include "playground/drawing/form.hpp"

#include <string>

// Shaders in Godot's language, for instances of a MultiMesh: instance uniforms would do, but OpenGL has room for 256 only.
//
//   COLOR             the object's colour
//   INSTANCE_CUSTOM   (side of the orientation, 1 or -1; dashed and hollow, 0 or 1; double lines, 0 or 1; line width in
//                     pixels)
//   vertices          CUSTOM0 = (tangent, arc), CUSTOM1 = (offset along, offset across, profile, opacity), CUSTOM2 = colour
//
// Rounds have the radius 1 in their own space and are scaled: near the anchor nothing is lost by that.

namespace playground::drawing {

enum class Renderer {
	compatibility, // OpenGL
	rendering_device, // forward_plus, mobile
};

// Lines are drawn in two passes, with surfaces between: first what covers at least half a pixel, which writes depth, so
// that it is seen through surfaces before it and hides what is behind; then soft edges and faint lines.
enum class StrokePass {
	core,
	fringe,
};

[[nodiscard]] std::string stroke_shader(Space space, Renderer renderer, StrokePass pass);
// Of Space::round, plane and screen.
[[nodiscard]] std::string fill_shader(Space space, Renderer renderer);

} // namespace playground::drawing
