#include "godot/motion/multivector_lerp.hpp"

#include "cga/motor/deviation.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "godot/algebra/conversions.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/godot.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <algorithm>
#include <cmath>

namespace ga_godot {

using godot::Dictionary;
using godot::Node3D;
using godot::NodePath;
using godot::Object;
using godot::Ref;
using godot::Transform3D;
using godot::vformat;

static_assert(int(MultivectorLerp::LINEAR) == int(cga::Mode::LINEAR) && int(MultivectorLerp::SCREW) == int(cga::Mode::SCREW) && int(MultivectorLerp::SEPARATE) == int(cga::Mode::SEPARATE), "A mode is cast to the algebra's.");

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

Dictionary MultivectorLerp::measure_deviation(const Ref<Multivector> &p_from, const Ref<Multivector> &p_to, Mode p_first, Mode p_second, double p_lever) {
	cga::Pose<double> from, to;
	ERR_FAIL_COND_V_MSG(p_from.is_null() || !p_from->get_pose(from), Dictionary(), "MultivectorLerp.measure_deviation: from is no motor with positive scale; make one with Multivector.motor or motor_from.");
	ERR_FAIL_COND_V_MSG(p_to.is_null() || !p_to->get_pose(to), Dictionary(), "MultivectorLerp.measure_deviation: to is no motor with positive scale; make one with Multivector.motor or motor_from.");
	ERR_FAIL_COND_V_MSG(!is_mode(p_first), Dictionary(), vformat(UNKNOWN_MODE, int64_t(p_first)));
	ERR_FAIL_COND_V_MSG(!is_mode(p_second), Dictionary(), vformat(UNKNOWN_MODE, int64_t(p_second)));
	ERR_FAIL_COND_V_MSG(!std::isfinite(p_lever) || p_lever < 0.0, Dictionary(), "MultivectorLerp.measure_deviation: the lever must be a distance of 0 or more.");
	const cga::PathDeviation found = cga::path_deviation(from, to, cga::Mode(p_first), cga::Mode(p_second), p_lever);
	Dictionary result;
	result["distance"] = found.distance;
	result["distance_weight"] = found.distance_weight;
	result["angle"] = found.angle;
	result["angle_weight"] = found.angle_weight;
	return result;
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

void MultivectorLerp::relink(NodeLink &r_link, const NodePath &p_path) {
	r_link.path = p_path;
	r_link.id = 0;
	refresh();
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
	Node3D *node = r_link.node;
	if (r_link.id == 0 || godot::gdextension_interface::object_get_instance_from_id(r_link.id) == nullptr) {
		node = r_link.path.is_empty() ? nullptr : Object::cast_to<Node3D>(get_node_or_null(r_link.path));
		r_link.node = node;
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

} // namespace ga_godot
