#pragma once

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include "cga/motor/pose.hpp"

#include <cstdint>
#include <optional>

namespace ga_godot {

/// The node with an instance id; null if it has been freed or is not a Node3D.
[[nodiscard]] godot::Node3D *find_node(uint64_t id);

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
	/// True if the node is where it was at the last `read_pose`.
	[[nodiscard]] bool is_unchanged(const godot::Transform3D &transform) const { return _is_sampled && transform == _transform; }
	/// The pose of a transform. Reports a transform that has none, or a scale that is not uniform, the first time.
	[[nodiscard]] std::optional<cga::Pose<double>> read_pose(const godot::Transform3D &transform, const godot::String &synchronizer);
	/// Reports, the first time, that the pose is out of range for a stream.
	void report_out_of_range(const godot::String &synchronizer);

	/// Moves the node as its stream says.
	void place(const godot::Transform3D &transform, bool is_physics_interpolated);
	/// The stream stops moving the node.
	void release();

private:
	void report(const godot::String &synchronizer, const char *fault);

	godot::Transform3D _transform; // of the last sample
	bool _is_sampled = false;
	bool _is_faulty = false; // reported: the transform is not a pose
	bool _is_non_uniform = false; // reported: the scale
	int32_t _own_interpolation = -1; // physics_interpolation_mode before the stream moved the node
};

} // namespace ga_godot
