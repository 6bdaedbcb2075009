#include "godot/net/replicator.hpp"

#include "godot/algebra/conversions.hpp"
#include "godot/net/motor_synchronizer.hpp"
#include "godot/net/setup_warnings.hpp"
#include "godot/net/spatial_node.hpp"
#include "net/session/path_hash.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <algorithm>

// Which nodes are targets, and which bodies they are.

namespace ga_godot {

using godot::Array;
using godot::Node;
using godot::NodePath;
using godot::Object;
using godot::ObjectDB;
using godot::String;
using godot::TypedArray;
using godot::vformat;

// A node that has left the tree is remembered this long, in seconds.
static constexpr double DEPARTED_TIME = 1.0;
// Seconds between free_target and the end of the node, in addition to the delays of other peers.
static constexpr double FREE_MARGIN = 0.4;

static uint64_t parent_of(const Node *node) {
	return node != nullptr && node->get_parent() != nullptr ? node->get_parent()->get_instance_id() : 0;
}

String Replicator::relative_path(const Node *node) const {
	const String path = node->get_path();
	return path.begins_with(_root) ? path.substr(_root.length()) : path;
}

void Replicator::refresh(MotorSynchronizer *synchronizer) {
	const Busy busy(*this);
	TargetSelection &selection = synchronizer->selection();
	if (!selection.is_refresh_due(*synchronizer)) {
		return;
	}
	const std::vector<uint64_t> ids = selection.find(*synchronizer, _root);
	if (!selection.has_changed(ids)) {
		return;
	}
	// Callbacks may refresh the same synchronizer, which replaces what is left to do here, or remove it.
	const uint64_t revision = selection.revision();
	const auto is_current = [&] { return selection.revision() == revision && has(synchronizer); };
	const std::unordered_set<uint64_t> selected(ids.begin(), ids.end());
	std::vector<uint64_t> removed;
	std::vector<uint64_t> added;
	for (Target *target : _targets.select([&](const Target &other) { return other.synchronizer == synchronizer && selected.count(other.node) == 0; })) {
		if (is_current() && !target->is_removed) {
			removed.push_back(target->node);
			end_target(*target);
		}
	}
	for (const uint64_t id : ids) {
		if (is_current() && !_targets.has(id) && add_target(id, synchronizer)) {
			added.push_back(id);
		}
	}
	if (is_current()) {
		selection.remember(ids);
	}
	// Emit signals last, because their handlers may modify the targets and remove the synchronizer.
	emit(synchronizer, "target_removed", removed);
	emit(synchronizer, "target_added", added);
}

void Replicator::emit(MotorSynchronizer *synchronizer, const char *signal, const std::vector<uint64_t> &nodes) {
	for (const uint64_t id : nodes) {
		Node *node = find_spatial(id);
		if (node != nullptr && has(synchronizer)) {
			synchronizer->emit_signal(signal, node);
		}
	}
}

/// Returns false if the node cannot be a target, which is reported.
bool Replicator::add_target(uint64_t id, MotorSynchronizer *synchronizer) {
	Node *node = find_spatial(id);
	if (node == nullptr || !node->is_inside_tree() || std::count(_exiting.begin(), _exiting.end(), id) > 0) {
		return false; // freed or moved by a callback
	}
	const String path = relative_path(node);
	if (path.contains("@")) {
		_warnings.warn("automatic name", automatic_name_fault(*node));
		return false;
	}
	const String faults[] = { thread_fault(*node), dimension_fault(*node) };
	Target target(id, net::path_body(to_utf8(path)), synchronizer, is_node_2d(node));
	if (!claim_body(target)) {
		return false;
	}
	const auto departed = std::find_if(_departed.begin(), _departed.end(), [id](const Departed &entry) { return entry.node == id; });
	if (departed != _departed.end()) {
		target.view = departed->view;
		target.previous_parent = departed->parent;
	}
	node->connect("tree_exiting", callable_mp(synchronizer, &MotorSynchronizer::_on_target_exiting).bindv(Array{ id }));
	_targets.add(target);
	for (const String &fault : faults) {
		if (!fault.is_empty()) {
			_warnings.warn(to_utf8(fault), fault);
		}
	}
	return true;
}

/// Returns false and reports the collision once if another target has the same body.
bool Replicator::claim_body(const Target &target) {
	const auto [holder, is_claimed] = _node_of_body.emplace(target.body, target.node);
	if (!is_claimed) {
		const Node *other = find_spatial(holder->second);
		const String path = find_spatial(target.node)->get_path();
		if (_warnings.is_first("hash " + to_utf8(path))) {
			ERR_PRINT(vformat("MotorSynchronizer %s: the paths of %s and %s have the same hash, so peers cannot tell them apart. The first is not replicated; rename one of them on all peers.", target.synchronizer->get_path(), path, other != nullptr ? other->get_path() : NodePath()));
		}
		return false;
	}
	for (Departed &departed : _departed) {
		if (departed.is_own && departed.body == target.body) {
			// The body of an earlier node of this name ends here, and another begins.
			_session.remove_body(departed.body);
			departed.is_own = false;
		}
	}
	return true;
}

void Replicator::end_target(Target &target) {
	if (target.is_removed) {
		return;
	}
	_targets.remove(target);
	Node *node = find_spatial(target.node);
	const auto holder = _node_of_body.find(target.body);
	if (holder != _node_of_body.end() && holder->second == target.node) {
		const bool is_own = _session.is_connected() && target.authority == _session.self();
		_departed.push_back({ target.node, target.body, parent_of(node), is_own, target.view, clock_seconds() });
		if (!is_own) {
			_session.remove_body(target.body);
		}
		_node_of_body.erase(holder);
	}
	for (MotorSynchronizer *synchronizer : _synchronizers) {
		synchronizer->selection().forget();
	}
	if (node != nullptr) {
		node->disconnect("tree_exiting", callable_mp(target.synchronizer, &MotorSynchronizer::_on_target_exiting));
	}
	target.release();
}

/// Ends the bodies of this peer whose nodes have left, after the tick in which they were last observed.
void Replicator::remove_departed() {
	const double now = clock_seconds();
	for (Departed &departed : _departed) {
		if (departed.is_own && _node_of_body.count(departed.body) == 0) {
			_session.remove_body(departed.body);
		}
		departed.is_own = false;
	}
	_departed.erase(std::remove_if(_departed.begin(), _departed.end(), [now](const Departed &departed) { return now - departed.time > DEPARTED_TIME; }), _departed.end());
}

/// Updates the bodies after a target, or a node above it, was renamed: a body is the hash of a path.
void Replicator::rename_targets() {
	_are_names_stale = false;
	_node_of_body.clear();
	std::vector<Target *> refused;
	for (Target *renamed : _targets.select([](const Target &) { return true; })) {
		Target &target = *renamed;
		const Node *node = find_spatial(target.node);
		const uint32_t body = node != nullptr ? net::path_body(to_utf8(relative_path(node))) : target.body;
		if (body != target.body) {
			_departed.push_back({ target.node, target.body, parent_of(node), target.authority == _session.self(), target.view, clock_seconds() });
			target.previous_parent = parent_of(node);
			target.authority = 0;
			target.body = body;
		}
		if (!target.is_removed && !claim_body(target)) {
			refused.push_back(&target);
		}
	}
	for (Target *target : refused) {
		end_target(*target);
	}
}

TypedArray<Node> Replicator::targets_of(const MotorSynchronizer *synchronizer) const {
	TypedArray<Node> nodes;
	for (const Target &target : _targets) {
		if (target.synchronizer == synchronizer) {
			nodes.push_back(find_spatial(target.node));
		}
	}
	return nodes;
}

void Replicator::target_exiting(uint64_t id) {
	const Busy busy(*this);
	Target *target = _targets.find(id);
	if (target == nullptr) {
		return;
	}
	MotorSynchronizer *synchronizer = target->synchronizer;
	_exiting.push_back(id);
	end_target(*target);
	emit(synchronizer, "target_removed", { id });
	_exiting.pop_back();
	// The node may only be moving to another parent, so search again.
	synchronizer->selection().invalidate();
	synchronizer->selection().forget();
}

void Replicator::node_renamed(const Node *renamed) {
	const auto is_above = [renamed](Node *below) { return below != nullptr && (renamed == below || renamed->is_ancestor_of(below)); };
	for (const Target &target : _targets) {
		_are_names_stale = _are_names_stale || is_above(find_spatial(target.node));
	}
}

void Replicator::update_priorities(const MotorSynchronizer *synchronizer) {
	for (const Target &target : _targets) {
		if (target.synchronizer == synchronizer) {
			_session.set_priority(target.body, int(synchronizer->get_priority()));
		}
	}
}

void Replicator::free_target(Target &target) {
	const Busy busy(*this);
	target.is_freed = true;
	const double now = clock_seconds();
	const double delay = _settings.max_latency + target.synchronizer->get_jitter_allowance() + _session.total_statistics(now).round_trip;
	_freed.push_back({ target.node, now + delay + FREE_MARGIN });
	set_shown(find_spatial(target.node), false);
	if (Node *node = find_spatial(target.node)) {
		node->set_process_mode(Node::PROCESS_MODE_DISABLED);
	}
}

/// Ends the bodies of nodes that free_target ends, after their last pose has been observed.
void Replicator::end_freed_bodies() {
	std::vector<std::pair<MotorSynchronizer *, uint64_t>> ended;
	for (Target *target : _targets.select([](const Target &other) { return other.is_freed; })) {
		if (!target->is_removed) {
			_session.free_body(target->body);
			_node_of_body.erase(target->body);
			target->synchronizer->selection().remove(target->node);
			ended.emplace_back(target->synchronizer, target->node);
			end_target(*target);
		}
	}
	for (const auto &[synchronizer, node] : ended) {
		emit(synchronizer, "target_removed", { node });
	}
}

void Replicator::free_ended(double now) {
	for (const Freed &freed : _freed) {
		Node *node = freed.free_at <= now ? find_spatial(freed.node) : nullptr;
		if (node != nullptr) {
			node->queue_free();
		}
	}
	_freed.erase(std::remove_if(_freed.begin(), _freed.end(), [now](const Freed &freed) { return freed.free_at <= now; }), _freed.end());
}

} // namespace ga_godot
