#include "godot/multivector_lerp.hpp"

#include "cga/motor_multivector.hpp"
#include "godot/conversions.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <algorithm>
#include <cmath>

namespace ga_godot {

using godot::Node3D;
using godot::NodePath;
using godot::Object;
using godot::ObjectDB;
using godot::PackedStringArray;
using godot::Ref;
using godot::String;
using godot::Transform3D;
using godot::vformat;

static_assert(int(MultivectorLerp::LINEAR) == int(cga::Mode::LINEAR) && int(MultivectorLerp::SCREW) == int(cga::Mode::SCREW) && int(MultivectorLerp::SEPARATE) == int(cga::Mode::SEPARATE), "A mode is cast to the algebra's.");

static constexpr const char *UNKNOWN_MODE = "MultivectorLerp: mode %d is none of LINEAR (0), SCREW (1), SEPARATE (2).";

Ref<Multivector> MultivectorLerp::interpolate(const Ref<Multivector> &p_from, const Ref<Multivector> &p_to, double p_weight, Mode p_mode) {
	cga::Pose<double> from, to;
	ERR_FAIL_COND_V_MSG(p_from.is_null() || !p_from->get_pose(from), Ref<Multivector>(), "MultivectorLerp.interpolate: from is no motor with positive scale; make one with Multivector.motor or motor_from.");
	ERR_FAIL_COND_V_MSG(p_to.is_null() || !p_to->get_pose(to), Ref<Multivector>(), "MultivectorLerp.interpolate: to is no motor with positive scale; make one with Multivector.motor or motor_from.");
	ERR_FAIL_COND_V_MSG(!std::isfinite(p_weight), Ref<Multivector>(), "MultivectorLerp.interpolate: the weight is not finite.");
	ERR_FAIL_COND_V_MSG(!is_mode(p_mode), Ref<Multivector>(), vformat(UNKNOWN_MODE, int64_t(p_mode)));
	const cga::Pose<double> pose = cga::interpolate(from, to, p_weight, cga::Mode(p_mode));
	return Multivector::make(cga::to_multivector(cga::Motor<double>::from_pose(pose)));
}

Transform3D MultivectorLerp::interpolate_transform(const Transform3D &p_from, const Transform3D &p_to, double p_weight, Mode p_mode) {
	cga::Pose<double> from, to;
	const char *fault = pose_from_transform(p_from, from);
	ERR_FAIL_COND_V_MSG(fault != nullptr, p_from, vformat("MultivectorLerp.interpolate_transform: from %s.", fault));
	fault = pose_from_transform(p_to, to);
	ERR_FAIL_COND_V_MSG(fault != nullptr, p_from, vformat("MultivectorLerp.interpolate_transform: to %s.", fault));
	ERR_FAIL_COND_V_MSG(!std::isfinite(p_weight), p_from, "MultivectorLerp.interpolate_transform: the weight is not finite.");
	ERR_FAIL_COND_V_MSG(!is_mode(p_mode), p_from, vformat(UNKNOWN_MODE, int64_t(p_mode)));
	return to_godot(cga::interpolate(from, to, p_weight, cga::Mode(p_mode)));
}

void MultivectorLerp::relink(NodeLink &r_link, const NodePath &p_path) {
	r_link.path = p_path;
	r_link.id = 0;
	refresh();
}

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

void MultivectorLerp::play() {
	_playing = true;
	if (_factor >= 1.0) {
		set_factor(0.0);
	}
}

void MultivectorLerp::stop() {
	_playing = false;
}

bool MultivectorLerp::is_playing() const {
	return _playing;
}

void MultivectorLerp::_notification(int p_what) {
	if (p_what == NOTIFICATION_READY) {
		_running = !is_part_of_edited_scene();
		set_process(_running);
		if (_running && _auto_play) {
			play();
		}
		update_target();
	} else if (p_what == NOTIFICATION_PROCESS) {
		advance(get_process_delta_time());
	}
}

void MultivectorLerp::advance(double p_delta) {
	bool finished = false;
	if (_playing) {
		_factor = std::min(_factor + p_delta / _duration, 1.0);
		_stale = true;
		finished = _factor >= 1.0;
		_playing = !finished;
	}
	update_target();
	if (finished) {
		emit_signal("finished");
	}
}

// Something about the ends or the target changed: errors are reported anew.
void MultivectorLerp::refresh() {
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

// The node is remembered by id, which a freed node cannot fool, and looked up again when it is gone.
Node3D *MultivectorLerp::find_node(NodeLink &r_link, const char *p_name) {
	Node3D *node = r_link.id != 0 ? Object::cast_to<Node3D>(ObjectDB::get_instance(r_link.id)) : nullptr;
	if (node == nullptr) {
		node = r_link.path.is_empty() ? nullptr : Object::cast_to<Node3D>(get_node_or_null(r_link.path));
		r_link.id = node != nullptr ? node->get_instance_id() : 0;
	}
	if (node == nullptr || !node->is_inside_tree()) {
		// An end that is not set yet is no error; the scene dock warns of it.
		if (!r_link.lost && !r_link.path.is_empty()) {
			ERR_PRINT(vformat("MultivectorLerp: %s (\"%s\") leads to no Node3D in the scene; the target stays where it is.", p_name, r_link.path));
		}
		r_link.lost = true;
		return nullptr;
	}
	r_link.lost = false;
	return node;
}

// Brings the pose of an end up to date. False if it has none, which is reported once.
bool MultivectorLerp::read_end(End &r_end, const char *p_name) {
	const char *fault = nullptr;
	if (r_end.motor.is_valid()) {
		if (r_end.known && r_end.motor_revision == r_end.motor->get_revision()) {
			return !r_end.faulty;
		}
		r_end.motor_revision = r_end.motor->get_revision();
		fault = r_end.motor->get_pose(r_end.pose) ? nullptr : "is no motor with positive scale; make one with Multivector.motor or motor_from";
	} else {
		const Node3D *node = find_node(r_end, p_name);
		if (node == nullptr) {
			return false;
		}
		const Transform3D transform = _local ? node->get_transform() : node->get_global_transform();
		if (r_end.known && transform == r_end.transform) {
			return !r_end.faulty;
		}
		r_end.transform = transform;
		fault = pose_from_transform(transform, r_end.pose);
	}
	r_end.known = true;
	_stale = true;
	if (fault != nullptr && !r_end.faulty) {
		ERR_PRINT(vformat("MultivectorLerp: %s %s. The target stays where it is.", p_name, fault));
	}
	r_end.faulty = fault != nullptr;
	return !r_end.faulty;
}

void MultivectorLerp::update_target() {
	if (!_running || !is_inside_tree()) {
		return;
	}
	if (!read_end(_start, "start") || !read_end(_end, "end")) {
		return;
	}
	Node3D *target = find_node(_target, "target");
	if (target == nullptr) {
		return;
	}
	if (_stale) {
		_result = to_godot(cga::interpolate(_start.pose, _end.pose, _factor, cga::Mode(_mode)));
		_stale = false;
		if (_local) {
			target->set_transform(_result);
		}
	}
	if (!_local) {
		// In each frame: the target's parent may have moved.
		target->set_global_transform(_result);
	}
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
