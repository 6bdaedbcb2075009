#include "godot/net/target_selection.hpp"

#include "godot/net/spatial_node.hpp"

#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/core/object.hpp>

#include <algorithm>
#include <unordered_set>

namespace ga_godot {

using godot::Node;
using godot::NodePath;
using godot::Object;
using godot::ObjectDB;
using godot::String;
using godot::StringName;
using godot::TypedArray;

// The engine does not report when a node joins or leaves a group. We compare the number of members each tick, and every few
// ticks the members themselves.
static constexpr int64_t TICKS_BETWEEN_REFRESHES = 15;

static void erase(std::vector<uint64_t> &ids, uint64_t id) {
	ids.erase(std::remove(ids.begin(), ids.end(), id), ids.end());
}

static void insert(std::vector<uint64_t> &ids, uint64_t id) {
	if (std::find(ids.begin(), ids.end(), id) == ids.end()) {
		ids.push_back(id);
	}
}

static void erase_freed(std::vector<uint64_t> &ids) {
	ids.erase(std::remove_if(ids.begin(), ids.end(), [](uint64_t id) { return ObjectDB::get_instance(id) == nullptr; }), ids.end());
}

void TargetSelection::set_paths(const TypedArray<NodePath> &paths) {
	_paths = paths;
	_is_stale = true;
}

void TargetSelection::set_group(const StringName &group) {
	_group = group;
	_is_stale = true;
}

void TargetSelection::add(uint64_t node) {
	erase(_excluded, node);
	insert(_added, node);
	_is_stale = true;
}

void TargetSelection::remove(uint64_t node) {
	erase(_added, node);
	insert(_excluded, node);
	_is_stale = true;
}

bool TargetSelection::is_empty() const {
	return _paths.is_empty() && _group == StringName() && _added.empty();
}

bool TargetSelection::selects(const Node &synchronizer, const Node *node) const {
	if (_group != StringName() && node->is_in_group(_group)) {
		return true;
	}
	for (int64_t i = 0; i < _paths.size(); i++) {
		if (find_spatial(synchronizer, _paths[i]) == node) {
			return true;
		}
	}
	return std::find(_added.begin(), _added.end(), node->get_instance_id()) != _added.end();
}

bool TargetSelection::is_refresh_due(const Node &synchronizer) {
	if (_is_stale || --_refresh_in <= 0) {
		return true;
	}
	if (_group != StringName() && synchronizer.get_tree()->get_node_count_in_group(_group) != _group_count) {
		return true;
	}
	return std::any_of(_unresolved.begin(), _unresolved.end(), [&](const NodePath &path) { return find_spatial(synchronizer, path) != nullptr; });
}

std::vector<uint64_t> TargetSelection::find(const Node &synchronizer, const String &root) {
	_revision++;
	_is_stale = false;
	_refresh_in = TICKS_BETWEEN_REFRESHES;
	erase_freed(_added);
	erase_freed(_excluded);
	std::vector<uint64_t> ids;
	std::unordered_set<uint64_t> seen(_excluded.begin(), _excluded.end());
	const Node *top = root == String("/root/") ? nullptr : synchronizer.get_node_or_null(root);
	// Skip nodes outside `root`: other branches of the tree may have their own MultiplayerAPI and synchronizer.
	const auto gather = [&](Node *node) {
		if (node != nullptr && is_spatial(node) && node->is_inside_tree() && seen.insert(node->get_instance_id()).second && (top == nullptr || top->is_ancestor_of(node))) {
			ids.push_back(node->get_instance_id());
		}
	};
	_unresolved.clear();
	for (int64_t i = 0; i < _paths.size(); i++) {
		const NodePath path = _paths[i];
		if (Node *node = find_spatial(synchronizer, path)) {
			gather(node);
		} else if (!path.is_empty()) {
			_unresolved.push_back(path);
		}
	}
	for (const uint64_t id : _added) {
		gather(find_spatial(id));
	}
	if (_group != StringName()) {
		const TypedArray<Node> members = synchronizer.get_tree()->get_nodes_in_group(_group);
		_group_count = members.size();
		for (int64_t i = 0; i < members.size(); i++) {
			gather(Object::cast_to<Node>(members[i].get_validated_object()));
		}
	}
	return ids;
}

} // namespace ga_godot
