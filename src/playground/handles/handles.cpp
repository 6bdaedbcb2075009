#include "playground/handles/handles.hpp"

#include "cga/motor/axis_angle.hpp"
#include "playground/drawing/motor_strokes.hpp"
#include "playground/drawing/placements.hpp"
#include "playground/handles/free_object.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace playground::handles {

namespace {

constexpr double ARM = 1.0; // meters

std::optional<Vector> unit(const std::optional<Vector> &vector) {
	const double size = vector ? cga::detail::length(*vector) : 0.0;
	return size > 0.0 && std::isfinite(size) ? std::optional<Vector>(*vector / size) : std::nullopt;
}

class HandleCollector {
public:
	std::vector<Handle> found;

	HandleCollector(const FreeObject &object, const Vector &right) :
			_object(object), _right(unit(right).value_or(Vector(1.0, 0.0, 0.0))) {}

	void collect() {
		for (const char *key : { "position", "center", "point" }) {
			add_point(key, true);
		}
		for (const char *key : { "a", "b", "c", "d" }) {
			add_point(key, false);
		}
		add_coordinate();
		for (const char *key : { "offset", "vector" }) {
			if (_object.can_set(key) && (_object.pose() || key[0] == 'v')) {
				add_free(key, *_object.vector(key), Vector(0.0), true);
			}
		}
		add_distance();
		add_radius();
		add_normal();
		add_direction();
		if (_object.pose()) {
			collect_motion(*_object.pose());
		}
		if (found.empty() && _object.coefficients()) {
			add_object();
		}
	}

private:
	void add(std::string key, const Constraint &constraint, const Vector &stem, bool is_arm, bool moves_body) {
		found.push_back({ std::move(key), constraint, stem, is_arm, moves_body, Vector(0.0) });
	}

	void add_free(const char *key, const Vector &position, const Vector &stem, bool moves_body) {
		add(key, { Motion::FREE, position, {}, {} }, stem, false, moves_body);
	}

	void add_point(const char *key, bool moves_body) {
		const std::optional<Vector> position = _object.can_set(key) ? _object.vector(key) : std::nullopt;
		if (position) {
			add_free(key, *position, *position, moves_body);
		}
	}

	// Adds a handle for the only coordinate of point(t, 1, u) or sphere(t, 1, u, r) that is a literal. With two literals, both
	// handles would be at the same point, so neither is added.
	void add_coordinate() {
		const std::optional<Vector> &position = _object.classification().center;
		const char *only = nullptr;
		int count = 0;
		for (const char *key : { "x", "y", "z" }) {
			only = _object.can_set(key) ? key : only;
			count += _object.can_set(key) ? 1 : 0;
		}
		if (position && count == 1 && !_object.has_argument("distance")) {
			Vector axis(0.0);
			axis[only[0] - 'x'] = 1.0;
			add(only, { Motion::LINE, *position, {}, axis }, *position, false, true);
		}
	}

	void add_arm(const char *key, const Vector &from, const Vector &direction) {
		add(key, { Motion::SPHERE, from + direction * ARM, from, direction }, from, true, false);
	}

	// The center of a round, or the point of a line or tangent.
	[[nodiscard]] std::optional<Vector> anchor() const {
		for (const char *key : { "center", "point" }) {
			if (const std::optional<Vector> position = _object.vector(key)) {
				return position;
			}
		}
		return _object.classification().center;
	}

	void add_distance() {
		const std::optional<Vector> normal = unit(_object.vector("normal"));
		if (_object.can_set("distance") && normal) {
			const Vector foot = *normal * *_object.number("distance");
			add("distance", { Motion::LINE, foot, {}, *normal }, foot, false, true);
		}
	}

	void add_radius() {
		const std::optional<Vector> center = anchor();
		if (!_object.can_set("radius") || !center) {
			return;
		}
		Vector outward = _right;
		if (const std::optional<Vector> direction = unit(_object.vector("direction"))) {
			// Place it opposite the direction handle.
			outward = -*direction;
		} else if (const std::optional<Vector> normal = unit(_object.vector("normal"))) {
			const Vector across = _right - *normal * glm::dot(*normal, _right);
			outward = glm::length(across) > 0.1 ? glm::normalize(across) : drawing::across(*center, *normal).x;
		}
		const Vector position = *center + outward * *_object.number("radius");
		add("radius", { Motion::LINE, position, {}, outward }, *center, false, false);
	}

	void add_normal() {
		const std::optional<Vector> normal = unit(_object.vector("normal"));
		if (!_object.can_set("normal") || !normal) {
			return;
		}
		if (_object.has_argument("center") || _object.has_argument("point")) {
			if (const std::optional<Vector> from = anchor()) {
				add_arm("normal", *from, *normal);
			}
			return;
		}
		// Dragging keeps the distance, so the plane rotates around the origin. The arm points away from the origin.
		const double distance = _object.number("distance").value_or(0.0);
		const double side = distance < 0.0 ? -1.0 : 1.0;
		const Vector foot = *normal * distance;
		add("normal", { Motion::SPHERE, foot + *normal * (side * ARM), Vector(0.0), *normal * side }, foot, true, false);
	}

	void add_direction() {
		const std::optional<Vector> direction = unit(_object.vector("direction"));
		const std::optional<Vector> from = anchor();
		if (_object.can_set("direction") && direction && from) {
			add_arm("direction", *from, *direction);
		}
	}

	void collect_motion(const cga::Pose<double> &pose) {
		if (_object.can_set("translation")) {
			add_free("translation", pose.translation, pose.translation, true);
		}
		add_rotation(pose);
		if (_object.can_set("scale")) {
			// On the diagonal of the frame, away from the handles on its axes.
			const Vector along = pose.rotation * glm::normalize(Vector(1.0));
			add("scale", { Motion::LINE, pose.translation + along * (drawing::FRAME_SIZE * pose.scale), {}, along }, pose.translation, false, false);
		}
	}

	// At the end of the helix that is drawn around the axis.
	void add_rotation(const cga::Pose<double> &pose) {
		const cga::Quaternion<double> *rotation = _object.rotation();
		std::optional<Vector> axis = unit(_object.vector("axis"));
		std::optional<double> angle = _object.number("angle");
		const bool has_axis_or_angle = axis || angle;
		if (!has_axis_or_angle && rotation) {
			const cga::AxisAngle<double> axis_angle = cga::short_axis_angle(*rotation);
			axis = axis_angle.angle > 0.0 ? axis_angle.axis : Vector(0.0, 1.0, 0.0);
			angle = axis_angle.angle;
		}
		const bool can_set_axis = has_axis_or_angle ? _object.can_set("axis") : rotation && *angle > 1e-9;
		const bool can_set_angle = has_axis_or_angle ? _object.can_set("angle") : rotation != nullptr;
		if (axis && can_set_axis) {
			add_arm("axis", pose.translation, *axis);
		}
		if (axis && angle && can_set_angle) {
			const drawing::Placement frame = drawing::across(pose.translation, *axis);
			const Vector outward = frame.x * std::cos(*angle) + frame.y * std::sin(*angle);
			add("angle", { Motion::CIRCLE, pose.translation + outward * drawing::HELIX_RADIUS, pose.translation, *axis }, pose.translation, true, false);
		}
	}

	void add_object() {
		const cga::Classification &object = _object.classification();
		if (object.kind == cga::Kind::PLANE) {
			const Vector foot = *object.normal * *object.distance;
			add("object", { Motion::LINE, foot, {}, *object.normal }, foot, false, true);
		} else if (object.center) {
			add_free("object", *object.center, *object.center, true);
		}
	}

	const FreeObject &_object;
	Vector _right;
};

} // namespace

std::vector<Handle> handles_of(const Document &document, std::string_view name, const Vector &right) {
	const std::optional<FreeObject> object = FreeObject::find(document, name);
	if (!object) {
		return {};
	}
	HandleCollector collector(*object, right);
	collector.collect();
	// Handles beyond MAX_DISTANCE cannot be dragged.
	const auto is_far = [](const Handle &handle) { return !(cga::detail::length(handle.constraint.position) <= MAX_DISTANCE && cga::detail::length(handle.stem) <= MAX_DISTANCE); };
	collector.found.erase(std::remove_if(collector.found.begin(), collector.found.end(), is_far), collector.found.end());
	return std::move(collector.found);
}

} // namespace playground::handles
