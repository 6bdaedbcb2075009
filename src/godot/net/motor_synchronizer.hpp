#pragma once

#include "godot/net/playback_properties.hpp"
#include "godot/net/stream_properties.hpp"
#include "godot/net/traffic_meter.hpp"
#include "net/session/envelope.hpp"
#include "net/endpoint/receiver.hpp"
#include "net/endpoint/sender.hpp"

#include <godot_cpp/classes/multiplayer_peer.hpp>
#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/scene_multiplayer.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

namespace ga_godot {

/// Replicates the poses of nodes between peers; doc_classes/MotorSynchronizer.xml documents it.
///
/// Each target's authority sends it. A peer's node holds one net::Sender for the targets that are its own, and one
/// net::Receiver for each peer that is the authority of others. A receiver opens a stream by a hello, repeated until
/// something comes, so that it does not matter which side is there first (see net/envelope.hpp).
///
/// Its files: _targets (what is replicated), _links (who gets what from whom), _packets, _poses (from nodes to streams and
/// back), _statistics, _warnings, _properties.
class MotorSynchronizer : public godot::Node, public StreamProperties<MotorSynchronizer>, public PlaybackProperties<MotorSynchronizer> {
	GDCLASS(MotorSynchronizer, godot::Node)
	friend class StreamProperties<MotorSynchronizer>;
	friend class PlaybackProperties<MotorSynchronizer>;

public:
	MotorSynchronizer();

	void set_targets(const godot::TypedArray<godot::NodePath> &p_paths);
	godot::TypedArray<godot::NodePath> get_targets() const;
	void set_target_group(const godot::StringName &p_group);
	godot::StringName get_target_group() const;
	void set_channel(int64_t p_channel);
	int64_t get_channel() const;

	void add_target(godot::Node3D *p_node);
	void remove_target(godot::Node3D *p_node);
	godot::TypedArray<godot::Node3D> get_active_targets() const;
	void teleport(godot::Node3D *p_node);
	double get_media_time(int64_t p_peer) const;
	godot::Dictionary get_statistics();
	godot::PackedStringArray get_setup_warnings() const;

	godot::PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	// Not _process: a script on the node that has its own would silence it.
	void _notification(int p_what);

private:
	/// A node that is replicated and in the tree.
	struct Target {
		uint64_t node = 0; // instance id
		uint32_t body = 0; // the same on all peers
		int32_t authority = 0; // 0 until it was first looked at
		bool sent = false; // _sender has the body
		bool posed = false; // transform and pose are those of the last sample
		bool faulty = false; // its transform is no pose, which was reported
		bool uneven = false; // its scale is not uniform, which was reported
		int32_t own_interpolation = -1; // its physics_interpolation_mode, put aside while a stream moves it
		godot::Transform3D transform;
		cga::Pose<double> pose;
		cga::Pose<double> sent_pose; // the last that _sender took
	};

	/// What there is between this node and the one of another peer. Only connected peers have one.
	struct Peer {
		TrafficMeter sent;
		TrafficMeter received;
		// It gets our stream.
		bool subscribed = false;
		uint8_t subscription = 0; // its link
		double subscribed_at = 0.0;
		// We get its stream.
		std::unique_ptr<net::Receiver> stream;
		uint8_t link = 0;
		size_t max_bodies = 0;
		double hello_due = 0.0;
		double ended_at = -1e9; // when a stream in either direction ended: packets may still be on their way
		uint64_t foreign_bodies = 0;
		// What was refused.
		uint64_t rejected = 0;
		uint64_t unreported = 0;
		double reported_at = -1e9;
		const char *reason = nullptr;
	};

	/// One column of the statistics.
	struct Figures;

	static constexpr const char *GROUP = "_ga_godot_motor_synchronizers";

	static godot::Node3D *node_of(uint64_t p_id); // null if it is gone
	static double clock(); // seconds

	// Targets
	bool is_refresh_due();
	void refresh_targets();
	std::vector<uint64_t> find_targets();
	bool begin_target(uint64_t p_id);
	bool claim_body(const Target &p_target);
	void end_target(size_t p_index);
	void rename_targets();
	uint32_t body_of(const godot::Node3D *p_node) const;
	Target *find_target(uint64_t p_id);
	void _on_target_exiting(int64_t p_id);
	void _on_node_renamed(const godot::Variant &p_node);

	// Links
	void update_connection();
	void leave_connection();
	void update_key();
	void update_peers();
	void update_streams();
	void open_stream(Peer &r_peer);
	void forget_stream(Peer &r_peer);
	void subscribe(int32_t p_id, uint8_t p_link, double p_now);
	void unsubscribe(int32_t p_id, Peer &r_peer);
	void send_hellos();
	void say_goodbye();
	bool is_connected_peer(int32_t p_id) const;
	godot::String relative_path(const godot::Node *p_node) const;

	// Packets
	void send(int32_t p_id, Peer &r_peer, net::PacketKind p_kind, uint8_t p_link, const uint8_t *p_bytes, size_t p_size, godot::MultiplayerPeer::TransferMode p_mode);
	void send_bye(int32_t p_id, Peer &r_peer, uint8_t p_link, bool p_from_sender);
	void _on_peer_packet(int64_t p_peer, const godot::PackedByteArray &p_packet);
	void take_bye(int32_t p_id, Peer *p_peer, uint8_t p_link, bool p_from_sender);
	void reject(int32_t p_id, const char *p_reason);
	void report_rejections();

	// Poses
	void sample_targets();
	void set_authority(Target &r_target, godot::Node3D *p_node, int32_t p_authority);
	void sample(Target &r_target, const godot::Node3D *p_node);
	bool read_pose(Target &r_target, const godot::Node3D *p_node);
	void flush();
	void show_streams();
	void count_foreign(int32_t p_id, Peer &r_peer, const net::BodyEvent &p_event);
	void place(Target &r_target, const godot::Transform3D &p_transform, bool p_is_interpolated);
	void release(Target &r_target, godot::Node3D *p_node);
	void release_all(int32_t p_authority);
	double media_time() const { return double(_tick) * _settings.tick; } // seconds on this peer's streams

	// Statistics
	Figures figures_of(int32_t p_id, Peer &r_peer);
	Figures total_figures();
	void add_monitors();
	void remove_monitors();
	godot::Variant _get_monitor(const godot::StringName &p_key);

	// Warnings
	void watch_warnings();
	bool names_target(const godot::Node3D *p_node) const;
	void find_target_faults(const std::vector<const godot::Node3D *> &p_nodes, godot::PackedStringArray &r_faults) const;

	// The node's life
	void start();
	void stop();
	void physics_tick();
	void frame();
	void settings_changed();
	void limits_changed();

	godot::TypedArray<godot::NodePath> _paths;
	godot::StringName _group;
	int64_t _channel = 0;

	std::vector<Target> _targets;
	std::unordered_map<uint32_t, uint64_t> _node_of_body;
	std::vector<uint64_t> _added; // by add_target
	std::vector<uint64_t> _excluded; // by remove_target
	std::vector<uint64_t> _refused; // reported: same body as another, or outside of the multiplayer root
	std::vector<godot::NodePath> _unresolved;
	std::vector<uint64_t> _found; // by the last search, if _targets follows from it
	int64_t _group_count = 0;
	int64_t _refresh_in = 0; // ticks
	bool _targets_stale = true;
	bool _names_stale = false;
	bool _streams_stale = true;

	godot::Ref<godot::SceneMultiplayer> _api;
	uint64_t _transport = 0; // instance id of the MultiplayerPeer
	bool _foreign_api = false; // which was reported
	int32_t _self = 0; // 0: not connected
	uint16_t _key = 0;
	godot::String _root; // path, with a slash at its end
	std::map<int32_t, Peer> _peers;
	std::vector<int32_t> _connected;
	std::unique_ptr<net::Sender> _sender; // while somebody gets it
	int64_t _tick = 0;
	bool _running = false;
	double _now = 0.0; // seconds on the local clock, at the beginning of the tick or frame

	uint64_t _rejected = 0;
	uint64_t _late = 0; // of streams that are closed
	godot::String _monitors; // what their names begin with; empty if there are none
	godot::PackedStringArray _shown_warnings;
	int64_t _watch_in = 0; // frames
	// Kept between calls, so that a steady stream allocates only what goes to the engine.
	std::vector<uint8_t> _answer;
	std::vector<net::BodyEvent> _events;
};

} // namespace ga_godot
