#include "godot/net/motor_synchronizer.hpp"

#include <godot_cpp/core/class_db.hpp>

#include <cmath>

// Properties, methods and signals.

namespace ga_godot {

using godot::NodePath;
using godot::StringName;
using godot::TypedArray;
using godot::vformat;

void MotorSynchronizer::set_targets(const TypedArray<NodePath> &paths) {
	_selection.set_paths(paths);
	_frames_to_check = 0;
}

void MotorSynchronizer::set_target_group(const StringName &group) {
	_selection.set_group(group);
	_frames_to_check = 0;
}

namespace {

struct Latency {
	double max_latency; // seconds
	double send_rate; // hertz
};

// Indexed by LatencyPreset.
constexpr Latency LATENCIES[] = { { 0.0, 0.0 }, { 0.05, 40.0 }, { 0.1, 20.0 }, { 0.2, 10.0 } };

} // namespace

void MotorSynchronizer::set_latency_preset(LatencyPreset preset) {
	ERR_FAIL_COND_MSG(preset < LATENCY_CUSTOM || preset > LATENCY_ECONOMICAL, vformat("MotorSynchronizer: latency_preset is %d, but must be LATENCY_CUSTOM (0), LATENCY_RESPONSIVE (1), LATENCY_BALANCED (2) or LATENCY_ECONOMICAL (3).", int64_t(preset)));
	if (preset != LATENCY_CUSTOM && preset != get_latency_preset()) {
		_settings.max_latency = LATENCIES[preset].max_latency;
		_settings.send_rate = LATENCIES[preset].send_rate;
		settings_changed();
	}
}

MotorSynchronizer::LatencyPreset MotorSynchronizer::get_latency_preset() const {
	for (const LatencyPreset preset : { LATENCY_RESPONSIVE, LATENCY_BALANCED, LATENCY_ECONOMICAL }) {
		const Latency &latency = LATENCIES[preset];
		if (std::fabs(_settings.max_latency - latency.max_latency) < 1e-6 && std::fabs(_settings.send_rate - latency.send_rate) < 1e-6) {
			return preset;
		}
	}
	return LATENCY_CUSTOM;
}

/// Undoing a change of the preset restores what the preset sets.
godot::PackedStringArray MotorSynchronizer::_get_linked_undo_properties(const godot::String &property, const godot::Variant & /*value*/) const {
	godot::PackedStringArray linked;
	if (property == godot::String("latency_preset")) {
		linked.push_back("max_latency");
		linked.push_back("send_rate");
	}
	return linked;
}

void MotorSynchronizer::set_channel(int64_t channel) {
	ERR_FAIL_COND_MSG(channel < 0 || channel > 255, vformat("MotorSynchronizer: channel is %d, but must be 0 to 255.", channel));
	_channel = channel;
}

void MotorSynchronizer::set_priority(int64_t priority) {
	ERR_FAIL_COND_MSG(!net::PRIORITY_RANGE.contains(double(priority)), vformat("MotorSynchronizer: priority is %d, but must be 0 to 8.", priority));
	_priority = priority;
	if (_replicator != nullptr) {
		_replicator->update_priorities(this);
	}
}

void MotorSynchronizer::set_blend_time(double seconds) {
	ERR_FAIL_COND_MSG(!net::DELAY_RANGE.contains(seconds), range_message("MotorSynchronizer", "blend_time", seconds, net::DELAY_RANGE, "seconds"));
	_blend_time = seconds;
}

void MotorSynchronizer::_bind_methods() {
	using godot::ClassDB;
	using godot::D_METHOD;
	using godot::MethodInfo;
	using godot::PropertyInfo;
	using godot::Variant;

	ClassDB::bind_method(D_METHOD("set_targets", "paths"), guarded<&MotorSynchronizer::set_targets>());
	ClassDB::bind_method(D_METHOD("get_targets"), guarded<&MotorSynchronizer::get_targets>());
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "targets", godot::PROPERTY_HINT_TYPE_STRING, vformat("%d/%d:Node3D,Node2D", int64_t(Variant::NODE_PATH), int64_t(godot::PROPERTY_HINT_NODE_PATH_VALID_TYPES))), "set_targets", "get_targets");
	ClassDB::bind_method(D_METHOD("set_target_group", "group"), guarded<&MotorSynchronizer::set_target_group>());
	ClassDB::bind_method(D_METHOD("get_target_group"), guarded<&MotorSynchronizer::get_target_group>());
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "target_group"), "set_target_group", "get_target_group");
	BIND_ENUM_CONSTANT(LATENCY_CUSTOM);
	BIND_ENUM_CONSTANT(LATENCY_RESPONSIVE);
	BIND_ENUM_CONSTANT(LATENCY_BALANCED);
	BIND_ENUM_CONSTANT(LATENCY_ECONOMICAL);
	// Not stored in scenes: max_latency and send_rate are.
	bind_property("preset", guarded<&MotorSynchronizer::set_latency_preset>(), guarded<&MotorSynchronizer::get_latency_preset>(), PropertyInfo(Variant::INT, "latency_preset", godot::PROPERTY_HINT_ENUM, "Custom,Responsive,Balanced,Economical", godot::PROPERTY_USAGE_EDITOR | godot::PROPERTY_USAGE_UPDATE_ALL_IF_MODIFIED));
	bind_stream_properties();
	bind_property("pixels", guarded<&MotorSynchronizer::set_position_tolerance_2d>(), guarded<&MotorSynchronizer::get_position_tolerance_2d>(), PropertyInfo(Variant::FLOAT, "position_tolerance_2d", godot::PROPERTY_HINT_RANGE, "0.01,10,0.01,or_greater,suffix:px"));
	bind_property("relays", guarded<&MotorSynchronizer::set_relay>(), guarded<&MotorSynchronizer::is_relay>(), PropertyInfo(Variant::BOOL, "relay"));
	bind_playback_properties();
	ClassDB::bind_method(D_METHOD("set_channel", "channel"), guarded<&MotorSynchronizer::set_channel>());
	ClassDB::bind_method(D_METHOD("get_channel"), guarded<&MotorSynchronizer::get_channel>());
	ADD_PROPERTY(PropertyInfo(Variant::INT, "channel", godot::PROPERTY_HINT_RANGE, "0,255,1"), "set_channel", "get_channel");
	bind_property("priority", guarded<&MotorSynchronizer::set_priority>(), guarded<&MotorSynchronizer::get_priority>(), PropertyInfo(Variant::INT, "priority", godot::PROPERTY_HINT_RANGE, "0,8,1"));

	bind_property("hides", guarded<&MotorSynchronizer::set_hide_until_known>(), guarded<&MotorSynchronizer::is_hide_until_known>(), PropertyInfo(Variant::BOOL, "hide_until_known"));
	bind_property("seconds", guarded<&MotorSynchronizer::set_blend_time>(), guarded<&MotorSynchronizer::get_blend_time>(), PropertyInfo(Variant::FLOAT, "blend_time", godot::PROPERTY_HINT_RANGE, "0,1,0.01,or_greater,suffix:s"));

	ClassDB::bind_method(D_METHOD("add_target", "node"), guarded<&MotorSynchronizer::add_target>());
	ClassDB::bind_method(D_METHOD("remove_target", "node"), guarded<&MotorSynchronizer::remove_target>());
	ClassDB::bind_method(D_METHOD("get_active_targets"), guarded<&MotorSynchronizer::get_active_targets>());
	ClassDB::bind_method(D_METHOD("teleport", "node"), guarded<&MotorSynchronizer::teleport>());
	ClassDB::bind_method(D_METHOD("free_target", "node"), guarded<&MotorSynchronizer::free_target>());
	ClassDB::bind_method(D_METHOD("get_media_time", "peer"), guarded<&MotorSynchronizer::get_media_time>());
	ClassDB::bind_method(D_METHOD("get_statistics"), guarded<&MotorSynchronizer::get_statistics>());
	ClassDB::bind_method(D_METHOD("get_setup_warnings"), guarded<&MotorSynchronizer::get_setup_warnings>());

	ClassDB::bind_method(D_METHOD("_get_linked_undo_properties", "property", "value"), guarded<&MotorSynchronizer::_get_linked_undo_properties>());

	const PropertyInfo node(Variant::OBJECT, "node", godot::PROPERTY_HINT_NODE_TYPE, "Node", godot::PROPERTY_USAGE_DEFAULT, "Node");
	ADD_SIGNAL(MethodInfo("target_added", node));
	ADD_SIGNAL(MethodInfo("target_removed", node));
	ADD_SIGNAL(MethodInfo("target_ended", node));
	ADD_SIGNAL(MethodInfo("packet_rejected", PropertyInfo(Variant::INT, "peer"), PropertyInfo(Variant::STRING, "reason")));
}

} // namespace ga_godot
