#pragma once

#include "playground/drawing/strokes.hpp"

#include <vector>

// The shapes that everything is drawn with. Each is one mesh, shared by all objects, in one of a few spaces, which say
// how the vertex shader reads `position`.

namespace playground::drawing {

enum class Form {
	point,
	flat_point,
	pair, // ends at x = -1 and 1
	line, // along x
	ring, // a circle through the origin, its centre at (0, 0, -radius), its normal y
	globe, // a sphere, likewise
	plane, // across z
	normal, // an arrow along z: the side that a plane faces
	tangent_along, // an arrow along z
	tangent_across, // a disc across z
	direction_along, // along z
	direction_across, // across z
	own, // no shared shape: the object's own strokes
};
inline constexpr int SHARED_FORM_COUNT = int(Form::own);

enum class Space {
	model, // position in metres
	screen, // position in pixels, at the place of the origin
	round, // (s, ring, arrow): round_places.hpp
	line, // (step, 0, arrow): endless_places.hpp
	plane, // (step, turn, 0)
};

// A surface without width on the screen.
struct Fill {
	std::vector<glm::vec3> vertices;
	std::vector<int32_t> indices;
};

struct FormMesh {
	Space space = Space::model;
	Strokes strokes;
	Fill fill; // of the globe (s, turn, 0), the plane (step, turn, 0) and discs; otherwise empty
};

[[nodiscard]] Space space_of(Form form);
[[nodiscard]] FormMesh mesh_of(Form form);

// On `position.y` of strokes in Space::round: ticks of the globe, which show its orientation, and its outline.
inline constexpr float FIRST_TICK = 3.0f, OUTLINE = 9.0f;
inline constexpr int LINE_ARROWS = 12, RING_ARROWS = 8;
inline constexpr int RING_STEPS = 160, GLOBE_RING_STEPS = 64, OUTLINE_STEPS = 80;

} // namespace playground::drawing
