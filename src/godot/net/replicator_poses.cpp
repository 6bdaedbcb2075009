#include "godot/net/replicator.hpp"

#include "godot/algebra/conversions.hpp"
#include "godot/net/motor_synchronizer.hpp"
#include "godot/net/spatial_node.hpp"

#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/core/object.hpp>

#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

// Poses from nodes to the session, and back.

namespace ga_godot {

using godot::Basis;
using godot::Node;
using godot::Object;
using godot::ObjectDB;
using godot::Transform3D;
using godot::Vector3;
using godot::vformat;

using Phase = net::BodyView::Phase;

// A new node without a known pose is hidden for at most this many seconds.
static constexpr double MAX_HIDDEN = 1.0;
// Seconds between two checks for owners and nodes that are missing, and how long they may be missing before they are reported.
static constexpr double CHECK_INTERVAL = 0.5;
static constexpr double MAX_ABSENT = 2.0;
/// A line that makes errors grow by more than this factor is reported.
static constexpr double NOTABLE_RELAXATION = 3.0;

/// A pose in the units of the stream. Those of a Node2D are pixels.
static cga::Pose<double> to_stream(cga::Pose<double> pose, bool is_2d, const net::StreamSettings &settings) {
	pose.translation *= is_2d ? settings.planar_unit() : 1.0;
	return pose;
}

/// The transform of a pose in a stream with `settings`.
static Transform3D from_stream(cga::Pose<double> pose, bool is_2d, const net::StreamSettings &settings) {
	pose.translation *= is_2d ? 1.0 / settings.planar_unit() : 1.0;
	return to_godot(pose);
}

/// `transform`, which is relative to the node `from`, relative to the node `to`.
static Transform3D change_parent(const Transform3D &transform, const Node *from, const Node *to) {
	if (from == to) {
		return transform;
	}
	const Transform3D world = global_transform(from) * transform;
	const Transform3D parent = global_transform(to);
	glm::dmat3 columns(1.0);
	for (int i = 0; i < 3; i++) {
		columns[i] = to_glm(parent.basis.get_column(i));
	}
	if (glm::determinant(columns) == 0.0) {
		return transform;
	}
	const glm::dmat3 inverse = glm::inverse(columns);
	const auto apply = [&inverse](const Vector3 &vector) { return to_godot(cga::Vector3<double>(inverse * to_glm(vector))); };
	Transform3D result;
	result.basis = Basis(apply(world.basis.get_column(0)), apply(world.basis.get_column(1)), apply(world.basis.get_column(2)));
	result.origin = apply(world.origin - parent.origin);
	return result;
}

void Replicator::change_authority(Target &target, int32_t authority, double now) {
	const bool was_own = target.authority != 0 && target.authority == _session.self();
	if (was_own) {
		target.view.mark_shown();
	}
	if (authority == _session.self()) {
		target.view = net::BodyView();
	}
	target.authority = authority;
	target.forget_transform();
	target.sampler.clear();
	target.is_ended = false;
	_session.set_owner(target.body, authority);
	if (authority == _session.self()) {
		_session.set_priority(target.body, int(target.synchronizer->get_priority()));
		target.release();
		return;
	}
	net::BodySource source{ authority, target.body, 0 };
	for (const Departed &departed : _departed) {
		if (departed.body == target.body && departed.node != target.node) {
			source.min_life = std::max(source.min_life, departed.view.life() + 1);
		}
	}
	target.view.follow(source, now);
}

void Replicator::before_scripts() {
	if (!_session.is_sending()) {
		return;
	}
	const Busy busy(*this);
	for (Target &target : _targets) {
		const Node *node = target.authority == _session.self() ? find_known_spatial(target.node) : nullptr;
		if (node == nullptr) {
			continue;
		}
		const Transform3D transform = local_transform(node, target.is_2d);
		if (!target.is_unchanged(transform) && is_moved_by_physics(node)) {
			target.forget_transform();
		}
		target.before_scripts(transform);
	}
}

void Replicator::sample_targets(double now) {
	observe_departed();
	bool has_frame_motion = false;
	for (Target &target : _targets) {
		Node *node = find_known_spatial(target.node);
		if (node == nullptr) {
			continue;
		}
		const int32_t authority = node->get_multiplayer_authority();
		if (authority != target.authority) {
			change_authority(target, authority, now);
			node = target.is_removed ? nullptr : find_known_spatial(target.node);
		}
		if (node != nullptr && authority == _session.self() && _session.is_sending()) {
			sample(target, node);
			has_frame_motion = has_frame_motion || !target.sampler.is_empty();
		}
	}
	if (!has_frame_motion) {
		_frame_clock.settle();
	}
}

void Replicator::sample(Target &target, Node *node) {
	const Transform3D transform = local_transform(node, target.is_2d);
	const bool moves_in_frames = target.after_scripts(transform);
	if (target.is_unchanged(transform) && (!moves_in_frames || target.is_settled) && _session.observe(target.body)) {
		if (moves_in_frames) {
			target.sampler.extend(_frame_clock.frame_time());
		}
		return;
	}
	auto pose = target.read_pose(transform);
	if (target.is_removed) {
		return; // by a callback of the message that read_pose() prints
	}
	if (!pose) {
		_session.observe(target.body);
		return;
	}
	if (moves_in_frames) {
		const double time = _frame_clock.tick_time() - _frame_clock.lag();
		target.sampler.add(_frame_clock.frame_time(), *pose);
		target.is_settled = target.sampler.rests_at(time);
		pose = target.sampler.at(time);
	} else {
		target.sampler.clear();
		target.is_settled = false;
	}
	if (_session.observe(target.body, to_stream(*pose, target.is_2d, _settings), target.is_2d)) {
		target.clear_fault();
	} else {
		target.report_out_of_range();
	}
}

/// The last pose of bodies whose nodes were reparented or renamed since the last tick, in the space of the old parent.
void Replicator::observe_departed() {
	if (!_session.is_sending()) {
		return;
	}
	for (const Departed &departed : _departed) {
		const Node *node = departed.is_own && _targets.has(departed.node) ? find_spatial(departed.node) : nullptr;
		const Node *parent = Object::cast_to<Node>(ObjectDB::get_instance(departed.parent));
		if (node == nullptr || parent == nullptr) {
			continue;
		}
		const PoseResult pose = nearest_pose_from_transform(change_parent(local_transform(node), node->get_parent(), parent));
		if (pose) {
			const bool is_2d = is_node_2d(node);
			(void)_session.observe(departed.body, to_stream(*pose, is_2d, _settings), is_2d);
		}
	}
}

void Replicator::show_streams(double now) {
	for (Target &target : _targets) {
		Node *node = find_known_spatial(target.node);
		if (node == nullptr) {
			continue;
		}
		const int32_t authority = node->get_multiplayer_authority();
		if (authority != target.authority) {
			change_authority(target, authority, now);
			node = target.is_removed ? nullptr : find_known_spatial(target.node);
		}
		if (node != nullptr && authority != _session.self()) {
			show(target, node, now);
		}
	}
}

void Replicator::show(Target &target, Node *node, double now) {
	const bool had_shown = target.view.has_shown();
	const net::BodyView::Frame frame = target.view.frame(_session, now);
	const Node *parent = node->get_parent();
	const Node *previous_parent = target.previous_parent != 0 ? Object::cast_to<Node>(ObjectDB::get_instance(target.previous_parent)) : parent;
	const net::Receiver *stream = _session.stream(target.authority);
	const net::StreamSettings &settings = stream != nullptr ? stream->settings() : _settings;
	const auto to_transform = [&](const cga::Pose<double> &pose) { return from_stream(pose, target.is_2d, settings); };
	const auto from_previous = [&](const cga::Pose<double> &pose) { return change_parent(to_transform(pose), previous_parent, parent); };
	const bool is_interpolated = node->get_tree()->is_physics_interpolation_enabled();
	switch (frame.phase) {
		case Phase::UNKNOWN:
			if (target.synchronizer->is_hide_until_known() && !had_shown && _session.can_receive(target.authority) && now - target.view.followed_at() < MAX_HIDDEN) {
				target.hide();
			} else {
				target.reveal();
			}
			break;
		case Phase::UNBORN:
			target.place(to_transform(*frame.pose), is_interpolated);
			target.reveal();
			break;
		case Phase::PREVIOUS:
		case Phase::HELD:
			if (frame.pose && previous_parent != nullptr) {
				target.place(from_previous(*frame.pose), is_interpolated);
			}
			break;
		case Phase::CURRENT: {
			const Transform3D transform = to_transform(*frame.pose);
			if (frame.begins && had_shown) {
				const Transform3D from = frame.previous_pose && previous_parent != nullptr ? from_previous(*frame.previous_pose) : local_transform(node);
				target.begin_blend(from, transform, now);
			}
			target.previous_parent = 0;
			target.place(target.blended(transform, now, target.synchronizer->get_blend_time()), is_interpolated);
			target.reveal();
			break;
		}
		case Phase::ENDED:
			if (!target.is_ended) {
				target.is_ended = true;
				if (frame.pose) {
					target.place(to_transform(*frame.pose), is_interpolated);
				}
				if (!target.is_removed) {
					set_shown(find_spatial(target.node), false);
				}
				if (!target.is_removed) {
					emit(target.synchronizer, "target_ended", { target.node });
				}
			}
			break;
	}
}

/// Reports owners that are not connected, lines that do not carry the motion, and bodies that have no node on this peer.
void Replicator::check_streams(double now) {
	if (now < _next_check) {
		return;
	}
	_next_check = now + CHECK_INTERVAL;
	std::vector<std::pair<std::string, godot::String>> faults; // warned of last: a Logger may change what this method iterates over
	std::unordered_map<int32_t, double> absent; // owners, and the negative ids of peers with bodies without a node
	const auto is_reported = [&](int32_t key) {
		const auto before = _absent_since.find(key);
		absent[key] = before != _absent_since.end() ? before->second : now;
		return now - absent[key] > MAX_ABSENT;
	};
	for (const Target &target : _targets) {
		if (target.authority == 0 || target.authority == _session.self() || _session.can_receive(target.authority) || absent.count(target.authority) != 0) {
			continue;
		}
		const Node *node = find_spatial(target.node);
		if (is_reported(target.authority) && node != nullptr) {
			faults.emplace_back("owner " + std::to_string(target.authority), vformat("the authority of %s, peer %d, is not connected to this peer, so its motion cannot arrive. Set \"relay\" on all peers, or SceneMultiplayer.server_relay, or give the node to a connected peer with set_multiplayer_authority().", node->get_path(), target.authority));
		}
	}
	std::vector<int32_t> owners = _session.relayed_owners();
	owners.insert(owners.end(), _session.peers().begin(), _session.peers().end());
	for (const int32_t peer : owners) {
		const net::SessionStatistics statistics = _session.statistics(peer, now);
		if (statistics.relaxation > NOTABLE_RELAXATION) {
			_warnings.warn("line " + std::to_string(peer), vformat("the line to peer %d carries about %d bytes per second, which is less than the motion of the targets needs. Errors at that peer are up to %d times the tolerances. Replicate fewer targets, raise position_tolerance, rotation_tolerance or max_latency, or lower send_rate.", peer, int64_t(statistics.line_rate), int64_t(statistics.relaxation)));
		}
		const net::Receiver *stream = _session.stream(peer);
		if (stream == nullptr) {
			continue;
		}
		const std::vector<uint32_t> bodies = stream->bodies();
		const int64_t missing = std::count_if(bodies.begin(), bodies.end(), [this](uint32_t body) { return _node_of_body.count(body) == 0; });
		if (missing > 0 && is_reported(-peer)) {
			faults.emplace_back("bodies " + std::to_string(peer), vformat("peer %d replicates %d bodies, of which %d have no node on this peer: no target has their path. Create the nodes under the same names on all peers, or remove the targets there.", peer, int64_t(bodies.size()), missing));
		}
	}
	_absent_since.swap(absent);
	for (const auto &[key, text] : faults) {
		_warnings.warn(key, text);
	}
}

} // namespace ga_godot
