#pragma once

#include "godot/net/playback_properties.hpp"
#include "godot/net/statistics_monitors.hpp"
#include "godot/net/stream_properties.hpp"
#include "godot/net/target.hpp"
#include "godot/net/target_selection.hpp"
#include "net/session/session.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/scene_multiplayer.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace ga_godot {

/// Replicates the poses of nodes between peers; doc_classes/MotorSynchronizer.xml documents it.
///
/// The synchronizer maps nodes to bodies and connects a net::Session to the engine. In each physics tick it passes the poses
/// of the nodes over which this peer has authority to the session. In each frame it moves the other nodes.
class MotorSynchronizer : public godot::Node, public StreamProperties<MotorSynchronizer>, public PlaybackProperties<MotorSynchronizer> {
	GDCLASS(MotorSynchronizer, godot::Node)
	friend class StreamProperties<MotorSynchronizer>;
	friend class PlaybackProperties<MotorSynchronizer>;

public:
	MotorSynchronizer();

	void set_targets(const godot::TypedArray<godot::NodePath> &paths);
	godot::TypedArray<godot::NodePath> get_targets() const { return _selection.paths(); }
	void set_target_group(const godot::StringName &group);
	godot::StringName get_target_group() const { return _selection.group(); }
	void set_channel(int64_t channel);
	int64_t get_channel() const { return _channel; }

	void add_target(godot::Node3D *node);
	void remove_target(godot::Node3D *node);
	godot::TypedArray<godot::Node3D> get_active_targets() const;
	void teleport(godot::Node3D *node);
	double get_media_time(int64_t peer) const;
	godot::Dictionary get_statistics();
	godot::PackedStringArray get_setup_warnings() const;
	bool selects(const godot::Node3D *node) const { return _selection.selects(*this, node); }

	godot::PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	// Not _process: a script on the node that defines its own would replace it.
	void _notification(int what);

private:
	// Lifecycle
	void start();
	void stop();
	void physics_tick();
	void frame();
	void settings_changed();
	void limits_changed();
	void watch_warnings();

	// Connection
	void update_connection();
	void disconnect_session();
	void update_peers();
	void update_root();
	void close_session();
	void send_packets();
	void _on_peer_packet(int64_t peer, const godot::PackedByteArray &packet);
	godot::Variant _get_monitor(const godot::StringName &key);

	// Targets
	void refresh_targets();
	bool claim_body(const Target &target);
	void end_target(size_t index);
	void rename_targets();
	void sample_targets();
	void show_streams();
	void _on_target_exiting(int64_t id);
	void _on_node_renamed(const godot::Variant &node);

	godot::String relative_path(const godot::Node *node) const;

	TargetSelection _selection;
	int64_t _channel = 0;
	std::vector<Target> _targets;
	std::vector<uint64_t> _found; // ids found by the last search; empty if _targets has changed since
	std::unordered_map<uint32_t, uint64_t> _node_of_body;
	std::vector<uint64_t> _refused; // nodes reported because their paths have the same hash as another target's

	net::Session _session{ _settings };
	godot::Ref<godot::SceneMultiplayer> _api;
	uint64_t _transport = 0; // instance id of the MultiplayerPeer
	bool _is_api_reported = false; // an unsupported MultiplayerAPI has been reported
	godot::String _root; // path of the MultiplayerAPI's root, with a trailing slash
	bool _are_names_stale = false;
	bool _is_running = false;

	StatisticsMonitors _monitors;
	godot::PackedStringArray _shown_warnings;
	int64_t _frames_to_check = 0;
};

} // namespace ga_godot
