#pragma once

#include "godot/freed_arguments.hpp"
#include "godot/net/playback_properties.hpp"
#include "godot/net/replicator.hpp"
#include "godot/net/stream_properties.hpp"
#include "godot/net/target_selection.hpp"
#include "godot/thread_guard.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/scene_multiplayer.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <cstdint>
#include <memory>

namespace ga_godot {

/// Replicates the poses of nodes between peers; doc_classes/MotorSynchronizer.xml documents it.
///
/// The node selects its targets. The Replicator, which all synchronizers of a MultiplayerAPI share, does the rest.
class MotorSynchronizer : public godot::Node, public StreamProperties<MotorSynchronizer>, public PlaybackProperties<MotorSynchronizer>, public MainThread<MotorSynchronizer> {
	GDCLASS(MotorSynchronizer, godot::Node)
	friend class StreamProperties<MotorSynchronizer>;
	friend class PlaybackProperties<MotorSynchronizer>;

public:
	/// The underlying type holds any integer that a script passes.
	enum LatencyPreset : int64_t {
		LATENCY_CUSTOM,
		LATENCY_RESPONSIVE,
		LATENCY_BALANCED,
		LATENCY_ECONOMICAL,
	};

	MotorSynchronizer();

	void set_targets(const godot::TypedArray<godot::NodePath> &paths);
	godot::TypedArray<godot::NodePath> get_targets() const { return _selection.paths(); }
	void set_target_group(const godot::StringName &group);
	godot::StringName get_target_group() const { return _selection.group(); }
	void set_latency_preset(LatencyPreset preset);
	LatencyPreset get_latency_preset() const;
	void set_position_tolerance_2d(double pixels) { set_number(&net::StreamSettings::position_tolerance_2d, pixels, net::POSITION_TOLERANCE_2D_RANGE, "position_tolerance_2d", "pixels"); }
	double get_position_tolerance_2d() const { return _settings.position_tolerance_2d; }
	void set_relay(bool relays) { change(_relay, relays); }
	bool is_relay() const { return _relay; }
	void set_channel(int64_t channel);
	int64_t get_channel() const { return _channel; }
	void set_priority(int64_t priority);
	int64_t get_priority() const { return _priority; }
	void set_hide_until_known(bool hides) { _hide_until_known = hides; }
	bool is_hide_until_known() const { return _hide_until_known; }
	void set_blend_time(double seconds);
	double get_blend_time() const { return _blend_time; }

	void add_target(godot::Node *node);
	void remove_target(godot::Node *node);
	godot::TypedArray<godot::Node> get_active_targets() const;
	void teleport(godot::Node *node);
	void free_target(godot::Node *node);
	double get_media_time(int64_t peer) const;
	godot::Dictionary get_statistics();
	godot::PackedStringArray get_setup_warnings() const;

	[[nodiscard]] const net::StreamSettings &stream_settings() const { return _settings; }
	[[nodiscard]] TargetSelection &selection() { return _selection; }
	[[nodiscard]] bool selects(const godot::Node *node) const { return _selection.selects(*this, node); }

	// Called by the engine's signals and monitors, not by scripts. A script can still emit these signals at any time.
	void _on_peer_packet(int64_t peer, const godot::PackedByteArray &packet);
	void _on_peer_disconnected(int64_t peer);
	void _on_physics_frame();
	void _on_target_exiting(int64_t id);
	void _on_node_renamed(godot::Node *node);
	godot::Variant _get_monitor(const godot::StringName &key);

	godot::PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	// Not _process: a script on the node that defines its own would replace it.
	void _notification(int what);

private:
	void start();
	void stop();
	bool is_in_main_thread();
	void update_replicator();
	void leave_replicator();
	void settings_changed();
	void limits_changed() { settings_changed(); }
	void watch_warnings();
	/// The own target `node` of a call of `method`. Prints an error and returns null if the call is invalid.
	Target *find_own_target(godot::Node *node, const char *method);

	// Called by the inspector.
	godot::PackedStringArray _get_linked_undo_properties(const godot::String &property, const godot::Variant &value) const;

	TargetSelection _selection;
	int64_t _channel = 0;
	int64_t _priority = 0;
	bool _relay = false;
	bool _hide_until_known = true;
	double _blend_time = 0.15;
	std::shared_ptr<Replicator> _replicator; // null until the first tick, and without a SceneMultiplayer
	bool _is_api_reported = false; // an unsupported MultiplayerAPI has been reported
	bool _is_thread_reported = false; // a sub-thread that processes the node has been reported
	bool _is_running = false;
	godot::PackedStringArray _shown_warnings;
	int64_t _frames_to_check = 0;
};

} // namespace ga_godot

VARIANT_ENUM_CAST(ga_godot::MotorSynchronizer::LatencyPreset);
