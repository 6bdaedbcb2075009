#include "godot/net/target.hpp"

#include "godot/algebra/conversions.hpp"
#include "godot/net/motor_synchronizer.hpp"
#include "godot/net/spatial_node.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <algorithm>
#include <utility>

namespace ga_godot {

using godot::Node;
using godot::Transform3D;
using godot::vformat;

/// A node counts as moving in frames after this many motions in frames, until a tick moves it.
static constexpr int32_t MIN_FRAME_MOTIONS = 2;

std::optional<cga::Pose<double>> Target::read_pose(const Transform3D &transform) {
	_transform = transform;
	_is_sampled = true;
	PoseResult pose = pose_from_transform(transform);
	const bool is_uniform = pose || pose.error() != cga::MatrixError::NON_UNIFORM;
	if (!is_uniform) {
		pose = nearest_pose_from_transform(transform);
	}
	if (!pose) {
		report(cga::describe(pose.error()));
		return std::nullopt;
	}
	if (!is_uniform && !_is_non_uniform) {
		_is_non_uniform = true;
		WARN_PRINT(vformat("MotorSynchronizer %s: the scale of %s is non-uniform or sheared. Other peers see the nearest uniform scale. Scale a child node instead.", synchronizer->get_path(), find_spatial(node)->get_path()));
	}
	return *pose;
}

void Target::report_out_of_range() {
	report("is out of range: too far from the origin, or its scale is too small or too large");
}

void Target::report(const char *fault) {
	if (!_is_faulty) {
		_is_faulty = true;
		ERR_PRINT(vformat("MotorSynchronizer %s: the transform of %s %s. Other peers keep seeing its last pose.", synchronizer->get_path(), find_spatial(node)->get_path(), fault));
	}
}

void Target::before_scripts(const Transform3D &transform) {
	_early_transform = transform;
	if (_is_sampled && transform != _transform) {
		_frame_motions = std::min(_frame_motions + 1, MIN_FRAME_MOTIONS);
	}
}

bool Target::after_scripts(const Transform3D &transform) {
	if (transform != _early_transform) {
		_frame_motions = 0;
	}
	return _frame_motions >= MIN_FRAME_MOTIONS;
}

// Each setter of the node runs callbacks, which may free the node or end the target.

void Target::place(const Transform3D &transform, bool is_physics_interpolated) {
	Node *target = find_spatial(node);
	if (target == nullptr) {
		return;
	}
	if (is_physics_interpolated && _own_interpolation < 0) {
		// The stream is interpolated for each frame. The engine would interpolate it again, one tick late.
		_own_interpolation = int32_t(target->get_physics_interpolation_mode());
		target->set_physics_interpolation_mode(Node::PHYSICS_INTERPOLATION_MODE_OFF);
		target = find_spatial(node);
	}
	if (target != nullptr && !_was_synced_to_physics && target->is_class(is_2d ? "AnimatableBody2D" : "AnimatableBody3D")) {
		_was_synced_to_physics = bool(target->get("sync_to_physics"));
		target = find_spatial(node);
		if (target != nullptr && _was_synced_to_physics) {
			// The physics engine would move the body in ticks, and undo what the stream sets in frames.
			target->set("sync_to_physics", false);
			target = find_spatial(node);
		}
	}
	if (!is_removed) {
		set_local_transform(target, transform);
	}
}

void Target::begin_blend(const Transform3D &from, const Transform3D &transform, double now) {
	const PoseResult shown = nearest_pose_from_transform(from);
	const PoseResult next = nearest_pose_from_transform(transform);
	if (!shown || !next) {
		return;
	}
	_blend_begin = now;
	_blend_from.translation = shown->translation - next->translation;
	_blend_from.rotation = shown->rotation * glm::conjugate(next->rotation);
	_blend_from.scale = shown->scale / next->scale;
}

Transform3D Target::blended(const Transform3D &transform, double now, double duration) const {
	if (!_blend_begin || now >= *_blend_begin + duration) {
		return transform;
	}
	PoseResult pose = nearest_pose_from_transform(transform);
	if (!pose) {
		return transform;
	}
	const double t = (now - *_blend_begin) / duration;
	const double weight = t * t * (3.0 - 2.0 * t);
	const cga::Pose<double> rest = cga::interpolate(_blend_from, cga::Pose<double>(), weight, cga::Mode::SEPARATE);
	pose->translation += rest.translation;
	pose->rotation = rest.rotation * pose->rotation;
	pose->scale *= rest.scale;
	return to_godot(*pose);
}

void Target::hide() {
	Node *target = find_spatial(node);
	if (target != nullptr && !_is_hidden && is_shown(target)) {
		_is_hidden = true;
		set_shown(target, false);
	}
}

void Target::reveal() {
	if (std::exchange(_is_hidden, false)) {
		set_shown(find_spatial(node), true);
	}
}

void Target::release() {
	reveal();
	Node *target = find_spatial(node);
	if (target != nullptr && std::exchange(_was_synced_to_physics, false)) {
		target->set("sync_to_physics", true);
		target = find_spatial(node);
	}
	const int32_t own_interpolation = target != nullptr ? std::exchange(_own_interpolation, -1) : -1;
	if (own_interpolation >= 0) {
		target->set_physics_interpolation_mode(Node::PhysicsInterpolationMode(own_interpolation));
		target = find_spatial(node);
		if (target != nullptr) {
			target->reset_physics_interpolation();
		}
	}
}

} // namespace ga_godot
