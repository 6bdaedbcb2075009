#pragma once

#include "godot/free_guard.hpp"
#include "godot/net/run_time_warnings.hpp"
#include "godot/net/statistics_monitors.hpp"
#include "godot/net/target_list.hpp"
#include "net/session/session.hpp"

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/scene_multiplayer.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace ga_godot {

/// The part that all MotorSynchronizers of one MultiplayerAPI share: one net::Session, and the targets of all of them. It maps
/// nodes to bodies, passes the poses of this peer's nodes to the session in each physics tick, and moves the other nodes in
/// each frame. The first synchronizer is the lead: the engine's signals reach the replicator through it.
///
/// Nearly every call into the engine can run callbacks: notifications and setters of nodes, handlers of signals, a MultiplayerPeer in
/// a script, a Logger. They may free nodes and synchronizers, change targets and settings, and end the connection. So public methods
/// open a Busy scope, within which replicator, synchronizers and Target objects stay in memory, settings do not change, and
/// packets wait. After such a call, code looks nodes up again and checks Target::is_removed.
class Replicator : public std::enable_shared_from_this<Replicator> {
public:
	/// The replicator of an API; creates it if there is none.
	[[nodiscard]] static std::shared_ptr<Replicator> of(const godot::Ref<godot::SceneMultiplayer> &api);
	explicit Replicator(const godot::Ref<godot::SceneMultiplayer> &api);
	~Replicator();

	void add(MotorSynchronizer *synchronizer);
	/// Ends the targets of a synchronizer. The last one closes the session.
	void remove(MotorSynchronizer *synchronizer);
	/// Applies changed properties of a synchronizer.
	void update_settings();
	void update_priorities(const MotorSynchronizer *synchronizer);

	/// The path of a node relative to the MultiplayerAPI's root: the same on all peers.
	[[nodiscard]] godot::String relative_path(const godot::Node *node) const;

	// The lead's notifications and signals; calls of the other synchronizers in the same tick or frame do nothing.
	void tick();
	void frame();
	void before_scripts();
	/// A transport may give the id of a peer that has left to another one before the next tick.
	void peer_left(int32_t peer) { update_peers(peer); }
	void packet_received(int32_t peer, const godot::PackedByteArray &packet);
	void target_exiting(uint64_t node);
	void node_renamed(const godot::Node *node);

	/// Searches the targets of a synchronizer again, if they may have changed.
	void refresh(MotorSynchronizer *synchronizer);
	/// The same for all synchronizers.
	void refresh();
	[[nodiscard]] Target *find_target(const godot::Node *node) { return _targets.find(node->get_instance_id()); }
	[[nodiscard]] godot::TypedArray<godot::Node> targets_of(const MotorSynchronizer *synchronizer) const;
	void free_target(Target &target);
	/// Defers free() of synchronizers while a replicator is busy.
	[[nodiscard]] static FreeGuard &free_guard();

	[[nodiscard]] net::Session &session() { return _session; }
	[[nodiscard]] const godot::PackedStringArray &warnings() const { return _warnings.texts(); }
	[[nodiscard]] const godot::Ref<godot::SceneMultiplayer> &api() const { return _api; }

private:
	/// A node that has left the tree and may return: it was reparented, or its new namesake is another body.
	struct Departed {
		uint64_t node;
		uint32_t body;
		uint64_t parent; // instance id
		bool is_own;
		net::BodyView view;
		double time;
	};
	/// A node that free_target ends.
	struct Freed {
		uint64_t node;
		double free_at;
	};
	struct ReceivedPacket {
		int32_t peer;
		godot::PackedByteArray bytes;
	};
	class Busy {
	public:
		explicit Busy(Replicator &replicator) :
				_scope(free_guard()), _replicator(replicator.shared_from_this()) {
			_replicator->_depth++;
		}
		~Busy() {
			if (_replicator->_depth == 1) {
				_replicator->finish();
			}
			_replicator->_depth--;
		}
		Busy(const Busy &) = delete;
		Busy &operator=(const Busy &) = delete;

	private:
		FreeGuard::Scope _scope;
		std::shared_ptr<Replicator> _replicator;
	};
	/// Does what had to wait for the outermost Busy to end.
	void finish();

	// Connection
	void set_lead(MotorSynchronizer *lead);
	void update_connection();
	void update_peers(int32_t left = 0);
	void apply_settings();
	void connect_session(int32_t self, uint64_t transport);
	void close_session();
	void send_packets();
	[[nodiscard]] bool has(const MotorSynchronizer *synchronizer) const { return std::find(_synchronizers.begin(), _synchronizers.end(), synchronizer) != _synchronizers.end(); }
	[[nodiscard]] MotorSynchronizer *lead() const { return _synchronizers.empty() ? nullptr : _synchronizers.front(); }

	// Targets
	void emit(MotorSynchronizer *synchronizer, const char *signal, const std::vector<uint64_t> &nodes);
	bool claim_body(const Target &target);
	bool add_target(uint64_t id, MotorSynchronizer *synchronizer);
	void end_target(Target &target);
	void rename_targets();
	void sample_targets(double now);
	void sample(Target &target, godot::Node *node);
	void observe_departed();
	void remove_departed();
	void end_freed_bodies();
	void change_authority(Target &target, int32_t authority, double now);
	void show_streams(double now);
	void show(Target &target, godot::Node *node, double now);
	void free_ended(double now);
	void check_streams(double now);

	godot::Ref<godot::SceneMultiplayer> _api;
	uint64_t _transport = 0; // instance id of the MultiplayerPeer
	godot::String _root; // path of the MultiplayerAPI's root, with a trailing slash
	net::StreamSettings _settings;
	net::Session _session{ _settings };
	std::vector<MotorSynchronizer *> _synchronizers;
	int32_t _depth = 0; // of Busy scopes
	bool _are_settings_stale = false;
	std::vector<ReceivedPacket> _received; // packets that wait for the end of Busy
	int64_t _last_tick = -1; // of the engine
	int64_t _last_frame = -1;
	net::FrameClock _frame_clock;

	TargetList _targets;
	std::unordered_map<uint32_t, uint64_t> _node_of_body;
	std::vector<Departed> _departed;
	std::vector<Freed> _freed;
	std::vector<uint64_t> _exiting; // nodes that are leaving the tree, in which the engine still finds them
	bool _are_names_stale = true;

	StatisticsMonitors _monitors;
	RunTimeWarnings _warnings;
	double _next_check = 0.0;
	std::unordered_map<int32_t, double> _absent_since; // owners that are not connected, and peers with bodies without a node
};

/// The local clock in seconds.
[[nodiscard]] double clock_seconds();

} // namespace ga_godot
