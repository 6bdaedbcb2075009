#pragma once

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include "cga/motor/pose.hpp"

#include <cstdint>
#include <optional>

namespace ga_godot {

/// The node with an instance id; null if it has been freed or is not a Node3D.
[[nodiscard]] godot::Node3D *find_node(uint64_t id);
/// The node at a path; null if there is none or it is not a Node3D.
[[nodiscard]] godot::Node3D *find_node(const godot::Node &from, const godot::NodePath &path);

/// A node that a MotorSynchronizer replicates and that is in the tree.
class Target {
public:
	Target(uint64_t node, uint32_t body) :
			node(node), body(body) {}

	uint64_t node; ///< instance id
	uint32_t body; ///< the same on all peers
	int32_t authority = 0; ///< 0 until the first tick

	/// Forgets the last transform, so that the next one counts as changed.
	void forget_transform() { _is_sampled = false; }
	/// True if the transform is that of the last `read_pose`.
	[[nodiscard]] bool is_unchanged(const godot::Transform3D &transform) const { return _is_sampled && transform == _transform; }
	/// The pose of a transform of the node. Prints an error if it has no pose, and a warning if the scale is non-uniform;
	/// each once.
	[[nodiscard]] std::optional<cga::Pose<double>> read_pose(const godot::Transform3D &transform, const godot::String &synchronizer);
	/// Prints once that the pose is out of range for a stream.
	void report_out_of_range(const godot::String &synchronizer);
	/// Call when the stream accepts a pose, so that the next error is printed again.
	void clear_fault() { _is_faulty = false; }

	/// Sets the node's transform to the one shown by its stream.
	void place(const godot::Transform3D &transform, bool is_physics_interpolated);
	/// Restores the node's physics interpolation mode, which `place` may have changed.
	void release();

private:
	void report(const godot::String &synchronizer, const char *fault);

	godot::Transform3D _transform; // of the last sample
	bool _is_sampled = false;
	bool _is_faulty = false; // an error of the transform has been printed
	bool _is_non_uniform = false; // the warning about a non-uniform scale has been printed
	int32_t _own_interpolation = -1; // physics_interpolation_mode before the stream moved the node
};

} // namespace ga_godot
