#include "godot/net/motor_synchronizer.hpp"

#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/callable.hpp>

#include <algorithm>
#include <unordered_set>

// What is replicated: nodes by path, by group and by add_target, as they come and go.

namespace ga_godot {

using godot::Array;
using godot::Callable;
using godot::Node;
using godot::Node3D;
using godot::NodePath;
using godot::Object;
using godot::ObjectDB;
using godot::String;
using godot::TypedArray;
using godot::vformat;

// Nobody tells when a node joins a group or leaves it: the number of its members is looked at in each tick, the
// members themselves this often.
static constexpr int64_t TICKS_BETWEEN_REFRESHES = 15;

static bool erase(std::vector<uint64_t> &r_ids, uint64_t p_id) {
	const auto found = std::find(r_ids.begin(), r_ids.end(), p_id);
	if (found == r_ids.end()) {
		return false;
	}
	r_ids.erase(found);
	return true;
}

static bool contains(const std::vector<uint64_t> &p_ids, uint64_t p_id) {
	return std::find(p_ids.begin(), p_ids.end(), p_id) != p_ids.end();
}

Node3D *MotorSynchronizer::node_of(uint64_t p_id) {
	return Object::cast_to<Node3D>(ObjectDB::get_instance(p_id));
}

void MotorSynchronizer::add_target(Node3D *p_node) {
	ERR_FAIL_NULL_MSG(p_node, "MotorSynchronizer.add_target: the node is null.");
	erase(_excluded, p_node->get_instance_id());
	if (!contains(_added, p_node->get_instance_id())) {
		_added.push_back(p_node->get_instance_id());
	}
	_targets_stale = true;
	if (_running) {
		refresh_targets();
	}
}

void MotorSynchronizer::remove_target(Node3D *p_node) {
	ERR_FAIL_NULL_MSG(p_node, "MotorSynchronizer.remove_target: the node is null.");
	erase(_added, p_node->get_instance_id());
	if (!contains(_excluded, p_node->get_instance_id())) {
		_excluded.push_back(p_node->get_instance_id());
	}
	_targets_stale = true;
	if (_running) {
		refresh_targets();
	}
}

TypedArray<Node3D> MotorSynchronizer::get_active_targets() const {
	TypedArray<Node3D> nodes;
	for (const Target &target : _targets) {
		nodes.push_back(node_of(target.node));
	}
	return nodes;
}

MotorSynchronizer::Target *MotorSynchronizer::find_target(uint64_t p_id) {
	const auto found = std::find_if(_targets.begin(), _targets.end(), [&](const Target &p_target) { return p_target.node == p_id; });
	return found != _targets.end() ? &*found : nullptr;
}

/// Ids of all nodes that should be replicated now, each once.
std::vector<uint64_t> MotorSynchronizer::find_targets() {
	std::vector<uint64_t> ids;
	const auto is_gone = [](uint64_t p_id) { return ObjectDB::get_instance(p_id) == nullptr; };
	_added.erase(std::remove_if(_added.begin(), _added.end(), is_gone), _added.end());
	_excluded.erase(std::remove_if(_excluded.begin(), _excluded.end(), is_gone), _excluded.end());
	std::unordered_set<uint64_t> seen(_excluded.begin(), _excluded.end());
	const bool everywhere = _root == String("/root/");
	const Node *root = everywhere ? nullptr : get_node_or_null(_root);
	// Other branches of the tree may have a MultiplayerAPI, and a synchronizer, of their own.
	const auto gather = [&](Node3D *p_node) {
		if (p_node->is_inside_tree() && seen.insert(p_node->get_instance_id()).second && (everywhere || root == nullptr || root->is_ancestor_of(p_node))) {
			ids.push_back(p_node->get_instance_id());
		}
	};
	_unresolved.clear();
	for (int64_t i = 0; i < _paths.size(); i++) {
		const NodePath path = _paths[i];
		if (path.is_empty()) {
			continue;
		}
		if (Node3D *node = Object::cast_to<Node3D>(get_node_or_null(path))) {
			gather(node);
		} else {
			_unresolved.push_back(path);
		}
	}
	for (const uint64_t id : _added) {
		gather(node_of(id));
	}
	if (_group != godot::StringName()) {
		const TypedArray<Node> members = get_tree()->get_nodes_in_group(_group);
		_group_count = members.size();
		for (int64_t i = 0; i < members.size(); i++) {
			if (Node3D *node = Object::cast_to<Node3D>(members[i].get_validated_object())) {
				gather(node);
			}
		}
	}
	return ids;
}

bool MotorSynchronizer::is_refresh_due() {
	if (_targets_stale || --_refresh_in <= 0) {
		return true;
	}
	if (_group != godot::StringName() && get_tree()->get_node_count_in_group(_group) != _group_count) {
		return true;
	}
	return std::any_of(_unresolved.begin(), _unresolved.end(), [this](const NodePath &p_path) { return Object::cast_to<Node3D>(get_node_or_null(p_path)) != nullptr; });
}

void MotorSynchronizer::refresh_targets() {
	// Before the first tick nodes may still be about to enter, and the multiplayer root is not known.
	if (_api.is_null() || !is_refresh_due()) {
		return;
	}
	_targets_stale = false;
	_refresh_in = TICKS_BETWEEN_REFRESHES;
	std::vector<uint64_t> ids = find_targets();
	if (ids == _found) {
		return;
	}
	_found = ids;
	const std::unordered_set<uint64_t> wanted(ids.begin(), ids.end());
	std::unordered_set<uint64_t> present;
	std::vector<uint64_t> removed, added;
	for (size_t i = _targets.size(); i-- > 0;) {
		if (wanted.count(_targets[i].node) == 0) {
			removed.push_back(_targets[i].node);
			end_target(i);
		} else {
			present.insert(_targets[i].node);
		}
	}
	for (const uint64_t id : ids) {
		if (present.count(id) == 0 && begin_target(id)) {
			added.push_back(id);
		}
	}
	// Last, because who hears it may change everything.
	for (const uint64_t id : removed) {
		if (Node3D *node = node_of(id)) {
			emit_signal("target_removed", node);
		}
	}
	for (const uint64_t id : added) {
		if (Node3D *node = node_of(id)) {
			emit_signal("target_added", node);
		}
	}
}

uint32_t MotorSynchronizer::body_of(const Node3D *p_node) const {
	return net::path_body(to_utf8(relative_path(p_node)));
}

/// False if the node cannot be told from another one, which is reported once.
bool MotorSynchronizer::begin_target(uint64_t p_id) {
	Node3D *node = node_of(p_id);
	Target target;
	target.node = p_id;
	target.body = body_of(node);
	if (!claim_body(target)) {
		return false;
	}
	node->connect("tree_exiting", Callable(this, "_on_target_exiting").bindv(Array{ p_id }));
	_targets.push_back(target);
	return true;
}

bool MotorSynchronizer::claim_body(const Target &p_target) {
	const auto [holder, claimed] = _node_of_body.emplace(p_target.body, p_target.node);
	if (claimed) {
		erase(_refused, p_target.node);
		return true;
	}
	if (!contains(_refused, p_target.node)) {
		_refused.push_back(p_target.node);
		const Node3D *other = node_of(holder->second);
		ERR_PRINT(vformat("MotorSynchronizer %s: the paths of %s and %s have the same hash, by which peers know bodies. The first is not replicated; rename one of them.", get_path(), node_of(p_target.node)->get_path(), other != nullptr ? other->get_path() : NodePath()));
	}
	return false;
}

void MotorSynchronizer::end_target(size_t p_index) {
	Target &target = _targets[p_index];
	if (target.sent) {
		_sender->remove_body(target.body);
	}
	if (Node3D *node = node_of(target.node)) {
		release(target, node);
		node->disconnect("tree_exiting", Callable(this, "_on_target_exiting"));
	}
	const auto holder = _node_of_body.find(target.body);
	if (holder != _node_of_body.end() && holder->second == target.node) {
		_node_of_body.erase(holder);
	}
	_targets[p_index] = _targets.back();
	_targets.pop_back();
	_found.clear();
	_streams_stale = true;
}

/// A name above or at a target changed: bodies are known by paths.
void MotorSynchronizer::rename_targets() {
	_names_stale = false;
	update_key();
	_node_of_body.clear();
	for (size_t i = _targets.size(); i-- > 0;) {
		Target &target = _targets[i];
		const Node3D *node = node_of(target.node);
		const uint32_t body = node != nullptr ? body_of(node) : target.body;
		if (body != target.body && target.sent) {
			_sender->remove_body(target.body);
			target.sent = false;
		}
		target.body = body;
		if (!claim_body(target)) {
			end_target(i);
		}
	}
}

void MotorSynchronizer::_on_target_exiting(int64_t p_id) {
	const Target *target = find_target(uint64_t(p_id));
	if (target == nullptr) {
		return;
	}
	end_target(size_t(target - _targets.data()));
	// It may be on its way to another place.
	_targets_stale = true;
	emit_signal("target_removed", node_of(uint64_t(p_id)));
}

void MotorSynchronizer::_on_node_renamed(const godot::Variant &p_node) {
	const Node *renamed = Object::cast_to<Node>(p_node.get_validated_object());
	const auto is_above = [renamed](Node *p_below) { return p_below != nullptr && (renamed == p_below || renamed->is_ancestor_of(p_below)); };
	_names_stale = _names_stale || is_above(this) || std::any_of(_targets.begin(), _targets.end(), [&](const Target &p_target) { return is_above(node_of(p_target.node)); });
}

} // namespace ga_godot
