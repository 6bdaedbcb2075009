#include "godot/net/motor_synchronizer.hpp"

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
static constexpr int64_t MAX_TARGET_FAULTS = 6;

// Properties of a Node3D that another synchronizer must not send as well.
static bool is_pose_property(const String &p_name) {
	static constexpr const char *NAMES[] = { "transform", "position", "rotation", "rotation_degrees", "quaternion", "basis", "scale", "global_transform", "global_position", "global_rotation", "global_rotation_degrees", "global_basis" };
	return std::any_of(std::begin(NAMES), std::end(NAMES), [&](const char *p_pose) { return p_name == String(p_pose); });
}

/// The top of what belongs together: the edited scene, or the whole tree.
static Node *find_top(const Node *p_node) {
	Node *edited = p_node->is_part_of_edited_scene() ? p_node->get_tree()->get_edited_scene_root() : nullptr;
	if (edited != nullptr) {
		return edited;
	}
	Node *top = p_node->get_parent();
	while (top != nullptr && top->get_parent() != nullptr) {
		top = top->get_parent();
	}
	return top;
}

/// A node whose pose a MultiplayerSynchronizer sends.
struct SentPose {
	const Node *node;
	String property;
	StringName synchronizer;
};

static void find_sent_poses(const Node *p_top, std::vector<SentPose> &r_poses) {
	const TypedArray<Node> synchronizers = p_top->find_children("*", "MultiplayerSynchronizer", true, false);
	for (int64_t i = 0; i < synchronizers.size(); i++) {
		MultiplayerSynchronizer *synchronizer = Object::cast_to<MultiplayerSynchronizer>(synchronizers[i].get_validated_object());
		const Ref<SceneReplicationConfig> config = synchronizer->get_replication_config();
		const Node *root = synchronizer->get_node_or_null(synchronizer->get_root_path());
		if (config.is_null() || root == nullptr) {
			continue;
		}
		const TypedArray<NodePath> properties = config->get_properties();
		for (int64_t k = 0; k < properties.size(); k++) {
			const NodePath path = properties[k];
			const String property = String(path.get_concatenated_subnames()).get_slice(":", 0);
			const String names = path.get_concatenated_names();
			const Node *node = names.is_empty() ? root : root->get_node_or_null(NodePath(names));
			if (node != nullptr && is_pose_property(property)) {
				r_poses.push_back({ node, property, synchronizer->get_name() });
			}
		}
	}
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
		const size_t before = nodes.size();
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
	find_target_faults(nodes, faults);
	return faults;
}

void MotorSynchronizer::find_target_faults(const std::vector<const Node3D *> &p_nodes, PackedStringArray &r_faults) const {
	std::vector<SentPose> sent_poses;
	find_sent_poses(find_top(this), sent_poses);
	const TypedArray<Node> others = get_tree()->get_nodes_in_group(GROUP);
	const int64_t most = r_faults.size() + MAX_TARGET_FAULTS;
	for (const Node3D *node : p_nodes) {
		if (r_faults.size() >= most) {
			r_faults.push_back("More targets have such faults.");
			return;
		}
		for (int64_t i = 0; i < others.size(); i++) {
			const MotorSynchronizer *other = Object::cast_to<MotorSynchronizer>(others[i].get_validated_object());
			if (other != nullptr && other != this && other->names_target(node)) {
				r_faults.push_back(vformat("%s is a target of %s too; one of the two is enough.", node->get_name(), other->get_name()));
			}
		}
		for (const SentPose &sent : sent_poses) {
			if (sent.node == node) {
				r_faults.push_back(vformat("%s of %s is replicated by the MultiplayerSynchronizer %s too; remove it there.", sent.property, node->get_name(), sent.synchronizer));
			}
		}
		if (node->is_class("RigidBody3D") && !bool(node->get("freeze"))) {
			r_faults.push_back(vformat("%s is a RigidBody3D that every peer would simulate. Set freeze, with freeze_mode Kinematic, and unfreeze it where is_multiplayer_authority() holds.", node->get_name()));
		}
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
