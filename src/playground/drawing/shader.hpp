#pragma once

#include "playground/drawing/form.hpp"

#include <string>

// Assembles Godot shaders for MultiMesh instances from the files in shaders/. Per-instance data uses custom data instead of
// instance uniforms, because the Compatibility renderer has room for only 256 of those.
//
//   COLOR             color of the object
//   INSTANCE_CUSTOM   (orientation, 1 or -1; dashed and hollow, 0 or 1; double lines, 0 or 1; line width in pixels)
//   vertices          CUSTOM0 = (tangent, arc), CUSTOM1 = (offset along, offset across, profile, opacity), CUSTOM2 = color
//
// Circles and spheres have radius 1 in model space and are scaled, which loses no precision near the anchor.

namespace playground::drawing {

enum class Renderer {
	COMPATIBILITY, // OpenGL
	RENDERING_DEVICE, // forward_plus, mobile
};

// Strokes are drawn in two passes, before and after surfaces. The first draws fragments with at least half coverage and writes
// depth: it hides what is behind it and shows through surfaces in front. The second draws soft edges and faint lines.
enum class StrokePass {
	CORE,
	FRINGE,
};

[[nodiscard]] std::string stroke_shader(Space space, Renderer renderer, StrokePass pass);
// For Space::ROUND, PLANE and SCREEN.
[[nodiscard]] std::string fill_shader(Space space, Renderer renderer);

} // namespace playground::drawing
