#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

// Lines and signs of constant size on the screen, as triangles: each vertex has a place in space and an offset in
// pixels, along the tangent's image on the screen and across it, which the vertex shader adds.

namespace playground::drawing {

// What the fragment shader draws between the vertices.
enum class Profile {
	stroke, // a line; `offset.y` is half its width
	arrow, // a triangle with its tip ahead
	dot, // a ball
	halo, // a ring around a dot
};

struct StrokeVertex {
	glm::vec3 position{};
	glm::vec3 tangent{};
	float arc = 0.0f; // of strokes: length from the start, for dashes; of signs: their radius in pixels
	glm::vec2 offset{};
	Profile profile = Profile::stroke;
	float opacity = 1.0f;
	glm::vec4 colour{}; // its own colour, as far as a says, over the object's
};

// Sizes in pixels at the standard line width, which is 2.
inline constexpr float HALF_LINE = 1.0f, HALF_THIN = 0.5f;
inline constexpr float ARROW = 6.5f, DOT = 4.5f, HALO = 9.0f;

struct Pen {
	float half_width = HALF_LINE;
	float opacity = 1.0f;
	glm::vec4 colour{};
};

struct CurvePoint {
	glm::vec3 position;
	glm::vec3 tangent;
};

struct Strokes {
	std::vector<StrokeVertex> vertices;
	std::vector<int32_t> indices;

	// One strip along a curve, two vertices a point.
	void add_curve(const std::vector<CurvePoint> &points, const Pen &pen = {});
	void add_segment(const glm::vec3 &from, const glm::vec3 &to, const Pen &pen = {});
	// A sign of four vertices at one place.
	void add_sign(Profile profile, float size, const glm::vec3 &position, const glm::vec3 &tangent, const Pen &pen = {});
	// A segment with an arrowhead whose tip is at its end.
	void add_arrow(const glm::vec3 &from, const glm::vec3 &to, const Pen &pen = {});
};

} // namespace playground::drawing
