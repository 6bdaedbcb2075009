#include "godot/motion/multivector_lerp.hpp"

#include "cga/motor/deviation.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "godot/algebra/conversions.hpp"
#include "godot/bind_property.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/godot.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace ga_godot {

using godot::Dictionary;
using godot::Node3D;
using godot::NodePath;
using godot::Object;
using godot::PackedStringArray;
using godot::Ref;
using godot::Transform3D;
using godot::vformat;

static_assert(int(MultivectorLerp::LINEAR) == int(cga::Mode::LINEAR) && int(MultivectorLerp::SCREW) == int(cga::Mode::SCREW) && int(MultivectorLerp::SEPARATE) == int(cga::Mode::SEPARATE), "Modes are cast to cga::Mode.");

static constexpr const char *NOT_A_MOTOR = "is not a motor with a positive scale; create one with Multivector.motor or Multivector.motor_from";
static constexpr const char *INVALID_MODE = "MultivectorLerp: mode %d is invalid; use LINEAR (0), SCREW (1) or SEPARATE (2).";

static std::optional<cga::Pose<double>> pose_of(const Ref<Multivector> &motor) {
	return motor.is_valid() ? motor->get_pose() : std::nullopt;
}

Ref<Multivector> MultivectorLerp::interpolate(const Ref<Multivector> &from, const Ref<Multivector> &to, double weight, Mode mode) {
	const std::optional<cga::Pose<double>> from_pose = pose_of(from);
	const std::optional<cga::Pose<double>> to_pose = pose_of(to);
	ERR_FAIL_COND_V_MSG(!from_pose, Ref<Multivector>(), vformat("MultivectorLerp.interpolate: from %s.", NOT_A_MOTOR));
	ERR_FAIL_COND_V_MSG(!to_pose, Ref<Multivector>(), vformat("MultivectorLerp.interpolate: to %s.", NOT_A_MOTOR));
	ERR_FAIL_COND_V_MSG(!std::isfinite(weight), Ref<Multivector>(), "MultivectorLerp.interpolate: the weight is not finite.");
	ERR_FAIL_COND_V_MSG(!is_mode(mode), Ref<Multivector>(), vformat(INVALID_MODE, int64_t(mode)));
	const cga::Pose<double> pose = cga::interpolate(*from_pose, *to_pose, weight, cga::Mode(mode));
	return Multivector::make(cga::to_multivector(cga::Motor<double>::from_pose(pose)));
}

Transform3D MultivectorLerp::interpolate_transform(const Transform3D &from, const Transform3D &to, double weight, Mode mode) {
	const PoseResult from_pose = pose_from_transform(from);
	const PoseResult to_pose = pose_from_transform(to);
	ERR_FAIL_COND_V_MSG(!from_pose, from, vformat("MultivectorLerp.interpolate_transform: from %s.", cga::describe(from_pose.error())));
	ERR_FAIL_COND_V_MSG(!to_pose, from, vformat("MultivectorLerp.interpolate_transform: to %s.", cga::describe(to_pose.error())));
	ERR_FAIL_COND_V_MSG(!std::isfinite(weight), from, "MultivectorLerp.interpolate_transform: the weight is not finite.");
	ERR_FAIL_COND_V_MSG(!is_mode(mode), from, vformat(INVALID_MODE, int64_t(mode)));
	return to_godot(cga::interpolate(*from_pose, *to_pose, weight, cga::Mode(mode)));
}

Dictionary MultivectorLerp::measure_deviation(const Ref<Multivector> &from, const Ref<Multivector> &to, Mode first, Mode second, double lever_arm) {
	const std::optional<cga::Pose<double>> from_pose = pose_of(from);
	const std::optional<cga::Pose<double>> to_pose = pose_of(to);
	ERR_FAIL_COND_V_MSG(!from_pose, Dictionary(), vformat("MultivectorLerp.measure_deviation: from %s.", NOT_A_MOTOR));
	ERR_FAIL_COND_V_MSG(!to_pose, Dictionary(), vformat("MultivectorLerp.measure_deviation: to %s.", NOT_A_MOTOR));
	ERR_FAIL_COND_V_MSG(!is_mode(first), Dictionary(), vformat(INVALID_MODE, int64_t(first)));
	ERR_FAIL_COND_V_MSG(!is_mode(second), Dictionary(), vformat(INVALID_MODE, int64_t(second)));
	ERR_FAIL_COND_V_MSG(!std::isfinite(lever_arm) || lever_arm < 0.0, Dictionary(), vformat("MultivectorLerp.measure_deviation: lever_arm must be a finite distance of at least 0, not %f.", lever_arm));
	const cga::PathDeviation deviation = cga::path_deviation(*from_pose, *to_pose, cga::Mode(first), cga::Mode(second), lever_arm);
	Dictionary result;
	result["distance"] = deviation.distance;
	result["distance_weight"] = deviation.distance_weight;
	result["angle"] = deviation.angle;
	result["angle_weight"] = deviation.angle_weight;
	return result;
}

void MultivectorLerp::play() {
	_playing = true;
	if (_factor >= 1.0) {
		set_factor(0.0);
	}
}

void MultivectorLerp::_notification(int what) {
	if (what == NOTIFICATION_PREDELETE) {
		_free_guard.before_free(*this);
		return;
	}
	const FreeGuard::Scope scope(_free_guard);
	if (what == NOTIFICATION_READY) {
		_running = !is_part_of_edited_scene();
		set_process(_running);
		if (_running && _auto_play) {
			play();
		}
		update_target();
	} else if (what == NOTIFICATION_PROCESS) {
		advance(get_process_delta_time());
	}
}

void MultivectorLerp::advance(double delta) {
	bool finished = false;
	if (_playing) {
		_factor = std::min(_factor + delta / _duration, 1.0);
		_stale = true;
		finished = _factor >= 1.0;
		_playing = !finished;
	}
	update_target();
	if (finished) {
		emit_signal("finished");
	}
}

void MultivectorLerp::set_path(NodeLink &link, const NodePath &path) {
	link.path = path;
	link.node = {};
	refresh();
}

void MultivectorLerp::set_motor(End &end, const Ref<Multivector> &motor) {
	end.motor = motor;
	refresh();
}

// Called when an end or the target changes. Errors that persist are printed again.
void MultivectorLerp::refresh() {
	const FreeGuard::Scope scope(_free_guard);
	for (End *end : { &_start, &_end }) {
		end->known = false;
		end->faulty = false;
		end->lost = false;
	}
	_target.lost = false;
	_stale = true;
	if (is_inside_tree()) {
		update_configuration_warnings();
		update_target();
	}
}

// Resolves the path again if the node was freed.
Node3D *MultivectorLerp::find_node(NodeLink &link, const char *name) {
	Node3D *node = link.node.get();
	if (node == nullptr) {
		node = link.path.is_empty() ? nullptr : Object::cast_to<Node3D>(get_node_or_null(link.path));
		link.node = WeakNode<Node3D>(node);
	}
	if (node == nullptr || !node->is_inside_tree()) {
		// The scene dock warns about an empty path.
		if (!std::exchange(link.lost, true) && !link.path.is_empty()) {
			ERR_PRINT(vformat("MultivectorLerp: %s (\"%s\") does not lead to a Node3D in the scene tree; the target is not moved.", name, link.path));
		}
		return nullptr;
	}
	link.lost = false;
	return node;
}

// Updates the pose of an end. Returns false if the end has no pose, which is reported once.
bool MultivectorLerp::update_end(End &end, const char *name) {
	const char *fault = nullptr;
	if (end.motor.is_valid()) {
		if (end.known && end.motor_revision == end.motor->get_revision()) {
			return !end.faulty;
		}
		end.motor_revision = end.motor->get_revision();
		const std::optional<cga::Pose<double>> pose = end.motor->get_pose();
		fault = pose ? nullptr : NOT_A_MOTOR;
		end.pose = pose.value_or(end.pose);
	} else {
		const Node3D *node = find_node(end, name);
		if (node == nullptr) {
			return false;
		}
		const Transform3D transform = _local ? node->get_transform() : node->get_global_transform();
		if (end.known && transform == end.transform) {
			return !end.faulty;
		}
		end.transform = transform;
		const PoseResult pose = pose_from_transform(transform);
		fault = pose ? nullptr : cga::describe(pose.error());
		end.pose = pose ? *pose : end.pose;
	}
	end.known = true;
	_stale = true;
	const bool is_new = fault != nullptr && !end.faulty;
	end.faulty = fault != nullptr;
	if (is_new) {
		ERR_PRINT(vformat("MultivectorLerp: %s %s. The target is not moved.", name, fault));
	}
	return fault == nullptr;
}

void MultivectorLerp::update_target() {
	if (!_running || !is_inside_tree()) {
		return;
	}
	const FreeGuard::Scope scope(_free_guard);
	if (!update_end(_start, "start") || !update_end(_end, "end")) {
		return;
	}
	Node3D *target = find_node(_target, "target");
	if (target == nullptr) {
		return;
	}
	const bool is_new = std::exchange(_stale, false);
	if (is_new) {
		_result = to_godot(cga::interpolate(_start.pose, _end.pose, _factor, cga::Mode(_mode)));
	}
	const Transform3D result = _result; // The target's callbacks may change it.
	if (!_local) {
		// Set even without a new result, because the target's parent may have moved.
		target->set_global_transform(result);
	} else if (is_new) {
		target->set_transform(result);
	}
}

void MultivectorLerp::set_factor(double factor) {
	ERR_FAIL_COND_MSG(!std::isfinite(factor), "MultivectorLerp: factor must be finite; it is unchanged.");
	_factor = std::clamp(factor, 0.0, 1.0);
	_stale = true;
	update_target();
}

void MultivectorLerp::set_local(bool local) {
	_local = local;
	refresh();
}

void MultivectorLerp::set_mode(Mode mode) {
	ERR_FAIL_COND_MSG(!is_mode(mode), vformat(INVALID_MODE, int64_t(mode)));
	_mode = mode;
	_stale = true;
	update_target();
}

void MultivectorLerp::set_duration(double seconds) {
	ERR_FAIL_COND_MSG(!std::isfinite(seconds) || !(seconds > 0.0), vformat("MultivectorLerp: duration must be a positive number of seconds, not %f.", seconds));
	_duration = seconds;
}

PackedStringArray MultivectorLerp::_get_configuration_warnings() const {
	PackedStringArray warnings;
	const auto check = [&](const char *name, const NodePath &path) {
		if (Object::cast_to<Node3D>(path.is_empty() ? nullptr : get_node_or_null(path)) == nullptr) {
			warnings.push_back(vformat("\"%s\" does not lead to a Node3D. Assign one in the inspector.", name));
		}
	};
	const auto check_end = [&](const char *name, const End &end) {
		if (end.motor.is_null()) {
			check(name, end.path);
		} else if (!end.motor->get_pose()) {
			warnings.push_back(vformat("\"%s_motor\" is not a motor with a positive scale. Clear it to use \"%s\", or assign one made by Multivector.motor.", name, name));
		}
	};
	check_end("start", _start);
	check_end("end", _end);
	check("target", _target.path);
	return warnings;
}

void MultivectorLerp::_bind_methods() {
	using godot::ClassDB;
	using godot::D_METHOD;
	using godot::PropertyInfo;
	using godot::Variant;

	BIND_ENUM_CONSTANT(LINEAR);
	BIND_ENUM_CONSTANT(SCREW);
	BIND_ENUM_CONSTANT(SEPARATE);

	ClassDB::bind_static_method("MultivectorLerp", D_METHOD("interpolate", "from", "to", "weight", "mode"), &MultivectorLerp::interpolate);
	ClassDB::bind_static_method("MultivectorLerp", D_METHOD("interpolate_transform", "from", "to", "weight", "mode"), &MultivectorLerp::interpolate_transform);
	ClassDB::bind_static_method("MultivectorLerp", D_METHOD("measure_deviation", "from", "to", "first", "second", "lever_arm"), &MultivectorLerp::measure_deviation, DEFVAL(1.0));

	ClassDB::bind_method(D_METHOD("play"), guarded<&MultivectorLerp::play>());
	ClassDB::bind_method(D_METHOD("stop"), guarded<&MultivectorLerp::stop>());
	ClassDB::bind_method(D_METHOD("is_playing"), guarded<&MultivectorLerp::is_playing>());

	using godot::PROPERTY_HINT_ENUM;
	using godot::PROPERTY_HINT_NODE_PATH_VALID_TYPES;
	using godot::PROPERTY_HINT_RANGE;
	using godot::PROPERTY_HINT_RESOURCE_TYPE;
	bind_property("path", guarded<&MultivectorLerp::set_start>(), guarded<&MultivectorLerp::get_start>(), PropertyInfo(Variant::NODE_PATH, "start", PROPERTY_HINT_NODE_PATH_VALID_TYPES, "Node3D"));
	bind_property("path", guarded<&MultivectorLerp::set_end>(), guarded<&MultivectorLerp::get_end>(), PropertyInfo(Variant::NODE_PATH, "end", PROPERTY_HINT_NODE_PATH_VALID_TYPES, "Node3D"));
	bind_property("path", guarded<&MultivectorLerp::set_target>(), guarded<&MultivectorLerp::get_target>(), PropertyInfo(Variant::NODE_PATH, "target", PROPERTY_HINT_NODE_PATH_VALID_TYPES, "Node3D"));
	bind_property("motor", guarded<&MultivectorLerp::set_start_motor>(), guarded<&MultivectorLerp::get_start_motor>(), PropertyInfo(Variant::OBJECT, "start_motor", PROPERTY_HINT_RESOURCE_TYPE, "Multivector"));
	bind_property("motor", guarded<&MultivectorLerp::set_end_motor>(), guarded<&MultivectorLerp::get_end_motor>(), PropertyInfo(Variant::OBJECT, "end_motor", PROPERTY_HINT_RESOURCE_TYPE, "Multivector"));
	bind_property("factor", guarded<&MultivectorLerp::set_factor>(), guarded<&MultivectorLerp::get_factor>(), PropertyInfo(Variant::FLOAT, "factor", PROPERTY_HINT_RANGE, "0,1,0.001"));
	bind_property("mode", guarded<&MultivectorLerp::set_mode>(), guarded<&MultivectorLerp::get_mode>(), PropertyInfo(Variant::INT, "mode", PROPERTY_HINT_ENUM, "Linear,Screw,Separate"));
	bind_property("local", guarded<&MultivectorLerp::set_local>(), guarded<&MultivectorLerp::is_local>(), PropertyInfo(Variant::BOOL, "local"));
	bind_property("auto_play", guarded<&MultivectorLerp::set_auto_play>(), guarded<&MultivectorLerp::is_auto_play>(), PropertyInfo(Variant::BOOL, "auto_play"));
	bind_property("seconds", guarded<&MultivectorLerp::set_duration>(), guarded<&MultivectorLerp::get_duration>(), PropertyInfo(Variant::FLOAT, "duration", PROPERTY_HINT_RANGE, "0.01,60,0.01,or_greater,suffix:s"));

	ADD_SIGNAL(godot::MethodInfo("finished"));
}

} // namespace ga_godot
