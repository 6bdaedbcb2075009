#include "godot/net/motor_synchronizer.hpp"

#include <godot_cpp/classes/multiplayer_peer.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>

#include <algorithm>

// Who gets what from whom: the connection, the streams between this node and those of other peers.

namespace ga_godot {

using godot::Callable;
using godot::MultiplayerAPI;
using godot::MultiplayerPeer;
using godot::Node;
using godot::Object;
using godot::PackedInt32Array;
using godot::Ref;
using godot::SceneMultiplayer;
using godot::String;
using godot::TypedArray;
using godot::vformat;

static constexpr double HELLO_INTERVAL = 0.25; // seconds
/// Seconds between two streams to one peer, so that nobody makes us start one in each tick.
static constexpr double SUBSCRIPTION_INTERVAL = 0.2;
/// Room for bodies whose nodes are still to be spawned here. Bounds what a peer can make us keep.
static constexpr size_t SPARE_BODIES = 4096;

String MotorSynchronizer::relative_path(const Node *p_node) const {
	const String path = p_node->get_path();
	return path.begins_with(_root) ? path.substr(_root.length()) : path;
}

bool MotorSynchronizer::is_connected_peer(int32_t p_id) const {
	return std::binary_search(_connected.begin(), _connected.end(), p_id);
}

void MotorSynchronizer::update_connection() {
	const Ref<MultiplayerAPI> multiplayer = get_multiplayer();
	const Ref<SceneMultiplayer> api = multiplayer;
	if (api != _api) {
		leave_connection();
		if (_api.is_valid()) {
			_api->disconnect("peer_packet", Callable(this, "_on_peer_packet"));
		}
		_api = api;
		_targets_stale = true;
		_found.clear();
		if (_api.is_valid()) {
			_api->connect("peer_packet", Callable(this, "_on_peer_packet"));
			_names_stale = true;
		}
	}
	if (_api.is_null()) {
		if (multiplayer.is_valid() && !_foreign_api) {
			_foreign_api = true;
			ERR_PRINT(vformat("MotorSynchronizer %s: it needs a SceneMultiplayer, Godot's own MultiplayerAPI, but here is a %s. Nothing is replicated.", get_path(), multiplayer->get_class()));
		}
		return;
	}
	const Ref<MultiplayerPeer> transport = _api->get_multiplayer_peer();
	const bool connected = transport.is_valid() && transport->get_connection_status() == MultiplayerPeer::CONNECTION_CONNECTED;
	const uint64_t transport_id = connected ? transport->get_instance_id() : 0;
	const int32_t self = connected ? _api->get_unique_id() : 0;
	if (self != _self || transport_id != _transport) {
		leave_connection();
		_self = self;
		_transport = transport_id;
	}
	update_peers();
}

/// Forgets everybody, without a word.
void MotorSynchronizer::leave_connection() {
	for (auto &[id, peer] : _peers) {
		forget_stream(peer);
		release_all(id);
	}
	_peers.clear();
	_connected.clear();
	_sender.reset();
	for (Target &target : _targets) {
		target.sent = false;
		target.authority = 0;
	}
	_self = 0;
	_transport = 0;
	_streams_stale = true;
}

void MotorSynchronizer::update_key() {
	_root = String(_api->get_root_path());
	if (!_root.ends_with("/")) {
		_root += "/";
	}
	const uint16_t key = net::path_key(to_utf8(relative_path(this)));
	if (key != _key) {
		say_goodbye();
		leave_connection();
		_key = key;
	}
	const TypedArray<Node> others = get_tree()->get_nodes_in_group(GROUP);
	for (int64_t i = 0; i < others.size(); i++) {
		const MotorSynchronizer *other = Object::cast_to<MotorSynchronizer>(others[i].get_validated_object());
		if (other != nullptr && other != this && other->_api == _api && other->_key == _key) {
			ERR_PRINT(vformat("MotorSynchronizer: the paths of %s and %s have the same hash, by which packets know their node. Rename one of the two on all peers.", get_path(), other->get_path()));
		}
	}
}

void MotorSynchronizer::update_peers() {
	if (_self == 0) {
		return;
	}
	const PackedInt32Array peers = _api->get_peers();
	std::vector<int32_t> connected(peers.ptr(), peers.ptr() + peers.size());
	std::sort(connected.begin(), connected.end());
	if (connected == _connected) {
		return;
	}
	_connected.swap(connected);
	for (auto at = _peers.begin(); at != _peers.end();) {
		if (is_connected_peer(at->first)) {
			++at;
			continue;
		}
		unsubscribe(at->first, at->second);
		forget_stream(at->second);
		release_all(at->first);
		at = _peers.erase(at);
	}
	_streams_stale = true;
}

/// Opens a stream from each peer that is the authority of a target, and closes the others.
void MotorSynchronizer::update_streams() {
	_streams_stale = false;
	std::vector<int32_t> needed;
	for (const Target &target : _targets) {
		if (target.authority != _self && (needed.empty() || needed.back() != target.authority)) {
			needed.push_back(target.authority);
		}
	}
	std::sort(needed.begin(), needed.end());
	for (auto &[id, peer] : _peers) {
		const bool is_needed = std::binary_search(needed.begin(), needed.end(), id);
		const bool is_too_small = peer.max_bodies < _targets.size() + SPARE_BODIES / 2;
		if (peer.stream && (!is_needed || is_too_small)) {
			send_bye(id, peer, peer.link, false);
			forget_stream(peer);
		}
	}
	for (const int32_t id : needed) {
		if (is_connected_peer(id) && !_peers[id].stream) {
			open_stream(_peers[id]);
		}
	}
}

void MotorSynchronizer::open_stream(Peer &r_peer) {
	// One sequence for all nodes here, begun anywhere, so that what is still on its way to an earlier stream is not
	// taken for a packet of this one.
	static uint8_t last_link = uint8_t(int64_t(clock() * 1e3));
	r_peer.link = ++last_link;
	r_peer.max_bodies = 2 * _targets.size() + SPARE_BODIES;
	r_peer.stream = std::make_unique<net::Receiver>(r_peer.max_bodies);
	limit(*r_peer.stream);
	r_peer.hello_due = 0.0;
}

void MotorSynchronizer::forget_stream(Peer &r_peer) {
	if (r_peer.stream) {
		_late += r_peer.stream->statistics().late_windows;
		r_peer.stream.reset();
		r_peer.ended_at = _now;
	}
}

void MotorSynchronizer::subscribe(int32_t p_id, uint8_t p_link, double p_now) {
	const auto found = _peers.find(p_id);
	const bool subscribed = found != _peers.end() && found->second.subscribed;
	if (subscribed && (found->second.subscription == p_link || p_now - found->second.subscribed_at < SUBSCRIPTION_INTERVAL)) {
		return;
	}
	// A hello to a peer that owns nothing (yet) comes again.
	if (std::none_of(_targets.begin(), _targets.end(), [this](const Target &p_target) { return p_target.authority == _self; })) {
		return;
	}
	Peer &peer = _peers[p_id];
	if (!_sender) {
		_sender = std::make_unique<net::Sender>(_settings);
	}
	if (subscribed) {
		_sender->remove_receiver(uint32_t(p_id));
		peer.ended_at = p_now;
	}
	peer.subscribed = true;
	peer.subscription = p_link;
	peer.subscribed_at = p_now;
	_sender->add_receiver(uint32_t(p_id), media_time());
}

void MotorSynchronizer::unsubscribe(int32_t p_id, Peer &r_peer) {
	if (!r_peer.subscribed) {
		return;
	}
	r_peer.subscribed = false;
	r_peer.ended_at = _now;
	_sender->remove_receiver(uint32_t(p_id));
	if (std::none_of(_peers.begin(), _peers.end(), [](const auto &p_entry) { return p_entry.second.subscribed; })) {
		_sender.reset();
		for (Target &target : _targets) {
			target.sent = false;
		}
	}
}

void MotorSynchronizer::send_hellos() {
	for (auto &[id, peer] : _peers) {
		if (peer.stream && _now >= peer.hello_due) {
			peer.hello_due = _now + HELLO_INTERVAL;
			send(id, peer, net::PacketKind::OPEN, peer.link, nullptr, 0, MultiplayerPeer::TRANSFER_MODE_UNRELIABLE);
		}
	}
}

/// Tells everybody that this node goes, or changes its name.
void MotorSynchronizer::say_goodbye() {
	if (_self == 0 || _api->get_multiplayer_peer().is_null() || _api->get_multiplayer_peer()->get_connection_status() != MultiplayerPeer::CONNECTION_CONNECTED) {
		return;
	}
	update_peers();
	for (auto &[id, peer] : _peers) {
		if (peer.subscribed) {
			send_bye(id, peer, peer.subscription, true);
		}
		if (peer.stream) {
			send_bye(id, peer, peer.link, false);
		}
	}
}

} // namespace ga_godot
