#include "playground/drawing/strokes.hpp"

#include <glm/geometric.hpp>

namespace playground::drawing {

void Strokes::add_curve(const std::vector<CurvePoint> &points, const Pen &pen) {
	float arc = 0.0f;
	for (size_t i = 0; i < points.size(); ++i) {
		if (i > 0) {
			arc += glm::length(points[i].position - points[i - 1].position);
			const int32_t next = int32_t(vertices.size());
			indices.insert(indices.end(), { next - 2, next - 1, next, next, next - 1, next + 1 });
		}
		StrokeVertex vertex{ points[i].position, points[i].tangent, arc, { 0.0f, -pen.half_width }, Profile::LINE, pen.opacity, pen.color };
		vertices.push_back(vertex);
		vertex.offset.y = pen.half_width;
		vertices.push_back(vertex);
	}
}

void Strokes::add_segment(const glm::vec3 &from, const glm::vec3 &to, const Pen &pen) {
	const glm::vec3 along = to - from;
	add_curve({ { from, along }, { to, along } }, pen);
}

void Strokes::add_marker(Profile profile, float size, const glm::vec3 &position, const glm::vec3 &tangent, const Pen &pen) {
	const int32_t first = int32_t(vertices.size());
	for (const glm::vec2 corner : { glm::vec2(-1.0f, -1.0f), glm::vec2(-1.0f, 1.0f), glm::vec2(1.0f, -1.0f), glm::vec2(1.0f, 1.0f) }) {
		vertices.push_back({ position, tangent, size, corner * size, profile, pen.opacity, pen.color });
	}
	indices.insert(indices.end(), { first, first + 1, first + 2, first + 2, first + 1, first + 3 });
}

void Strokes::add_arrow(const glm::vec3 &from, const glm::vec3 &to, const Pen &pen) {
	add_segment(from, to, pen);
	add_marker(Profile::ARROW, ARROW, to, to - from, pen);
}

} // namespace playground::drawing
