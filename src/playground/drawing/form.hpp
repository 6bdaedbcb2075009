#pragma once

#include "playground/drawing/strokes.hpp"

#include <vector>

// The shapes that make up figures. All objects share one mesh per form; the space of the mesh tells the vertex shader
// how to read `position`.

namespace playground::drawing {

enum class Form {
	POINT,
	FLAT_POINT,
	POINT_PAIR, // at x = -1 and 1
	LINE, // along x
	CIRCLE, // through the origin, center (0, 0, -radius), normal y
	SPHERE, // through the origin, center (0, 0, -radius)
	PLANE, // normal z
	NORMAL, // an arrow along z, on the front of a plane
	TANGENT_ALONG, // an arrow along z
	TANGENT_ACROSS, // a disc with normal z
	DIRECTION_ALONG, // arrows along z
	DIRECTION_ACROSS, // circles with normal z
	CUSTOM, // the strokes of one object
};
inline constexpr int SHARED_FORM_COUNT = int(Form::CUSTOM);

enum class Space {
	MODEL, // meters
	SCREEN, // pixels, scaled at the depth of the origin
	ROUND, // (s, ring, arrow): shaders/round_positions.gdshaderinc
	LINE, // (step, 0, arrow): shaders/unbounded_positions.gdshaderinc
	PLANE, // (step, azimuth, 0): likewise
};

// The triangles of a surface.
struct Fill {
	std::vector<glm::vec3> vertices;
	std::vector<int32_t> indices;
};

struct FormMesh {
	Space space = Space::MODEL;
	Strokes strokes;
	Fill fill; // of the sphere (s, azimuth, 0), the plane (step, azimuth, 0) and discs; otherwise empty
};

[[nodiscard]] FormMesh mesh_of(Form form);

// Values of `ring` beyond the great circles 0 to 2: the six ticks of a sphere, which show its orientation, and its outline.
inline constexpr float FIRST_TICK = 3.0f, OUTLINE = 9.0f;
inline constexpr int LINE_ARROWS = 12, CIRCLE_ARROWS = 8;
inline constexpr int CIRCLE_STEPS = 160, SPHERE_RING_STEPS = 64, OUTLINE_STEPS = 80;

} // namespace playground::drawing
