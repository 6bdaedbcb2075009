#include "godot/motion/multivector_lerp.hpp"

#include "godot/algebra/conversions.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <algorithm>
#include <cmath>

// What the inspector shows: properties, warnings, and the names that scripts use.

namespace ga_godot {

using godot::Node3D;
using godot::NodePath;
using godot::Object;
using godot::PackedStringArray;
using godot::Ref;
using godot::vformat;

void MultivectorLerp::set_start(const NodePath &p_path) {
	relink(_start, p_path);
}

NodePath MultivectorLerp::get_start() const {
	return _start.path;
}

void MultivectorLerp::set_end(const NodePath &p_path) {
	relink(_end, p_path);
}

NodePath MultivectorLerp::get_end() const {
	return _end.path;
}

void MultivectorLerp::set_target(const NodePath &p_path) {
	relink(_target, p_path);
}

NodePath MultivectorLerp::get_target() const {
	return _target.path;
}

void MultivectorLerp::set_start_motor(const Ref<Multivector> &p_motor) {
	_start.motor = p_motor;
	refresh();
}

Ref<Multivector> MultivectorLerp::get_start_motor() const {
	return _start.motor;
}

void MultivectorLerp::set_end_motor(const Ref<Multivector> &p_motor) {
	_end.motor = p_motor;
	refresh();
}

Ref<Multivector> MultivectorLerp::get_end_motor() const {
	return _end.motor;
}

void MultivectorLerp::set_factor(double p_factor) {
	ERR_FAIL_COND_MSG(!std::isfinite(p_factor), "MultivectorLerp: factor is not finite; it stays as it was.");
	_factor = std::clamp(p_factor, 0.0, 1.0);
	_stale = true;
	update_target();
}

double MultivectorLerp::get_factor() const {
	return _factor;
}

void MultivectorLerp::set_mode(Mode p_mode) {
	ERR_FAIL_COND_MSG(!is_mode(p_mode), vformat(UNKNOWN_MODE, int64_t(p_mode)));
	_mode = p_mode;
	_stale = true;
	update_target();
}

MultivectorLerp::Mode MultivectorLerp::get_mode() const {
	return _mode;
}

void MultivectorLerp::set_local(bool p_local) {
	_local = p_local;
	refresh();
}

bool MultivectorLerp::is_local() const {
	return _local;
}

void MultivectorLerp::set_auto_play(bool p_auto_play) {
	_auto_play = p_auto_play;
}

bool MultivectorLerp::is_auto_play() const {
	return _auto_play;
}

void MultivectorLerp::set_duration(double p_seconds) {
	ERR_FAIL_COND_MSG(!std::isfinite(p_seconds) || !(p_seconds > 0.0), vformat("MultivectorLerp: duration is in seconds and positive, not %f.", p_seconds));
	_duration = p_seconds;
}

double MultivectorLerp::get_duration() const {
	return _duration;
}

PackedStringArray MultivectorLerp::_get_configuration_warnings() const {
	PackedStringArray warnings;
	const auto check = [&](const char *p_name, const NodePath &p_path) {
		if (Object::cast_to<Node3D>(p_path.is_empty() ? nullptr : get_node_or_null(p_path)) == nullptr) {
			warnings.push_back(vformat("\"%s\" does not lead to a Node3D. Assign one in the inspector.", p_name));
		}
	};
	const auto check_end = [&](const char *p_name, const End &p_end) {
		cga::Pose<double> pose;
		if (p_end.motor.is_null()) {
			check(p_name, p_end.path);
		} else if (!p_end.motor->get_pose(pose)) {
			warnings.push_back(vformat("\"%s_motor\" is no motor with positive scale. Clear it to use \"%s\", or make it with Multivector.motor.", p_name, p_name));
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
	ClassDB::bind_static_method("MultivectorLerp", D_METHOD("measure_deviation", "from", "to", "first", "second", "lever"), &MultivectorLerp::measure_deviation, DEFVAL(1.0));

	ClassDB::bind_method(D_METHOD("set_start", "path"), &MultivectorLerp::set_start);
	ClassDB::bind_method(D_METHOD("get_start"), &MultivectorLerp::get_start);
	ClassDB::bind_method(D_METHOD("set_end", "path"), &MultivectorLerp::set_end);
	ClassDB::bind_method(D_METHOD("get_end"), &MultivectorLerp::get_end);
	ClassDB::bind_method(D_METHOD("set_target", "path"), &MultivectorLerp::set_target);
	ClassDB::bind_method(D_METHOD("get_target"), &MultivectorLerp::get_target);
	ClassDB::bind_method(D_METHOD("set_start_motor", "motor"), &MultivectorLerp::set_start_motor);
	ClassDB::bind_method(D_METHOD("get_start_motor"), &MultivectorLerp::get_start_motor);
	ClassDB::bind_method(D_METHOD("set_end_motor", "motor"), &MultivectorLerp::set_end_motor);
	ClassDB::bind_method(D_METHOD("get_end_motor"), &MultivectorLerp::get_end_motor);
	ClassDB::bind_method(D_METHOD("set_factor", "factor"), &MultivectorLerp::set_factor);
	ClassDB::bind_method(D_METHOD("get_factor"), &MultivectorLerp::get_factor);
	ClassDB::bind_method(D_METHOD("set_mode", "mode"), &MultivectorLerp::set_mode);
	ClassDB::bind_method(D_METHOD("get_mode"), &MultivectorLerp::get_mode);
	ClassDB::bind_method(D_METHOD("set_local", "local"), &MultivectorLerp::set_local);
	ClassDB::bind_method(D_METHOD("is_local"), &MultivectorLerp::is_local);
	ClassDB::bind_method(D_METHOD("set_auto_play", "auto_play"), &MultivectorLerp::set_auto_play);
	ClassDB::bind_method(D_METHOD("is_auto_play"), &MultivectorLerp::is_auto_play);
	ClassDB::bind_method(D_METHOD("set_duration", "seconds"), &MultivectorLerp::set_duration);
	ClassDB::bind_method(D_METHOD("get_duration"), &MultivectorLerp::get_duration);
	ClassDB::bind_method(D_METHOD("play"), &MultivectorLerp::play);
	ClassDB::bind_method(D_METHOD("stop"), &MultivectorLerp::stop);
	ClassDB::bind_method(D_METHOD("is_playing"), &MultivectorLerp::is_playing);

	using godot::PROPERTY_HINT_ENUM;
	using godot::PROPERTY_HINT_NODE_PATH_VALID_TYPES;
	using godot::PROPERTY_HINT_RANGE;
	using godot::PROPERTY_HINT_RESOURCE_TYPE;
	ADD_PROPERTY(PropertyInfo(Variant::NODE_PATH, "start", PROPERTY_HINT_NODE_PATH_VALID_TYPES, "Node3D"), "set_start", "get_start");
	ADD_PROPERTY(PropertyInfo(Variant::NODE_PATH, "end", PROPERTY_HINT_NODE_PATH_VALID_TYPES, "Node3D"), "set_end", "get_end");
	ADD_PROPERTY(PropertyInfo(Variant::NODE_PATH, "target", PROPERTY_HINT_NODE_PATH_VALID_TYPES, "Node3D"), "set_target", "get_target");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "start_motor", PROPERTY_HINT_RESOURCE_TYPE, "Multivector"), "set_start_motor", "get_start_motor");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "end_motor", PROPERTY_HINT_RESOURCE_TYPE, "Multivector"), "set_end_motor", "get_end_motor");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "factor", PROPERTY_HINT_RANGE, "0,1,0.001"), "set_factor", "get_factor");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "mode", PROPERTY_HINT_ENUM, "Linear,Screw,Separate"), "set_mode", "get_mode");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "local"), "set_local", "is_local");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "auto_play"), "set_auto_play", "is_auto_play");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "duration", PROPERTY_HINT_RANGE, "0.01,60,0.01,or_greater,suffix:s"), "set_duration", "get_duration");

	ADD_SIGNAL(godot::MethodInfo("finished"));
}

} // namespace ga_godot
