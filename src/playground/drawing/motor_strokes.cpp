#include "playground/drawing/motor_strokes.hpp"

#include "cga/motor/axis_angle.hpp"
#include "cga/motor/motor_exp.hpp"
#include "playground/drawing/placements.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace playground::drawing {

namespace {

using Pose = cga::Pose<double>;

// Smaller angles and changes of scale count as zero.
constexpr double EPSILON = 1e-9;

Vector moved(const Pose &pose, const Vector &point) {
	return pose.translation + pose.scale * (pose.rotation * point);
}

glm::vec3 narrow(const Vector &v) {
	return glm::vec3(v);
}

// Adds the path of a point, unless the point stays in place.
void add_path(Strokes &strokes, const Pose &pose, const Vector &start, const Pen &pen) {
	std::vector<CurvePoint> points;
	for (int i = 0; i <= PATH_STEPS; ++i) {
		points.push_back({ narrow(moved(cga::power_of_pose(pose, double(i) / PATH_STEPS), start)), {} });
	}
	float length = 0.0f;
	for (size_t i = 0; i < points.size(); ++i) {
		const glm::vec3 before = points[i > 0 ? i - 1 : i].position, after = points[i + 1 < points.size() ? i + 1 : i].position;
		points[i].tangent = after - before;
		length += glm::length(points[i].position - before);
	}
	if (length > 1e-6f) {
		strokes.add_curve(points, pen);
		strokes.add_marker(Profile::ARROW, ARROW, points.back().position, points.back().tangent, pen);
	}
}

void add_frame(Strokes &strokes, const Pose &pose, float opacity) {
	static const glm::vec4 COLORS[3] = { { 0.94f, 0.27f, 0.32f, 1.0f }, { 0.47f, 0.76f, 0.17f, 1.0f }, { 0.20f, 0.53f, 0.96f, 1.0f } };
	for (int axis = 0; axis < 3; ++axis) {
		Vector end(0.0);
		end[axis] = FRAME_SIZE;
		strokes.add_arrow(narrow(pose.translation), narrow(moved(pose, end)), { HALF_LINE, opacity, COLORS[axis] });
	}
}

} // namespace

std::optional<Vector> fixed_point_of(const Pose &pose) {
	if (std::abs(pose.scale - 1.0) <= EPSILON) {
		return std::nullopt;
	}
	const glm::dmat3 moving = glm::dmat3(1.0) - pose.scale * glm::mat3_cast(pose.rotation);
	return glm::inverse(moving) * pose.translation;
}

// Without scale, for the part t of the translation perpendicular to the axis n: p = (t + cot(angle / 2) n x t) / 2.
std::optional<MotorAxis> axis_of(const Pose &pose) {
	const cga::AxisAngle<double> rotation = cga::short_axis_angle(pose.rotation);
	if (rotation.angle <= EPSILON) {
		return std::nullopt;
	}
	if (const std::optional<Vector> fixed = fixed_point_of(pose)) {
		return MotorAxis{ *fixed, rotation.axis };
	}
	const Vector across = pose.translation - rotation.axis * glm::dot(pose.translation, rotation.axis);
	return MotorAxis{ 0.5 * (across + glm::cross(rotation.axis, across) / std::tan(0.5 * rotation.angle)), rotation.axis };
}

Strokes motor_strokes(const Pose &pose) {
	Strokes strokes;
	add_path(strokes, pose, {}, { HALF_LINE, 0.9f, {} });
	if (const std::optional<MotorAxis> axis = axis_of(pose)) {
		const Vector beside = across(axis->point, axis->direction).x;
		add_path(strokes, pose, axis->point + HELIX_RADIUS * beside, { HALF_LINE, 1.0f, {} });
		strokes.add_segment(narrow(axis->point), narrow(axis->point + HELIX_RADIUS * beside), { HALF_THIN, 0.5f, {} });
		const Vector end = moved(pose, axis->point);
		strokes.add_segment(narrow(end), narrow(moved(pose, axis->point + HELIX_RADIUS * beside)), { HALF_THIN, 0.5f, {} });
	}
	if (const std::optional<Vector> fixed = fixed_point_of(pose)) {
		strokes.add_marker(Profile::HALO, HALO, narrow(*fixed), { 1.0f, 0.0f, 0.0f });
		for (int axis = 0; axis < 3; ++axis) {
			Vector end(0.0);
			end[axis] = FRAME_SIZE;
			strokes.add_segment(narrow(end), narrow(moved(pose, end)), { HALF_THIN, 0.4f, {} });
		}
	}
	add_frame(strokes, {}, 0.4f);
	if (glm::length(pose.translation) > FRAME_SIZE) {
		add_frame(strokes, cga::power_of_pose(pose, 1.0 / 3.0), 0.25f);
		add_frame(strokes, cga::power_of_pose(pose, 2.0 / 3.0), 0.25f);
	}
	add_frame(strokes, pose, 1.0f);
	return strokes;
}

} // namespace playground::drawing
