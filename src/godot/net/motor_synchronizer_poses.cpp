#include "godot/net/motor_synchronizer.hpp"

#include <godot_cpp/classes/multiplayer_peer.hpp>
#include <godot_cpp/classes/scene_tree.hpp>

// Poses: from the nodes that are this peer's own to its stream, and from other peers' streams to the rest.

namespace ga_godot {

using godot::MultiplayerPeer;
using godot::Node3D;
using godot::Transform3D;
using godot::vformat;

void MotorSynchronizer::teleport(Node3D *p_node) {
	ERR_FAIL_NULL_MSG(p_node, "MotorSynchronizer.teleport: the node is null.");
	const Target *target = find_target(p_node->get_instance_id());
	ERR_FAIL_NULL_MSG(target, vformat("MotorSynchronizer.teleport: %s is no target of %s.", p_node->get_name(), get_name()));
	ERR_FAIL_COND_MSG(_self != 0 && p_node->get_multiplayer_authority() != _self, vformat("MotorSynchronizer.teleport: %s belongs to peer %d; only its authority can teleport it.", p_node->get_name(), p_node->get_multiplayer_authority()));
	if (target->sent) {
		_sender->teleport(target->body);
	}
}

void MotorSynchronizer::sample_targets() {
	for (Target &target : _targets) {
		Node3D *node = node_of(target.node);
		if (node == nullptr) {
			continue;
		}
		const int32_t authority = node->get_multiplayer_authority();
		if (authority != target.authority) {
			set_authority(target, node, authority);
		}
		if (authority == _self && _sender) {
			sample(target, node);
		}
	}
}

void MotorSynchronizer::set_authority(Target &r_target, Node3D *p_node, int32_t p_authority) {
	if (r_target.sent) {
		_sender->remove_body(r_target.body);
		r_target.sent = false;
	}
	release(r_target, p_node);
	r_target.authority = p_authority;
	r_target.posed = false;
	_streams_stale = true;
}

void MotorSynchronizer::sample(Target &r_target, const Node3D *p_node) {
	if (read_pose(r_target, p_node)) {
		const bool fits = (r_target.sent || _sender->add_body(r_target.body, r_target.pose)) && _sender->observe(r_target.body, media_time(), r_target.pose);
		if (fits) {
			r_target.sent = true;
			r_target.sent_pose = r_target.pose;
			return;
		}
		r_target.faulty = true;
		ERR_PRINT(vformat("MotorSynchronizer %s: the transform of %s is farther out, or its scale is larger or smaller, than a stream can say. What others see of it stays as it was.", get_path(), p_node->get_path()));
	}
	if (r_target.sent) {
		_sender->observe(r_target.body, media_time(), r_target.sent_pose);
	}
}

/// Brings the target's pose up to date. False if it has none, which is reported once.
bool MotorSynchronizer::read_pose(Target &r_target, const Node3D *p_node) {
	const Transform3D transform = p_node->get_transform();
	if (r_target.posed && transform == r_target.transform) {
		return !r_target.faulty;
	}
	bool is_uniform = true;
	const char *fault = nearest_pose_from_transform(transform, r_target.pose, is_uniform);
	r_target.transform = transform;
	r_target.posed = true;
	if (fault != nullptr && !r_target.faulty) {
		ERR_PRINT(vformat("MotorSynchronizer %s: the transform of %s %s. What others see of it stays as it was.", get_path(), p_node->get_path(), fault));
	}
	if (!is_uniform && !r_target.uneven) {
		r_target.uneven = true;
		WARN_PRINT(vformat("MotorSynchronizer %s: %s is scaled differently along its axes, or sheared; others see the nearest uniform scale. Scale a child node instead.", get_path(), p_node->get_path()));
	}
	r_target.faulty = fault != nullptr;
	return !r_target.faulty;
}

void MotorSynchronizer::flush() {
	if (!_sender) {
		return;
	}
	_sender->flush(media_time());
	for (const net::OutgoingPacket &packet : _sender->packets()) {
		const int32_t id = int32_t(packet.receiver);
		const auto found = _peers.find(id);
		if (found != _peers.end() && found->second.subscribed) {
			send(id, found->second, net::PacketKind::MOTION, found->second.subscription, _sender->bytes() + packet.begin, packet.size, MultiplayerPeer::TRANSFER_MODE_UNRELIABLE);
		}
	}
}

void MotorSynchronizer::show_streams() {
	for (auto &[id, peer] : _peers) {
		if (!peer.stream) {
			continue;
		}
		peer.stream->advance(_now);
		peer.stream->take_events(_events);
		for (const net::BodyEvent &event : _events) {
			count_foreign(id, peer, event);
		}
		if (peer.stream->take_ack(_answer, _now)) {
			send(id, peer, net::PacketKind::ACK, peer.link, _answer.data(), _answer.size(), MultiplayerPeer::TRANSFER_MODE_UNRELIABLE);
		}
	}
	const bool is_interpolated = get_tree()->is_physics_interpolation_enabled();
	const net::Receiver *stream = nullptr;
	int32_t authority = 0;
	for (Target &target : _targets) {
		if (target.authority == _self) {
			continue;
		}
		if (target.authority != authority) {
			authority = target.authority;
			const auto found = _peers.find(authority);
			stream = found != _peers.end() ? found->second.stream.get() : nullptr;
		}
		cga::Pose<double> pose;
		if (stream != nullptr && stream->is_ready() && stream->pose(target.body, pose)) {
			place(target, to_godot(pose), is_interpolated);
		}
	}
}

/// A body in the stream of a peer that is not its node's authority is not shown. It is no offence either: while
/// authority changes hands, peers hear of it at different times.
void MotorSynchronizer::count_foreign(int32_t p_id, Peer &r_peer, const net::BodyEvent &p_event) {
	if (p_event.kind != net::BodyEvent::ADDED) {
		return;
	}
	const auto holder = _node_of_body.find(p_event.id);
	const Node3D *node = holder != _node_of_body.end() ? node_of(holder->second) : nullptr;
	if (node != nullptr && node->get_multiplayer_authority() != p_id) {
		r_peer.foreign_bodies++;
	}
}

void MotorSynchronizer::place(Target &r_target, const Transform3D &p_transform, bool p_is_interpolated) {
	Node3D *node = node_of(r_target.node);
	if (node == nullptr) {
		return;
	}
	if (p_is_interpolated && r_target.own_interpolation < 0) {
		// The stream is interpolated for each frame already; the engine would interpolate it again, a tick late.
		r_target.own_interpolation = int32_t(node->get_physics_interpolation_mode());
		node->set_physics_interpolation_mode(godot::Node::PHYSICS_INTERPOLATION_MODE_OFF);
	}
	if (node->get_transform() != p_transform) {
		node->set_transform(p_transform);
	}
}

/// The node is no longer moved from here.
void MotorSynchronizer::release(Target &r_target, Node3D *p_node) {
	if (r_target.own_interpolation >= 0) {
		p_node->set_physics_interpolation_mode(godot::Node::PhysicsInterpolationMode(r_target.own_interpolation));
		p_node->reset_physics_interpolation();
		r_target.own_interpolation = -1;
	}
}

/// Their authority has gone.
void MotorSynchronizer::release_all(int32_t p_authority) {
	for (Target &target : _targets) {
		Node3D *node = target.authority == p_authority ? node_of(target.node) : nullptr;
		if (node != nullptr) {
			release(target, node);
		}
	}
}

} // namespace ga_godot
