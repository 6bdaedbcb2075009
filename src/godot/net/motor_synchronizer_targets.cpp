#include "godot/net/motor_synchronizer.hpp"

#include "net/session/path_hash.hpp"

#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/callable.hpp>

#include <algorithm>
#include <unordered_set>

// Maps nodes to bodies and back.

namespace ga_godot {

using godot::Array;
using godot::Callable;
using godot::Node;
using godot::Node3D;
using godot::NodePath;
using godot::Object;
using godot::Transform3D;
using godot::TypedArray;
using godot::vformat;

static Target *find_target(std::vector<Target> &targets, uint64_t id) {
	const auto found = std::find_if(targets.begin(), targets.end(), [id](const Target &target) { return target.node == id; });
	return found != targets.end() ? &*found : nullptr;
}

void MotorSynchronizer::add_target(Node3D *node) {
	ERR_FAIL_NULL_MSG(node, "MotorSynchronizer.add_target: the node is null.");
	_selection.add(node->get_instance_id());
	if (_is_running) {
		refresh_targets();
	}
}

void MotorSynchronizer::remove_target(Node3D *node) {
	ERR_FAIL_NULL_MSG(node, "MotorSynchronizer.remove_target: the node is null.");
	_selection.remove(node->get_instance_id());
	if (_is_running) {
		refresh_targets();
	}
}

TypedArray<Node3D> MotorSynchronizer::get_active_targets() const {
	TypedArray<Node3D> nodes;
	for (const Target &target : _targets) {
		nodes.push_back(find_node(target.node));
	}
	return nodes;
}

void MotorSynchronizer::teleport(Node3D *node) {
	ERR_FAIL_NULL_MSG(node, "MotorSynchronizer.teleport: the node is null.");
	const Target *target = find_target(_targets, node->get_instance_id());
	ERR_FAIL_NULL_MSG(target, vformat("MotorSynchronizer.teleport: %s is not a target of %s.", node->get_name(), get_name()));
	const int32_t authority = node->get_multiplayer_authority();
	ERR_FAIL_COND_MSG(_session.is_connected() && authority != _session.self(), vformat("MotorSynchronizer.teleport: only the authority of %s, peer %d, can teleport it.", node->get_name(), authority));
	_session.teleport(target->body);
}

void MotorSynchronizer::refresh_targets() {
	// Before the first tick, nodes may still be entering the tree, and the multiplayer root is unknown.
	if (_api.is_null() || !_selection.is_refresh_due(*this)) {
		return;
	}
	std::vector<uint64_t> ids = _selection.find(*this, _root);
	if (ids == _found) {
		return;
	}
	_found = ids;
	const std::unordered_set<uint64_t> selected(ids.begin(), ids.end());
	std::unordered_set<uint64_t> present;
	std::vector<uint64_t> removed, added;
	for (size_t i = _targets.size(); i-- > 0;) {
		if (selected.count(_targets[i].node) == 0) {
			removed.push_back(_targets[i].node);
			end_target(i);
		} else {
			present.insert(_targets[i].node);
		}
	}
	for (const uint64_t id : ids) {
		if (present.count(id) != 0) {
			continue;
		}
		Node3D *node = find_node(id);
		const Target target(id, net::path_body(to_utf8(relative_path(node))));
		if (claim_body(target)) {
			node->connect("tree_exiting", Callable(this, "_on_target_exiting").bindv(Array{ id }));
			_targets.push_back(target);
			added.push_back(id);
		}
	}
	// Emit signals last, because their handlers may modify the targets.
	for (const uint64_t id : removed) {
		if (Node3D *node = find_node(id)) {
			emit_signal("target_removed", node);
		}
	}
	for (const uint64_t id : added) {
		if (Node3D *node = find_node(id)) {
			emit_signal("target_added", node);
		}
	}
}

/// Returns false and reports the collision once if another target has the same body.
bool MotorSynchronizer::claim_body(const Target &target) {
	const auto [holder, is_claimed] = _node_of_body.emplace(target.body, target.node);
	const auto refused = std::find(_refused.begin(), _refused.end(), target.node);
	if (is_claimed) {
		if (refused != _refused.end()) {
			_refused.erase(refused);
		}
		return true;
	}
	if (refused == _refused.end()) {
		_refused.push_back(target.node);
		const Node3D *other = find_node(holder->second);
		ERR_PRINT(vformat("MotorSynchronizer %s: the paths of %s and %s have the same hash, so peers cannot tell them apart. The first is not replicated; rename one of them on all peers.", get_path(), find_node(target.node)->get_path(), other != nullptr ? other->get_path() : NodePath()));
	}
	return false;
}

void MotorSynchronizer::end_target(size_t index) {
	Target &target = _targets[index];
	target.release();
	if (Node3D *node = find_node(target.node)) {
		node->disconnect("tree_exiting", Callable(this, "_on_target_exiting"));
	}
	const auto holder = _node_of_body.find(target.body);
	if (holder != _node_of_body.end() && holder->second == target.node) {
		_session.remove_body(target.body);
		_node_of_body.erase(holder);
	}
	_targets[index] = _targets.back();
	_targets.pop_back();
	_found.clear();
}

/// Updates the bodies after a target, or a node above it, was renamed: a body is the hash of a path.
void MotorSynchronizer::rename_targets() {
	_are_names_stale = false;
	update_root();
	_node_of_body.clear();
	for (size_t i = _targets.size(); i-- > 0;) {
		Target &target = _targets[i];
		const Node3D *node = find_node(target.node);
		const uint32_t body = node != nullptr ? net::path_body(to_utf8(relative_path(node))) : target.body;
		if (body != target.body) {
			_session.remove_body(target.body);
			target.authority = 0;
			target.body = body;
		}
		if (!claim_body(target)) {
			end_target(i);
		}
	}
}

void MotorSynchronizer::sample_targets() {
	for (Target &target : _targets) {
		Node3D *node = find_node(target.node);
		if (node == nullptr) {
			continue;
		}
		const int32_t authority = node->get_multiplayer_authority();
		if (authority != target.authority) {
			target.release();
			target.authority = authority;
			target.forget_transform();
			_session.set_owner(target.body, authority);
		}
		if (authority != _session.self() || !_session.is_sending()) {
			continue;
		}
		const Transform3D transform = node->get_transform();
		if (target.is_unchanged(transform) && _session.observe(target.body)) {
			continue;
		}
		const auto pose = target.read_pose(transform, get_path());
		if (!pose) {
			_session.observe(target.body);
		} else if (_session.observe(target.body, *pose)) {
			target.clear_fault();
		} else {
			target.report_out_of_range(get_path());
		}
	}
}

void MotorSynchronizer::show_streams() {
	const bool is_interpolated = get_tree()->is_physics_interpolation_enabled();
	const net::Receiver *stream = nullptr;
	int32_t authority = 0;
	for (Target &target : _targets) {
		if (target.authority == _session.self()) {
			continue;
		}
		if (target.authority != authority) {
			authority = target.authority;
			stream = _session.stream(authority);
		}
		if (const auto pose = stream != nullptr ? stream->pose(target.body) : std::nullopt) {
			target.place(to_godot(*pose), is_interpolated);
		}
	}
}

void MotorSynchronizer::_on_target_exiting(int64_t id) {
	const Target *target = find_target(_targets, uint64_t(id));
	if (target == nullptr) {
		return;
	}
	end_target(size_t(target - _targets.data()));
	// The node may only be moving to another parent, so search again in the next tick.
	_selection.invalidate();
	emit_signal("target_removed", find_node(uint64_t(id)));
}

void MotorSynchronizer::_on_node_renamed(const godot::Variant &node) {
	const Node *renamed = Object::cast_to<Node>(node.get_validated_object());
	const auto is_above = [renamed](Node *below) { return below != nullptr && (renamed == below || renamed->is_ancestor_of(below)); };
	_are_names_stale = _are_names_stale || is_above(this) || std::any_of(_targets.begin(), _targets.end(), [&](const Target &target) { return is_above(find_node(target.node)); });
}

} // namespace ga_godot
