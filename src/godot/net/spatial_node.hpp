#pragma once

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <cstdint>

namespace ga_godot {

// Node3D and Node2D in one form. The transform of a Node2D is one in the plane z = 0, in pixels; its skew is ignored.

[[nodiscard]] bool is_node_2d(const godot::Node *node);
[[nodiscard]] bool is_spatial(const godot::Node *node);

/// The Node3D or Node2D with an instance id that is known to be one; null if it has been freed.
[[nodiscard]] godot::Node *find_known_spatial(uint64_t id);
/// The node with an instance id; null if it has been freed, or is neither a Node3D nor a Node2D.
[[nodiscard]] godot::Node *find_spatial(uint64_t id);
/// The Node3D or Node2D at a path from a node; null if there is none.
[[nodiscard]] godot::Node *find_spatial(const godot::Node &from, const godot::NodePath &path);

[[nodiscard]] godot::Transform3D local_transform(const godot::Node *node);
/// The same for a node of known class, which is faster.
[[nodiscard]] godot::Transform3D local_transform(const godot::Node *node, bool is_2d);
/// Does nothing for null. The node's callbacks may free it.
void set_local_transform(godot::Node *node, const godot::Transform3D &transform);
/// The identity for a node without a transform, and for null.
[[nodiscard]] godot::Transform3D global_transform(const godot::Node *node);

[[nodiscard]] bool is_shown(const godot::Node *node);
/// Does nothing for null. The node's callbacks may free it.
void set_shown(godot::Node *node, bool shown);

/// True for bodies that the physics engine moves, in ticks: a RigidBody3D that is not frozen, and similar.
[[nodiscard]] bool is_moved_by_physics(const godot::Node *node);

} // namespace ga_godot
