#include "godot/net/motor_synchronizer.hpp"

#include "godot/net/setup_warnings.hpp"
#include "net/session/path_hash.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/multiplayer_peer.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>

#include <algorithm>
#include <chrono>

// The node's lifecycle, and its connection to the MultiplayerAPI.

namespace ga_godot {

using godot::Callable;
using godot::Dictionary;
using godot::Engine;
using godot::MultiplayerAPI;
using godot::MultiplayerPeer;
using godot::Node;
using godot::Object;
using godot::PackedByteArray;
using godot::PackedInt32Array;
using godot::PackedStringArray;
using godot::Ref;
using godot::SceneMultiplayer;
using godot::String;
using godot::TypedArray;
using godot::vformat;

// Runs after the scripts that move targets in a tick, and before those that read them in a frame.
static constexpr int32_t AFTER_OTHERS = 1000;
static constexpr int32_t BEFORE_OTHERS = -1000;
static constexpr int64_t FRAMES_BETWEEN_CHECKS = 60;

static double clock_seconds() {
	return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

MotorSynchronizer::MotorSynchronizer() {
	set_physics_process_priority(AFTER_OTHERS);
	set_process_priority(BEFORE_OTHERS);
}

void MotorSynchronizer::_notification(int what) {
	switch (what) {
		case NOTIFICATION_ENTER_TREE:
			add_to_group(SYNCHRONIZER_GROUP);
			set_process_internal(true);
			if (!is_part_of_edited_scene()) {
				start();
			}
			break;
		case NOTIFICATION_EXIT_TREE:
			remove_from_group(SYNCHRONIZER_GROUP);
			if (_is_running) {
				stop();
			}
			break;
		case NOTIFICATION_INTERNAL_PHYSICS_PROCESS:
			physics_tick();
			break;
		case NOTIFICATION_INTERNAL_PROCESS:
			if (_is_running) {
				frame();
			} else {
				watch_warnings();
			}
			break;
		default:
			break;
	}
}

void MotorSynchronizer::start() {
	_is_running = true;
	_session = net::Session(_settings);
	limits_changed();
	_selection.invalidate();
	set_physics_process_internal(true);
	get_tree()->connect("node_renamed", Callable(this, "_on_node_renamed"));
	_monitors.add(this);
}

void MotorSynchronizer::stop() {
	close_session();
	disconnect_session();
	if (_api.is_valid()) {
		_api->disconnect("peer_packet", Callable(this, "_on_peer_packet"));
		_api.unref();
	}
	while (!_targets.empty()) {
		end_target(_targets.size() - 1);
	}
	_refused.clear();
	get_tree()->disconnect("node_renamed", Callable(this, "_on_node_renamed"));
	_monitors.remove();
	set_physics_process_internal(false);
	_is_running = false;
}

void MotorSynchronizer::physics_tick() {
	update_connection();
	if (_are_names_stale) {
		rename_targets();
	}
	refresh_targets();
	if (_session.peers().empty()) {
		return;
	}
	_session.begin_tick(clock_seconds(), 1.0 / double(Engine::get_singleton()->get_physics_ticks_per_second()));
	sample_targets();
	_session.end_tick();
	send_packets();
}

void MotorSynchronizer::frame() {
	if (_api.is_null()) {
		return;
	}
	update_connection();
	if (_session.peers().empty()) {
		return;
	}
	_session.advance(clock_seconds());
	show_streams();
	send_packets();
	_session.report_rejections([this](int32_t peer, const net::Rejections::Report &report) {
		emit_signal("packet_rejected", peer, vformat("Packet rejected: %s (%d since the last report).", net::describe(report.error), int64_t(report.count)));
	});
}

void MotorSynchronizer::settings_changed() {
	_session.set_settings(_settings);
}

void MotorSynchronizer::limits_changed() {
	_session.set_margin_limits(get_min_delay(), get_jitter_allowance());
}

String MotorSynchronizer::relative_path(const Node *node) const {
	const String path = node->get_path();
	return path.begins_with(_root) ? path.substr(_root.length()) : path;
}

void MotorSynchronizer::update_connection() {
	const Ref<MultiplayerAPI> multiplayer = get_multiplayer();
	const Ref<SceneMultiplayer> api = multiplayer;
	if (api != _api) {
		disconnect_session();
		if (_api.is_valid()) {
			_api->disconnect("peer_packet", Callable(this, "_on_peer_packet"));
		}
		_api = api;
		_selection.invalidate();
		_found.clear();
		if (_api.is_valid()) {
			_api->connect("peer_packet", Callable(this, "_on_peer_packet"));
			_are_names_stale = true;
		}
	}
	if (_api.is_null()) {
		if (multiplayer.is_valid() && !_is_api_reported) {
			_is_api_reported = true;
			ERR_PRINT(vformat("MotorSynchronizer %s: the MultiplayerAPI is a %s. Only Godot's own SceneMultiplayer is supported; nothing is replicated.", get_path(), multiplayer->get_class()));
		}
		return;
	}
	const Ref<MultiplayerPeer> transport = _api->get_multiplayer_peer();
	const bool is_connected = transport.is_valid() && transport->get_connection_status() == MultiplayerPeer::CONNECTION_CONNECTED;
	const uint64_t transport_id = is_connected ? transport->get_instance_id() : 0;
	const int32_t self = is_connected ? _api->get_unique_id() : 0;
	if (self != _session.self() || transport_id != _transport) {
		disconnect_session();
		_session.connect(self);
		_transport = transport_id;
	}
	update_peers();
}

/// Forgets all peers without sending anything.
void MotorSynchronizer::disconnect_session() {
	for (Target &target : _targets) {
		target.release();
		target.authority = 0;
	}
	_session.connect(0);
	_transport = 0;
}

void MotorSynchronizer::update_peers() {
	if (!_session.is_connected()) {
		return;
	}
	const PackedInt32Array ids = _api->get_peers();
	std::vector<int32_t> peers(ids.ptr(), ids.ptr() + ids.size());
	std::sort(peers.begin(), peers.end());
	for (const int32_t peer : _session.set_peers(peers, clock_seconds())) {
		for (Target &target : _targets) {
			if (target.authority == peer) {
				target.release();
			}
		}
	}
}

void MotorSynchronizer::update_root() {
	_root = String(_api->get_root_path());
	if (!_root.ends_with("/")) {
		_root += "/";
	}
}

/// Notifies all peers that this node is removed or renamed.
void MotorSynchronizer::close_session() {
	if (!_session.is_connected() || _api->get_multiplayer_peer().is_null() || _api->get_multiplayer_peer()->get_connection_status() != MultiplayerPeer::CONNECTION_CONNECTED) {
		return;
	}
	update_peers();
	_session.close(clock_seconds());
	send_packets();
}

void MotorSynchronizer::send_packets() {
	_session.outbox().drain([this](const net::Outbox::Packet &packet, const uint8_t *bytes) {
		_api->send_bytes(to_packed(bytes, packet.size), packet.peer, packet.reliable ? MultiplayerPeer::TRANSFER_MODE_RELIABLE : MultiplayerPeer::TRANSFER_MODE_UNRELIABLE, int32_t(_channel));
	});
}

void MotorSynchronizer::_on_peer_packet(int64_t peer, const PackedByteArray &packet) {
	const int32_t id = int32_t(peer);
	if (!_session.has_peer(id)) {
		update_peers();
	}
	_session.accept(id, packet.ptr(), size_t(packet.size()), clock_seconds());
}

double MotorSynchronizer::get_media_time(int64_t peer) const {
	return _session.media_time(int32_t(peer));
}

Dictionary MotorSynchronizer::get_statistics() {
	const double now = clock_seconds();
	Dictionary result = to_dictionary(_session.total_statistics(now));
	Dictionary peers;
	for (const int32_t peer : _session.peers()) {
		peers[peer] = to_dictionary(_session.statistics(peer, now));
	}
	result["peers"] = peers;
	return result;
}

godot::Variant MotorSynchronizer::_get_monitor(const godot::StringName &key) {
	return to_dictionary(_session.total_statistics(clock_seconds()))[key];
}

PackedStringArray MotorSynchronizer::get_setup_warnings() const {
	return is_inside_tree() ? find_setup_faults(*this, _selection) : PackedStringArray();
}

PackedStringArray MotorSynchronizer::_get_configuration_warnings() const {
	return get_setup_warnings();
}

/// Updates the warnings in the editor, which does not report changes of groups and other nodes.
void MotorSynchronizer::watch_warnings() {
	if (--_frames_to_check > 0) {
		return;
	}
	_frames_to_check = FRAMES_BETWEEN_CHECKS;
	const PackedStringArray warnings = get_setup_warnings();
	if (!(warnings == _shown_warnings)) {
		_shown_warnings = warnings;
		update_configuration_warnings();
	}
}

} // namespace ga_godot
