#include "godot/net/replicator.hpp"

#include "godot/algebra/conversions.hpp"
#include "godot/net/motor_synchronizer.hpp"
#include "godot/net/packet_reason.hpp"
#include "godot/net/setup_warnings.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/multiplayer_peer.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>

#include <algorithm>
#include <chrono>
#include <utility>

// The connection of a session to the MultiplayerAPI.

namespace ga_godot {

using godot::Callable;
using godot::Engine;
using godot::MultiplayerPeer;
using godot::PackedByteArray;
using godot::PackedInt32Array;
using godot::Ref;
using godot::SceneMultiplayer;
using godot::SceneTree;
using godot::String;
using godot::vformat;

double clock_seconds() {
	return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The instance id of the connected MultiplayerPeer; 0 if there is none.
static uint64_t open_transport(const Ref<SceneMultiplayer> &api) {
	const Ref<MultiplayerPeer> transport = api->get_multiplayer_peer();
	return transport.is_valid() && transport->get_connection_status() == MultiplayerPeer::CONNECTION_CONNECTED ? transport->get_instance_id() : 0;
}

static std::unordered_map<uint64_t, std::weak_ptr<Replicator>> &replicators() {
	static std::unordered_map<uint64_t, std::weak_ptr<Replicator>> by_api;
	return by_api;
}

std::shared_ptr<Replicator> Replicator::of(const Ref<SceneMultiplayer> &api) {
	std::weak_ptr<Replicator> &known = replicators()[api->get_instance_id()];
	std::shared_ptr<Replicator> replicator = known.lock();
	if (replicator == nullptr) {
		replicator = std::make_shared<Replicator>(api);
		known = replicator;
	}
	return replicator;
}

Replicator::Replicator(const Ref<SceneMultiplayer> &api) :
		_api(api) {}

Replicator::~Replicator() {
	replicators().erase(_api->get_instance_id());
}

FreeGuard &Replicator::free_guard() {
	static FreeGuard guard;
	return guard;
}

void Replicator::finish() {
	while (_are_settings_stale || !_received.empty()) {
		if (std::exchange(_are_settings_stale, false)) {
			apply_settings();
		}
		for (const ReceivedPacket &packet : std::exchange(_received, {})) {
			if (!_session.has_peer(packet.peer)) {
				update_peers();
			}
			_session.accept(packet.peer, packet.bytes.ptr(), size_t(packet.bytes.size()), clock_seconds());
		}
	}
	_targets.sweep();
}

void Replicator::add(MotorSynchronizer *synchronizer) {
	if (has(synchronizer)) {
		return;
	}
	const Busy busy(*this);
	_synchronizers.push_back(synchronizer);
	if (_synchronizers.size() == 1) {
		_root = String(_api->get_root_path());
		_root += _root.ends_with("/") ? "" : "/";
		set_lead(synchronizer);
	}
	update_settings();
}

void Replicator::remove(MotorSynchronizer *synchronizer) {
	if (!has(synchronizer)) {
		return;
	}
	const Busy busy(*this);
	if (_synchronizers.size() == 1) {
		close_session();
		connect_session(0, 0);
	}
	for (Target *target : _targets.select([&](const Target &other) { return other.synchronizer == synchronizer; })) {
		end_target(*target);
	}
	remove_departed();
	const bool is_lead = lead() == synchronizer;
	if (is_lead) {
		set_lead(nullptr);
	}
	_synchronizers.erase(std::remove(_synchronizers.begin(), _synchronizers.end(), synchronizer), _synchronizers.end());
	if (is_lead) {
		set_lead(lead());
	}
	update_settings();
}

void Replicator::update_settings() {
	const Busy busy(*this);
	_are_settings_stale = true;
}

/// Connects the engine's signals to `lead`; null disconnects them from the current one.
void Replicator::set_lead(MotorSynchronizer *next) {
	MotorSynchronizer *const node = next != nullptr ? next : lead();
	if (node == nullptr) {
		return;
	}
	SceneTree *tree = node->get_tree();
	const Callable packets = callable_mp(node, &MotorSynchronizer::_on_peer_packet);
	const Callable renames = callable_mp(node, &MotorSynchronizer::_on_node_renamed);
	const Callable ticks = callable_mp(node, &MotorSynchronizer::_on_physics_frame);
	const Callable leaving = callable_mp(node, &MotorSynchronizer::_on_peer_disconnected);
	if (next != nullptr) {
		_api->connect("peer_packet", packets);
		_api->connect("peer_disconnected", leaving);
		tree->connect("node_renamed", renames);
		tree->connect("physics_frame", ticks);
		_monitors.add(node->get_name(), callable_mp(node, &MotorSynchronizer::_get_monitor));
	} else {
		_api->disconnect("peer_packet", packets);
		_api->disconnect("peer_disconnected", leaving);
		tree->disconnect("node_renamed", renames);
		tree->disconnect("physics_frame", ticks);
		_monitors.remove();
	}
}

/// One stream serves all synchronizers, so it meets the strictest of their settings.
void Replicator::apply_settings() {
	if (_synchronizers.empty()) {
		return;
	}
	net::StreamSettings settings = lead()->stream_settings();
	double min_delay = 0.0;
	double jitter_allowance = 0.0;
	bool relay = lead()->is_relay();
	bool differs = false;
	for (const MotorSynchronizer *synchronizer : _synchronizers) {
		const net::StreamSettings &other = synchronizer->stream_settings();
		differs = differs || !settings.is_same_stream(other) || settings.send_rate != other.send_rate || settings.max_packet_size != other.max_packet_size || relay != synchronizer->is_relay();
		relay = relay || synchronizer->is_relay();
		settings.position_tolerance = std::min(settings.position_tolerance, other.position_tolerance);
		settings.rotation_tolerance = std::min(settings.rotation_tolerance, other.rotation_tolerance);
		settings.position_tolerance_2d = std::min(settings.position_tolerance_2d, other.position_tolerance_2d);
		settings.max_packet_size = std::min(settings.max_packet_size, other.max_packet_size);
		settings.max_latency = std::min(settings.max_latency, other.max_latency);
		settings.send_rate = std::max(settings.send_rate, other.send_rate);
		min_delay = std::max(min_delay, synchronizer->get_min_delay());
		jitter_allowance = std::max(jitter_allowance, synchronizer->get_jitter_allowance());
	}
	_settings = settings;
	_session.set_settings(settings);
	_session.set_relay(relay);
	_session.set_margin_limits(min_delay, jitter_allowance);
	if (differs) {
		_warnings.warn("settings", "The MotorSynchronizers of this tree have different settings, but share one stream: the smallest tolerances, max_latency and max_packet_size, the highest send_rate, and relay if one of them has it, apply to all of them. Give them the same settings.");
	}
	const String fault = send_rate_fault(settings.send_rate);
	if (!fault.is_empty()) {
		_warnings.warn("send rate", fault);
	}
	const String tick_fault = tick_rate_fault(settings.max_latency);
	if (!tick_fault.is_empty()) {
		_warnings.warn("tick rate", tick_fault);
	}
}

void Replicator::tick() {
	const int64_t engine_tick = int64_t(Engine::get_singleton()->get_physics_frames());
	if (engine_tick == _last_tick || _depth > 0) {
		return;
	}
	const Busy busy(*this);
	_last_tick = engine_tick;
	const double now = clock_seconds();
	const double length = 1.0 / double(Engine::get_singleton()->get_physics_ticks_per_second());
	_frame_clock.tick(length);
	update_connection();
	if (_are_names_stale) {
		rename_targets();
	}
	refresh();
	if (_session.peers().empty()) {
		end_freed_bodies();
		remove_departed();
		return;
	}
	_session.begin_tick(now, length);
	sample_targets(now);
	_session.end_tick();
	end_freed_bodies();
	remove_departed();
	send_packets();
}

void Replicator::frame() {
	const int64_t engine_frame = int64_t(Engine::get_singleton()->get_process_frames());
	if (engine_frame == _last_frame || lead() == nullptr || _depth > 0) {
		return;
	}
	const Busy busy(*this);
	_last_frame = engine_frame;
	const double now = clock_seconds();
	_frame_clock.frame(lead()->get_process_delta_time(), Engine::get_singleton()->get_physics_interpolation_fraction());
	update_connection();
	free_ended(now);
	if (_session.peers().empty()) {
		return;
	}
	refresh();
	_session.advance(now);
	show_streams(now);
	send_packets();
	check_streams(now);
	_session.report_rejections([this](int32_t peer, const net::Rejections::Report &report) {
		const String clause = packet_reason(report.error, report.version);
		const String reason = vformat("Packet rejected: %s (%d since the last report).", clause, int64_t(report.count));
		if (report.error == net::PacketError::OTHER_SESSION_VERSION || report.error == net::PacketError::OTHER_STREAM_VERSION) {
			// In the texts of all peers with this version.
			_warnings.warn(clause.utf8().get_data(), vformat("a packet of peer %d was rejected: %s.", peer, clause));
		}
		for (MotorSynchronizer *synchronizer : std::vector<MotorSynchronizer *>(_synchronizers)) {
			if (has(synchronizer)) {
				synchronizer->emit_signal("packet_rejected", peer, reason);
			}
		}
	});
}

void Replicator::refresh() {
	for (MotorSynchronizer *synchronizer : std::vector<MotorSynchronizer *>(_synchronizers)) {
		if (has(synchronizer)) {
			refresh(synchronizer);
		}
	}
}

void Replicator::update_connection() {
	const uint64_t transport_id = open_transport(_api);
	const int32_t self = transport_id != 0 ? _api->get_unique_id() : 0;
	if (self != _session.self() || transport_id != _transport) {
		connect_session(self, transport_id);
	}
	update_peers();
}

/// Forgets all peers without sending anything, and begins again as peer `self` of a MultiplayerPeer; 0 and 0 for none.
void Replicator::connect_session(int32_t self, uint64_t transport) {
	_departed.clear();
	_session.connect(self);
	_transport = transport;
	for (Target &target : _targets) {
		target.authority = 0;
		target.view = net::BodyView();
		target.release();
	}
}

/// Without the peer `left`.
void Replicator::update_peers(int32_t left) {
	if (!_session.is_connected() || open_transport(_api) != _transport) {
		return;
	}
	const PackedInt32Array ids = _api->get_peers();
	std::vector<int32_t> peers(ids.ptr(), ids.ptr() + ids.size());
	peers.erase(std::remove(peers.begin(), peers.end(), left), peers.end());
	std::sort(peers.begin(), peers.end());
	for (const int32_t peer : _session.set_peers(peers, clock_seconds())) {
		for (Target &target : _targets) {
			if (target.authority == peer) {
				target.release();
			}
		}
	}
}

/// Notifies all peers that this peer's last synchronizer is removed.
void Replicator::close_session() {
	if (!_session.is_connected() || open_transport(_api) != _transport) {
		return;
	}
	update_peers();
	_session.close(clock_seconds());
	send_packets();
}

void Replicator::send_packets() {
	// Callbacks since update_connection() may have disconnected peers, or closed or replaced the MultiplayerPeer.
	update_peers();
	const int32_t channel = lead() != nullptr ? int32_t(lead()->get_channel()) : 0;
	net::Outbox::Packet refused{};
	_session.outbox().drain([&](const net::Outbox::Packet &packet, const uint8_t *bytes) {
		if (!_session.has_peer(packet.peer) || open_transport(_api) != _transport) {
			return; // it has left since
		}
		const godot::Error error = _api->send_bytes(to_packed(bytes, packet.size), packet.peer, packet.reliable ? MultiplayerPeer::TRANSFER_MODE_RELIABLE : MultiplayerPeer::TRANSFER_MODE_UNRELIABLE, channel);
		if (error != godot::OK && packet.size > refused.size) {
			refused = packet;
		}
	});
	// Smaller packets are refused for other reasons, such as a peer that is about to leave.
	if (refused.size > net::StreamSettings::MIN_PACKET_SIZE && _api->get_peers().has(refused.peer)) {
		const size_t limit = _session.packet_refused(refused.peer, refused.size);
		_warnings.warn("packet size", vformat("the MultiplayerPeer refused to send a packet of %d bytes to peer %d. Packets are limited to %d bytes from now on. Set max_packet_size to the limit of the transport.", int64_t(refused.size), refused.peer, int64_t(limit)));
	}
}

void Replicator::packet_received(int32_t peer, const PackedByteArray &packet) {
	const Busy busy(*this);
	_received.push_back({ peer, packet });
}

} // namespace ga_godot
