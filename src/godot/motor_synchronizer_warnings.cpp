#include "godot/motor_synchronizer.hpp"

#include <godot_cpp/classes/multiplayer_synchronizer.hpp>
#include <godot_cpp/classes/scene_replication_config.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/core/object.hpp>

#include <algorithm>

// What is wrong with the set-up, as far as the scene shows it.

namespace ga_godot {

using godot::MultiplayerSynchronizer;
using godot::Node;
using godot::Node3D;
using godot::NodePath;
using godot::Object;
using godot::PackedStringArray;
using godot::Ref;
using godot::SceneReplicationConfig;
using godot::String;
using godot::StringName;
using godot::TypedArray;
using godot::vformat;

static constexpr int64_t FRAMES_BETWEEN_LOOKS = 60;

// Properties of a Node3D that another synchronizer must not send as well.
static bool is_pose_property(const String &p_name) {
	static constexpr const char *NAMES[] = { "transform", "position", "rotation", "rotation_degrees", "quaternion", "basis", "scale", "global_transform", "global_position", "global_rotation", "global_rotation_degrees", "global_basis" };
	return std::any_of(std::begin(NAMES), std::end(NAMES), [&](const char *p_pose) { return p_name == String(p_pose); });
}

/// The top of what belongs together: the edited scene, or the whole tree.
static Node *find_top(const Node *p_node) {
	if (p_node->is_part_of_edited_scene()) {
		return p_node->get_tree()->get_edited_scene_root();
	}
	Node *top = const_cast<Node *>(p_node);
	while (Node *parent = top->get_parent()) {
		top = parent;
	}
	return top;
}

/// The name of the pose property of a node that a MultiplayerSynchronizer sends; empty if it sends none.
static String find_sent_pose(MultiplayerSynchronizer *p_synchronizer, const Node3D *p_node) {
	const Ref<SceneReplicationConfig> config = p_synchronizer->get_replication_config();
	const Node *root = p_synchronizer->get_node_or_null(p_synchronizer->get_root_path());
	if (config.is_null() || root == nullptr) {
		return String();
	}
	const TypedArray<NodePath> properties = config->get_properties();
	for (int64_t i = 0; i < properties.size(); i++) {
		const NodePath path = properties[i];
		const String property = String(path.get_concatenated_subnames()).get_slice(":", 0);
		const StringName names = path.get_concatenated_names();
		const Node *node = names == StringName() ? root : root->get_node_or_null(NodePath(String(names)));
		if (node == p_node && is_pose_property(property)) {
			return property;
		}
	}
	return String();
}

PackedStringArray MotorSynchronizer::get_setup_warnings() const {
	PackedStringArray faults;
	if (!is_inside_tree()) {
		return faults;
	}
	if (_paths.is_empty() && _group == StringName() && _added.empty()) {
		faults.push_back("Nothing is replicated: assign \"targets\", name a \"target_group\", or call add_target() from a script.");
	}
	std::vector<const Node3D *> nodes;
	for (int64_t i = 0; i < _paths.size(); i++) {
		const NodePath path = _paths[i];
		if (const Node3D *node = Object::cast_to<Node3D>(path.is_empty() ? nullptr : get_node_or_null(path))) {
			nodes.push_back(node);
		} else {
			faults.push_back(vformat("targets[%d] (\"%s\") does not lead to a Node3D.", i, path));
		}
	}
	if (_group != StringName()) {
		const std::size_t before = nodes.size();
		const TypedArray<Node> members = get_tree()->get_nodes_in_group(_group);
		for (int64_t i = 0; i < members.size(); i++) {
			if (const Node3D *node = Object::cast_to<Node3D>(members[i].get_validated_object())) {
				nodes.push_back(node);
			}
		}
		if (nodes.size() == before) {
			faults.push_back(vformat("No Node3D of this scene is in the group \"%s\". That is right only if all of them are spawned later.", _group));
		}
	}
	for (const Node3D *node : nodes) {
		find_target_faults(node, faults);
	}
	return faults;
}

void MotorSynchronizer::find_target_faults(const Node3D *p_node, PackedStringArray &r_faults) const {
	const TypedArray<Node> others = get_tree()->get_nodes_in_group(GROUP);
	for (int64_t i = 0; i < others.size(); i++) {
		const MotorSynchronizer *other = Object::cast_to<MotorSynchronizer>(others[i].get_validated_object());
		if (other != nullptr && other != this && other->names_target(p_node)) {
			r_faults.push_back(vformat("%s is a target of %s too; one of the two is enough.", p_node->get_name(), other->get_name()));
		}
	}
	const TypedArray<Node> synchronizers = find_top(this)->find_children("*", "MultiplayerSynchronizer", true, false);
	for (int64_t i = 0; i < synchronizers.size(); i++) {
		MultiplayerSynchronizer *synchronizer = Object::cast_to<MultiplayerSynchronizer>(synchronizers[i].get_validated_object());
		const String property = synchronizer != nullptr ? find_sent_pose(synchronizer, p_node) : String();
		if (!property.is_empty()) {
			r_faults.push_back(vformat("%s of %s is replicated by the MultiplayerSynchronizer %s too; remove it there.", property, p_node->get_name(), synchronizer->get_name()));
		}
	}
	if (p_node->is_class("RigidBody3D") && !bool(p_node->get("freeze"))) {
		r_faults.push_back(vformat("%s is a RigidBody3D that every peer would simulate. Set freeze, with freeze_mode Kinematic, and unfreeze it where is_multiplayer_authority() holds.", p_node->get_name()));
	}
}

bool MotorSynchronizer::names_target(const Node3D *p_node) const {
	if (_group != StringName() && p_node->is_in_group(_group)) {
		return true;
	}
	for (int64_t i = 0; i < _paths.size(); i++) {
		const NodePath path = _paths[i];
		if (!path.is_empty() && get_node_or_null(path) == p_node) {
			return true;
		}
	}
	return std::find(_added.begin(), _added.end(), p_node->get_instance_id()) != _added.end();
}

PackedStringArray MotorSynchronizer::_get_configuration_warnings() const {
	return get_setup_warnings();
}

/// In the editor, where groups and other nodes change without a word.
void MotorSynchronizer::watch_warnings() {
	if (--_watch_in > 0) {
		return;
	}
	_watch_in = FRAMES_BETWEEN_LOOKS;
	const PackedStringArray warnings = get_setup_warnings();
	if (!(warnings == _shown_warnings)) {
		_shown_warnings = warnings;
		update_configuration_warnings();
	}
}

} // namespace ga_godot
