#include "playground/drawing/form.hpp"

#include <glm/geometric.hpp>

#include <cmath>

namespace playground::drawing {

namespace {

constexpr float TAU = 6.28318531f;
constexpr float THIN_OPACITY = 0.4f;
const glm::vec3 X(1.0f, 0.0f, 0.0f), Z(0.0f, 0.0f, 1.0f);

// In the order of Form.
constexpr Space SPACES[SHARED_FORM_COUNT + 1] = {
	Space::MODEL, Space::MODEL, Space::MODEL, // points and pairs
	Space::LINE,
	Space::ROUND, Space::ROUND, // circles and spheres
	Space::PLANE,
	Space::SCREEN, Space::SCREEN, Space::SCREEN, Space::SCREEN, Space::SCREEN, // normals, tangents and directions
	Space::MODEL, // Form::CUSTOM
};

// Adds a curve through position(0) .. position(steps), whose tangents the vertex shader computes.
template <class Position>
void add_samples(Strokes &strokes, int steps, Position position, const Pen &pen = {}) {
	std::vector<CurvePoint> points;
	for (int i = 0; i <= steps; ++i) {
		points.push_back({ position(float(i)), X });
	}
	strokes.add_curve(points, pen);
}

// Adds one great circle in Space::ROUND.
void add_ring(Strokes &strokes, float ring, int steps, const Pen &pen) {
	add_samples(strokes, steps, [&](float i) { return glm::vec3(2.0f * i / float(steps) - 1.0f, ring, 0.0f); }, pen);
}

// Arrows are numbered from 1: a vertex with `arrow` 0 does not belong to an arrow.
void add_arrows(Strokes &strokes, int count) {
	for (int i = 1; i <= count; ++i) {
		strokes.add_marker(Profile::ARROW, ARROW, { 0.0f, 0.0f, float(i) }, X);
	}
}

// The points of an arc in the plane z = 0 of Space::MODEL or Space::SCREEN.
std::vector<CurvePoint> arc(float radius, float from, float to, int steps) {
	std::vector<CurvePoint> points;
	for (int i = 0; i <= steps; ++i) {
		const float angle = from + (to - from) * float(i) / float(steps);
		points.push_back({ glm::vec3(std::cos(angle), std::sin(angle), 0.0f) * radius, glm::vec3(-std::sin(angle), std::cos(angle), 0.0f) });
	}
	return points;
}

// A disc in polar coordinates (step, azimuth, 0), in `count` rings up to step `last`.
Fill polar_fill(int count, int sectors, float last) {
	Fill fill;
	for (int i = 0; i <= count; ++i) {
		for (int j = 0; j <= sectors; ++j) {
			fill.vertices.push_back({ last * float(i) / float(count), TAU * float(j) / float(sectors), 0.0f });
			if (i > 0 && j > 0) {
				const int32_t here = int32_t(fill.vertices.size()) - 1, below = here - sectors - 1;
				fill.indices.insert(fill.indices.end(), { below - 1, here - 1, here, below - 1, here, below });
			}
		}
	}
	return fill;
}

Fill disc(float radius) {
	Fill fill;
	for (const CurvePoint &point : arc(radius, 0.0f, TAU, 40)) {
		const int32_t here = int32_t(fill.vertices.size());
		fill.vertices.push_back(point.position);
		if (here > 1) {
			fill.indices.insert(fill.indices.end(), { 0, here - 1, here });
		}
	}
	return fill;
}

void add_sphere(FormMesh &mesh) {
	for (int ring = 0; ring < 3; ++ring) {
		add_ring(mesh.strokes, float(ring), SPHERE_RING_STEPS, { HALF_THIN, THIN_OPACITY, {} });
	}
	for (int tick = 0; tick < 6; ++tick) {
		const float which = FIRST_TICK + float(tick);
		mesh.strokes.add_segment({ 0.0f, which, 0.0f }, { 1.0f, which, 0.0f }, { HALF_LINE, 0.8f, {} });
		mesh.strokes.add_marker(Profile::ARROW, 0.8f * ARROW, { 1.0f, which, 0.0f }, X, { HALF_LINE, 0.8f, {} });
	}
	add_samples(mesh.strokes, OUTLINE_STEPS, [](float i) { return glm::vec3(TAU * i / OUTLINE_STEPS, OUTLINE, 0.0f); });
	mesh.fill = polar_fill(8, 64, 1.0f);
}

void add_plane(FormMesh &mesh) {
	add_samples(mesh.strokes, OUTLINE_STEPS, [](float i) { return glm::vec3(3.0f, TAU * i / OUTLINE_STEPS, 0.0f); }, { HALF_THIN, 0.6f, {} });
	mesh.fill = polar_fill(3, 32, 3.0f);
}

// Three arrows, because a direction has no position.
void add_parallel_arrows(Strokes &strokes) {
	for (int i = -1; i <= 1; ++i) {
		const glm::vec3 middle = 13.0f * float(i) * X - 10.0f * float(i * i) * Z;
		strokes.add_arrow(middle - 26.0f * Z, middle + 26.0f * Z, { HALF_LINE, i == 0 ? 1.0f : 0.7f, {} });
	}
}

void add_parallel_circles(Strokes &strokes) {
	for (int i = -1; i <= 1; ++i) {
		std::vector<CurvePoint> circle = arc(10.0f, 0.4f, TAU, 32);
		for (CurvePoint &point : circle) {
			point.position += 26.0f * float(i) * X;
		}
		const Pen pen{ HALF_LINE, i == 0 ? 1.0f : 0.7f, {} };
		strokes.add_curve(circle, pen);
		strokes.add_marker(Profile::ARROW, 0.8f * ARROW, circle.back().position, circle.back().tangent, pen);
	}
}

} // namespace

FormMesh mesh_of(Form form) {
	FormMesh mesh;
	mesh.space = SPACES[size_t(form)];
	Strokes &strokes = mesh.strokes;
	switch (form) {
		case Form::POINT:
			strokes.add_marker(Profile::DOT, DOT, {}, X);
			break;
		case Form::FLAT_POINT:
			strokes.add_marker(Profile::DOT, 0.75f * DOT, {}, X);
			strokes.add_marker(Profile::HALO, HALO, {}, X);
			break;
		case Form::POINT_PAIR:
			strokes.add_segment(-X, X, { HALF_THIN, 0.7f, {} });
			strokes.add_marker(Profile::ARROW, ARROW, 0.25f * X, X);
			strokes.add_marker(Profile::DOT, DOT, -X, X);
			strokes.add_marker(Profile::DOT, DOT, X, X);
			break;
		case Form::LINE:
			add_samples(strokes, 6, [](float i) { return glm::vec3(i - 3.0f, 0.0f, 0.0f); });
			add_arrows(strokes, LINE_ARROWS);
			break;
		case Form::CIRCLE:
			add_ring(strokes, 0.0f, CIRCLE_STEPS, {});
			add_arrows(strokes, CIRCLE_ARROWS);
			break;
		case Form::SPHERE:
			add_sphere(mesh);
			break;
		case Form::PLANE:
			add_plane(mesh);
			break;
		case Form::NORMAL:
			strokes.add_arrow({}, 34.0f * Z);
			break;
		case Form::TANGENT_ALONG:
			strokes.add_arrow({}, 38.0f * Z);
			strokes.add_marker(Profile::DOT, DOT, {}, X);
			break;
		case Form::TANGENT_ACROSS: {
			const std::vector<CurvePoint> rim = arc(20.0f, 0.0f, TAU, 48);
			strokes.add_curve(rim);
			strokes.add_marker(Profile::ARROW, 0.8f * ARROW, rim[6].position, rim[6].tangent);
			strokes.add_marker(Profile::ARROW, 0.8f * ARROW, rim[30].position, rim[30].tangent);
			strokes.add_marker(Profile::DOT, DOT, {}, X);
			mesh.fill = disc(20.0f);
			break;
		}
		case Form::DIRECTION_ALONG:
			add_parallel_arrows(strokes);
			break;
		case Form::DIRECTION_ACROSS:
			add_parallel_circles(strokes);
			break;
		case Form::CUSTOM:
			break;
	}
	return mesh;
}

} // namespace playground::drawing
