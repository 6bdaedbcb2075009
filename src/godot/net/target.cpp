#include "godot/net/target.hpp"

#include "godot/algebra/conversions.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace ga_godot {

using godot::Node;
using godot::Node3D;
using godot::NodePath;
using godot::Object;
using godot::ObjectDB;
using godot::String;
using godot::Transform3D;
using godot::vformat;

Node3D *find_node(uint64_t id) {
	return Object::cast_to<Node3D>(ObjectDB::get_instance(id));
}

Node3D *find_node(const Node &from, const NodePath &path) {
	return path.is_empty() ? nullptr : Object::cast_to<Node3D>(from.get_node_or_null(path));
}

std::optional<cga::Pose<double>> Target::read_pose(const Transform3D &transform, const String &synchronizer) {
	_transform = transform;
	_is_sampled = true;
	PoseResult pose = pose_from_transform(transform);
	const bool is_uniform = pose || pose.error() != cga::MatrixError::NON_UNIFORM;
	if (!is_uniform) {
		pose = nearest_pose_from_transform(transform);
	}
	if (!pose) {
		report(synchronizer, cga::describe(pose.error()));
		return std::nullopt;
	}
	if (!is_uniform && !_is_non_uniform) {
		_is_non_uniform = true;
		WARN_PRINT(vformat("MotorSynchronizer %s: the scale of %s is non-uniform or sheared. Other peers see the nearest uniform scale. Scale a child node instead.", synchronizer, find_node(node)->get_path()));
	}
	return *pose;
}

void Target::report_out_of_range(const String &synchronizer) {
	report(synchronizer, "is out of range: too far from the origin, or its scale is too small or too large");
}

void Target::report(const String &synchronizer, const char *fault) {
	if (!_is_faulty) {
		_is_faulty = true;
		ERR_PRINT(vformat("MotorSynchronizer %s: the transform of %s %s. Other peers keep seeing its last pose.", synchronizer, find_node(node)->get_path(), fault));
	}
}

void Target::place(const Transform3D &transform, bool is_physics_interpolated) {
	Node3D *target = find_node(node);
	if (target == nullptr) {
		return;
	}
	if (is_physics_interpolated && _own_interpolation < 0) {
		// The stream is interpolated for each frame. The engine would interpolate it again, one tick late.
		_own_interpolation = int32_t(target->get_physics_interpolation_mode());
		target->set_physics_interpolation_mode(Node::PHYSICS_INTERPOLATION_MODE_OFF);
	}
	if (target->get_transform() != transform) {
		target->set_transform(transform);
	}
}

void Target::release() {
	Node3D *target = find_node(node);
	if (target != nullptr && _own_interpolation >= 0) {
		target->set_physics_interpolation_mode(Node::PhysicsInterpolationMode(_own_interpolation));
		target->reset_physics_interpolation();
		_own_interpolation = -1;
	}
}

} // namespace ga_godot
