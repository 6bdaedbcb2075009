#include "godot/net/setup_warnings.hpp"

#include "godot/net/motor_synchronizer.hpp"
#include "godot/net/range_message.hpp"
#include "godot/net/spatial_node.hpp"
#include "godot/net/target.hpp"
#include "godot/thread_guard.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/multiplayer_synchronizer.hpp>
#include <godot_cpp/classes/scene_multiplayer.hpp>
#include <godot_cpp/classes/scene_replication_config.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/core/object.hpp>

#include <algorithm>

namespace ga_godot {

using godot::Engine;
using godot::MultiplayerSynchronizer;
using godot::Node;
using godot::NodePath;
using godot::Object;
using godot::PackedStringArray;
using godot::Ref;
using godot::SceneMultiplayer;
using godot::SceneReplicationConfig;
using godot::String;
using godot::StringName;
using godot::TypedArray;
using godot::vformat;

static constexpr int64_t MAX_TARGET_FAULTS = 6;

/// True if a property of a Node3D or Node2D changes its pose. No other synchronizer may replicate it.
static bool is_pose_property(const String &name) {
	static constexpr const char *NAMES[] = { "transform", "position", "rotation", "rotation_degrees", "skew", "quaternion", "basis", "scale", "global_transform", "global_position", "global_rotation", "global_rotation_degrees", "global_basis" };
	return std::any_of(std::begin(NAMES), std::end(NAMES), [&](const char *pose) { return name == String(pose); });
}

/// The root of the edited scene, or of the whole tree.
static Node *find_top(const Node &node) {
	Node *edited = node.is_part_of_edited_scene() ? node.get_tree()->get_edited_scene_root() : nullptr;
	if (edited != nullptr) {
		return edited;
	}
	Node *top = node.get_parent();
	while (top != nullptr && top->get_parent() != nullptr) {
		top = top->get_parent();
	}
	return top;
}

namespace {

/// A node whose pose a MultiplayerSynchronizer replicates.
struct ReplicatedPose {
	uint64_t node; // instance id
	String property;
	StringName synchronizer;
};

} // namespace

static std::vector<ReplicatedPose> find_replicated_poses(const Node *top) {
	std::vector<ReplicatedPose> poses;
	const TypedArray<Node> synchronizers = top->find_children("*", "MultiplayerSynchronizer", true, false);
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
			const bool is_replicated = config->property_get_replication_mode(path) != SceneReplicationConfig::REPLICATION_MODE_NEVER;
			if (node != nullptr && is_replicated && is_pose_property(property)) {
				poses.push_back({ node->get_instance_id(), property, synchronizer->get_name() });
			}
		}
	}
	return poses;
}

String automatic_name_fault(const Node &node) {
	return vformat("%s has an automatic name, which is different on each peer, so it is not replicated, nor are other nodes with such names. Set its name (and that of its parents) before add_child(), the same on all peers.", node.get_path());
}

/// The node below which the synchronizer's targets are.
static const Node *find_root(const Node &synchronizer) {
	const Ref<SceneMultiplayer> api = synchronizer.is_part_of_edited_scene() ? Ref<SceneMultiplayer>() : Ref<SceneMultiplayer>(synchronizer.get_multiplayer());
	const Node *root = api.is_valid() ? synchronizer.get_node_or_null(api->get_root_path()) : nullptr;
	return root != nullptr ? root : find_top(synchronizer);
}

/// True if the names that identify the node on all peers, those below `root`, include an automatic one.
static bool has_automatic_name(const Node *root, const Node *node) {
	for (const Node *named = node; named != nullptr && named != root; named = named->get_parent()) {
		if (String(named->get_name()).contains("@")) {
			return true;
		}
	}
	return false;
}

String thread_fault(const Node &node) {
	const Node *group = find_sub_thread_group(&node);
	return group == nullptr ? String() : vformat("%s runs in a sub-thread, where the engine refuses multiplayer calls such as is_multiplayer_authority(). Set process_thread_group of %s to Main Thread.", node.get_name(), group->get_name());
}

String dimension_fault(const Node &node) {
	const Node *parent = node.get_parent();
	if (!is_spatial(parent) || is_node_2d(parent) == is_node_2d(&node)) {
		return String();
	}
	return vformat("%s is a %s below %s, a %s, which does not move it. Give it a parent of its own kind, or a Node.", node.get_name(), is_node_2d(&node) ? "Node2D" : "Node3D", parent->get_name(), is_node_2d(parent) ? "Node2D" : "Node3D");
}

String send_rate_fault(double send_rate) {
	const int64_t ticks = Engine::get_singleton()->get_physics_ticks_per_second();
	if (send_rate <= double(ticks)) {
		return String();
	}
	return vformat("send_rate is %s Hz, but there are only %d physics ticks per second, and motion is sent at most once per tick. Reduce send_rate or raise Engine.physics_ticks_per_second.", String::num(send_rate, 3), ticks);
}

String tick_rate_fault(double max_latency) {
	const int64_t ticks = Engine::get_singleton()->get_physics_ticks_per_second();
	if (!net::TICK_RATE_RANGE.contains(double(ticks))) {
		return vformat("Engine.physics_ticks_per_second is %d, but motion is replicated with at most %s ticks per second.", ticks, short_number(net::TICK_RATE_RANGE.max));
	}
	const double limit = net::MAX_LATENCY_TICKS / double(ticks);
	return max_latency <= limit ? String() : vformat("max_latency is %s, but at %d physics ticks per second must be at most %s seconds, which is used.", short_number(max_latency), ticks, short_number(limit));
}

static void add_fault(PackedStringArray &faults, const String &fault) {
	if (!fault.is_empty()) {
		faults.push_back(fault);
	}
}

static void find_target_faults(const Node &synchronizer, const Node *root, const std::vector<uint64_t> &nodes, PackedStringArray &faults) {
	const std::vector<ReplicatedPose> poses = find_replicated_poses(find_top(synchronizer));
	const TypedArray<Node> others = synchronizer.get_tree()->get_nodes_in_group(SYNCHRONIZER_GROUP);
	const int64_t max_faults = faults.size() + MAX_TARGET_FAULTS;
	for (const uint64_t id : nodes) {
		const Node *node = find_spatial(id);
		if (node == nullptr || !node->is_inside_tree() || !synchronizer.is_inside_tree()) {
			continue; // The property `freeze` of an earlier node ran a script, which has removed it.
		}
		if (faults.size() >= max_faults) {
			faults.push_back("Other targets have similar faults.");
			return;
		}
		if (has_automatic_name(root, node)) {
			faults.push_back(automatic_name_fault(*node));
		}
		add_fault(faults, thread_fault(*node));
		add_fault(faults, dimension_fault(*node));
		for (int64_t i = 0; i < others.size(); i++) {
			const MotorSynchronizer *other = Object::cast_to<MotorSynchronizer>(others[i].get_validated_object());
			if (other != nullptr && other != &synchronizer && other->get_multiplayer() == synchronizer.get_multiplayer() && other->selects(node)) {
				faults.push_back(vformat("%s is also a target of %s. Remove it from one of the two.", node->get_name(), other->get_name()));
			}
		}
		for (const ReplicatedPose &pose : poses) {
			if (pose.node == id) {
				faults.push_back(vformat("The MultiplayerSynchronizer %s also replicates %s of %s. Remove the property there.", pose.synchronizer, pose.property, node->get_name()));
			}
		}
		if (node->is_class("RigidBody3D") || node->is_class("RigidBody2D")) {
			const String fault = vformat("%s is a %s that every peer would simulate. Set freeze, with freeze_mode Kinematic, and unfreeze it only where is_multiplayer_authority() is true.", node->get_name(), node->get_class());
			if (!bool(node->get("freeze"))) {
				faults.push_back(fault);
			}
		}
	}
}

PackedStringArray find_setup_faults(const MotorSynchronizer &synchronizer, const TargetSelection &selection) {
	PackedStringArray faults;
	if (selection.is_empty()) {
		faults.push_back("Nothing is replicated. Assign \"targets\", set \"target_group\", or call add_target() from a script.");
	}
	add_fault(faults, thread_fault(synchronizer));
	add_fault(faults, send_rate_fault(synchronizer.get_send_rate()));
	add_fault(faults, tick_rate_fault(synchronizer.get_max_latency()));
	const Node *root = find_root(synchronizer);
	std::vector<uint64_t> nodes;
	const TypedArray<NodePath> &paths = selection.paths();
	for (int64_t i = 0; i < paths.size(); i++) {
		const NodePath path = paths[i];
		if (const Node *node = find_spatial(synchronizer, path)) {
			nodes.push_back(node->get_instance_id());
		} else {
			faults.push_back(vformat("targets[%d] (\"%s\") is not the path of a Node3D or Node2D.", i, path));
		}
	}
	const StringName &group = selection.group();
	if (group != StringName()) {
		const size_t before = nodes.size();
		const TypedArray<Node> members = synchronizer.get_tree()->get_nodes_in_group(group);
		for (int64_t i = 0; i < members.size(); i++) {
			Node *node = Object::cast_to<Node>(members[i].get_validated_object());
			// Others may belong to another MultiplayerAPI.
			if (is_spatial(node) && (node == root || root->is_ancestor_of(node))) {
				nodes.push_back(node->get_instance_id());
			}
		}
		if (nodes.size() == before) {
			faults.push_back(vformat("No Node3D or Node2D of this scene is in the group \"%s\". This is correct only if all of its members are spawned later.", group));
		}
	}
	for (const uint64_t id : selection.added()) {
		const Node *node = find_spatial(id);
		if (node != nullptr && node->is_inside_tree()) {
			nodes.push_back(id);
		}
	}
	find_target_faults(synchronizer, root, nodes, faults);
	return faults;
}

} // namespace ga_godot
