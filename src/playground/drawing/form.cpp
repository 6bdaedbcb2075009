#include "playground/drawing/form.hpp"

#include <glm/geometric.hpp>

#include <cmath>

namespace playground::drawing {

namespace {

constexpr float TURN = 6.28318531f;
constexpr float THIN_OPACITY = 0.4f;
const glm::vec3 X(1.0f, 0.0f, 0.0f), Y(0.0f, 1.0f, 0.0f), Z(0.0f, 0.0f, 1.0f);

// In Space::round: one great circle.
void add_ring(Strokes &strokes, float ring, int steps, const Pen &pen) {
	std::vector<CurvePoint> points;
	for (int i = 0; i <= steps; ++i) {
		points.push_back({ { 2.0f * float(i) / float(steps) - 1.0f, ring, 0.0f }, X });
	}
	strokes.add_curve(points, pen);
}

// Index of the arrow 1, 2, ..: 0 says that a vertex is none of an arrow's.
void add_arrows(Strokes &strokes, int count) {
	for (int i = 1; i <= count; ++i) {
		strokes.add_sign(Profile::arrow, ARROW, { 0.0f, 0.0f, float(i) }, X);
	}
}

// In the plane z = 0, of Space::model or Space::screen.
std::vector<CurvePoint> arc(float radius, float from, float to, int steps) {
	std::vector<CurvePoint> points;
	for (int i = 0; i <= steps; ++i) {
		const float angle = from + (to - from) * float(i) / float(steps);
		points.push_back({ glm::vec3(std::cos(angle), std::sin(angle), 0.0f) * radius, glm::vec3(-std::sin(angle), std::cos(angle), 0.0f) });
	}
	return points;
}

// (0, turn) in the middle, then circles of steps 1 / count, 2 / count, .. of `last`.
Fill polar_fill(int count, int turns, float last) {
	Fill fill;
	for (int i = 0; i <= count; ++i) {
		for (int j = 0; j <= turns; ++j) {
			fill.vertices.push_back({ last * float(i) / float(count), TURN * float(j) / float(turns), 0.0f });
			if (i > 0 && j > 0) {
				const int32_t here = int32_t(fill.vertices.size()) - 1, below = here - turns - 1;
				fill.indices.insert(fill.indices.end(), { below - 1, here - 1, here, below - 1, here, below });
			}
		}
	}
	return fill;
}

Fill disc(float radius) {
	Fill fill;
	for (const CurvePoint &point : arc(radius, 0.0f, TURN, 40)) {
		const int32_t here = int32_t(fill.vertices.size());
		fill.vertices.push_back(point.position);
		if (here > 1) {
			fill.indices.insert(fill.indices.end(), { 0, here - 1, here });
		}
	}
	return fill;
}

void add_globe(FormMesh &mesh) {
	for (int ring = 0; ring < 3; ++ring) {
		add_ring(mesh.strokes, float(ring), GLOBE_RING_STEPS, { HALF_THIN, THIN_OPACITY, {} });
	}
	for (int tick = 0; tick < 6; ++tick) {
		const float which = FIRST_TICK + float(tick);
		mesh.strokes.add_segment({ 0.0f, which, 0.0f }, { 1.0f, which, 0.0f }, { HALF_LINE, 0.8f, {} });
		mesh.strokes.add_sign(Profile::arrow, 0.8f * ARROW, { 1.0f, which, 0.0f }, X, { HALF_LINE, 0.8f, {} });
	}
	std::vector<CurvePoint> outline;
	for (int i = 0; i <= OUTLINE_STEPS; ++i) {
		outline.push_back({ { TURN * float(i) / OUTLINE_STEPS, OUTLINE, 0.0f }, X });
	}
	mesh.strokes.add_curve(outline);
	mesh.fill = polar_fill(8, 64, 1.0f);
}

void add_plane(FormMesh &mesh) {
	std::vector<CurvePoint> horizon;
	for (int i = 0; i <= OUTLINE_STEPS; ++i) {
		horizon.push_back({ { 3.0f, TURN * float(i) / OUTLINE_STEPS, 0.0f }, X });
	}
	mesh.strokes.add_curve(horizon, { HALF_THIN, 0.6f, {} });
	mesh.fill = polar_fill(3, 32, 3.0f);
}

// Parallel arrows, which are nowhere in particular.
void add_parallel_arrows(Strokes &strokes) {
	for (int i = -1; i <= 1; ++i) {
		const glm::vec3 middle = 13.0f * float(i) * X - 10.0f * float(i * i) * Z;
		strokes.add_arrow(middle - 26.0f * Z, middle + 26.0f * Z, { HALF_LINE, i == 0 ? 1.0f : 0.7f, {} });
	}
}

// Turns side by side.
void add_parallel_turns(Strokes &strokes) {
	for (int i = -1; i <= 1; ++i) {
		std::vector<CurvePoint> circle = arc(10.0f, 0.4f, TURN, 32);
		for (CurvePoint &point : circle) {
			point.position += 26.0f * float(i) * X;
		}
		const Pen pen{ HALF_LINE, i == 0 ? 1.0f : 0.7f, {} };
		strokes.add_curve(circle, pen);
		strokes.add_sign(Profile::arrow, 0.8f * ARROW, circle.back().position, circle.back().tangent, pen);
	}
}

} // namespace

Space space_of(Form form) {
	switch (form) {
		case Form::line:
			return Space::line;
		case Form::ring:
		case Form::globe:
			return Space::round;
		case Form::plane:
			return Space::plane;
		case Form::normal:
		case Form::tangent_along:
		case Form::tangent_across:
		case Form::direction_along:
		case Form::direction_across:
			return Space::screen;
		default:
			return Space::model;
	}
}

FormMesh mesh_of(Form form) {
	FormMesh mesh;
	mesh.space = space_of(form);
	Strokes &strokes = mesh.strokes;
	switch (form) {
		case Form::point:
			strokes.add_sign(Profile::dot, DOT, {}, X);
			break;
		case Form::flat_point:
			strokes.add_sign(Profile::dot, 0.75f * DOT, {}, X);
			strokes.add_sign(Profile::halo, HALO, {}, X);
			break;
		case Form::pair:
			strokes.add_segment(-X, X, { HALF_THIN, 0.7f, {} });
			strokes.add_sign(Profile::arrow, ARROW, 0.25f * X, X);
			strokes.add_sign(Profile::dot, DOT, -X, X);
			strokes.add_sign(Profile::dot, DOT, X, X);
			break;
		case Form::line: {
			std::vector<CurvePoint> points;
			for (int step = -3; step <= 3; ++step) {
				points.push_back({ { float(step), 0.0f, 0.0f }, X });
			}
			strokes.add_curve(points);
			add_arrows(strokes, LINE_ARROWS);
			break;
		}
		case Form::ring:
			add_ring(strokes, 0.0f, RING_STEPS, {});
			add_arrows(strokes, RING_ARROWS);
			break;
		case Form::globe:
			add_globe(mesh);
			break;
		case Form::plane:
			add_plane(mesh);
			break;
		case Form::normal:
			strokes.add_arrow({}, 34.0f * Z);
			break;
		case Form::tangent_along:
			strokes.add_arrow({}, 38.0f * Z);
			strokes.add_sign(Profile::dot, DOT, {}, X);
			break;
		case Form::tangent_across: {
			const std::vector<CurvePoint> rim = arc(20.0f, 0.0f, TURN, 48);
			strokes.add_curve(rim);
			strokes.add_sign(Profile::arrow, 0.8f * ARROW, rim[6].position, rim[6].tangent);
			strokes.add_sign(Profile::arrow, 0.8f * ARROW, rim[30].position, rim[30].tangent);
			strokes.add_sign(Profile::dot, DOT, {}, X);
			mesh.fill = disc(20.0f);
			break;
		}
		case Form::direction_along:
			add_parallel_arrows(strokes);
			break;
		case Form::direction_across:
			add_parallel_turns(strokes);
			break;
		case Form::own:
			break;
	}
	return mesh;
}

} // namespace playground::drawing
