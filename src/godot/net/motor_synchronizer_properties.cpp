#include "godot/net/motor_synchronizer.hpp"

#include <godot_cpp/core/class_db.hpp>

// What the inspector shows, and the names that scripts use.

namespace ga_godot {

using godot::NodePath;
using godot::StringName;
using godot::TypedArray;
using godot::vformat;

void MotorSynchronizer::set_targets(const TypedArray<NodePath> &p_paths) {
	_paths = p_paths;
	_targets_stale = true;
	_watch_in = 0;
}

TypedArray<NodePath> MotorSynchronizer::get_targets() const {
	return _paths;
}

void MotorSynchronizer::set_target_group(const StringName &p_group) {
	_group = p_group;
	_targets_stale = true;
	_watch_in = 0;
}

StringName MotorSynchronizer::get_target_group() const {
	return _group;
}

void MotorSynchronizer::set_channel(int64_t p_channel) {
	ERR_FAIL_COND_MSG(p_channel < 0 || p_channel > 255, vformat("MotorSynchronizer: channel is 0 to 255, not %d.", p_channel));
	_channel = p_channel;
}

int64_t MotorSynchronizer::get_channel() const {
	return _channel;
}

void MotorSynchronizer::_bind_methods() {
	using godot::ClassDB;
	using godot::D_METHOD;
	using godot::MethodInfo;
	using godot::PropertyInfo;
	using godot::Variant;

	ClassDB::bind_method(D_METHOD("set_targets", "paths"), &MotorSynchronizer::set_targets);
	ClassDB::bind_method(D_METHOD("get_targets"), &MotorSynchronizer::get_targets);
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "targets", godot::PROPERTY_HINT_TYPE_STRING, vformat("%d/%d:Node3D", int64_t(Variant::NODE_PATH), int64_t(godot::PROPERTY_HINT_NODE_PATH_VALID_TYPES))), "set_targets", "get_targets");
	ClassDB::bind_method(D_METHOD("set_target_group", "group"), &MotorSynchronizer::set_target_group);
	ClassDB::bind_method(D_METHOD("get_target_group"), &MotorSynchronizer::get_target_group);
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "target_group"), "set_target_group", "get_target_group");
	bind_stream_properties();
	bind_playback_properties();
	ClassDB::bind_method(D_METHOD("set_channel", "channel"), &MotorSynchronizer::set_channel);
	ClassDB::bind_method(D_METHOD("get_channel"), &MotorSynchronizer::get_channel);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "channel", godot::PROPERTY_HINT_RANGE, "0,255,1"), "set_channel", "get_channel");

	ClassDB::bind_method(D_METHOD("add_target", "node"), &MotorSynchronizer::add_target);
	ClassDB::bind_method(D_METHOD("remove_target", "node"), &MotorSynchronizer::remove_target);
	ClassDB::bind_method(D_METHOD("get_active_targets"), &MotorSynchronizer::get_active_targets);
	ClassDB::bind_method(D_METHOD("teleport", "node"), &MotorSynchronizer::teleport);
	ClassDB::bind_method(D_METHOD("get_media_time", "peer"), &MotorSynchronizer::get_media_time);
	ClassDB::bind_method(D_METHOD("get_statistics"), &MotorSynchronizer::get_statistics);
	ClassDB::bind_method(D_METHOD("get_setup_warnings"), &MotorSynchronizer::get_setup_warnings);

	// For signals of the engine's and for its debugger.
	ClassDB::bind_method(D_METHOD("_on_peer_packet", "peer", "packet"), &MotorSynchronizer::_on_peer_packet);
	ClassDB::bind_method(D_METHOD("_on_target_exiting", "id"), &MotorSynchronizer::_on_target_exiting);
	ClassDB::bind_method(D_METHOD("_on_node_renamed", "node"), &MotorSynchronizer::_on_node_renamed);
	ClassDB::bind_method(D_METHOD("_get_monitor", "key"), &MotorSynchronizer::_get_monitor);

	const PropertyInfo node(Variant::OBJECT, "node", godot::PROPERTY_HINT_NODE_TYPE, "Node3D", godot::PROPERTY_USAGE_DEFAULT, "Node3D");
	ADD_SIGNAL(MethodInfo("target_added", node));
	ADD_SIGNAL(MethodInfo("target_removed", node));
	ADD_SIGNAL(MethodInfo("packet_rejected", PropertyInfo(Variant::INT, "peer"), PropertyInfo(Variant::STRING, "reason")));
}

} // namespace ga_godot
