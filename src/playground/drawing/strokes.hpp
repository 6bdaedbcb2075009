#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

// Lines and markers of constant size on the screen, as triangles. Each vertex has a position in space and an offset in
// pixels along and across the projected tangent, which the vertex shader adds.

namespace playground::drawing {

// What the fragment shader draws between the vertices.
enum class Profile {
	LINE, // `offset.y` is half its width
	ARROW, // a triangle that points along the tangent
	DOT, // a shaded ball
	HALO, // a ring around a dot
};

struct StrokeVertex {
	glm::vec3 position{};
	glm::vec3 tangent{};
	float arc = 0.0f; // of lines: length from the start, for dashes; of markers: radius in pixels
	glm::vec2 offset{};
	Profile profile = Profile::LINE;
	float opacity = 1.0f;
	glm::vec4 color{}; // blended over the color of the object by its alpha
};

// Sizes in pixels at a line width of 2 pixels.
inline constexpr float HALF_LINE = 1.0f, HALF_THIN = 0.5f;
inline constexpr float ARROW = 6.5f, DOT = 4.5f, HALO = 9.0f;

struct Pen {
	float half_width = HALF_LINE;
	float opacity = 1.0f;
	glm::vec4 color{};
};

struct CurvePoint {
	glm::vec3 position;
	glm::vec3 tangent;
};

struct Strokes {
	std::vector<StrokeVertex> vertices;
	std::vector<int32_t> indices;

	// A strip along a curve, two vertices per point.
	void add_curve(const std::vector<CurvePoint> &points, const Pen &pen = {});
	void add_segment(const glm::vec3 &from, const glm::vec3 &to, const Pen &pen = {});
	// A quad at one position.
	void add_marker(Profile profile, float size, const glm::vec3 &position, const glm::vec3 &tangent, const Pen &pen = {});
	// A segment with an arrowhead at its end.
	void add_arrow(const glm::vec3 &from, const glm::vec3 &to, const Pen &pen = {});
};

} // namespace playground::drawing
