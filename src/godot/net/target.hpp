#pragma once

#include "net/session/body_view.hpp"
#include "net/session/frame_sampler.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <cstdint>
#include <optional>

namespace ga_godot {

class MotorSynchronizer;

/// A node that a MotorSynchronizer replicates and that is in the tree.
class Target {
public:
	Target(uint64_t node, uint32_t body, MotorSynchronizer *synchronizer, bool is_2d) :
			node(node), body(body), synchronizer(synchronizer), is_2d(is_2d) {}

	uint64_t node; ///< instance id
	uint32_t body; ///< the same on all peers
	MotorSynchronizer *synchronizer;
	bool is_2d;
	int32_t authority = 0; ///< 0 until the first tick
	net::BodyView view; ///< what is shown while another peer has the authority
	uint64_t previous_parent = 0; ///< instance id of the parent in whose space the view's old source is
	bool is_freed = false; ///< free_target was called: the target ends after this tick's pose
	bool is_ended = false; ///< target_ended has been emitted
	bool is_removed = false; ///< it is no target any more: see TargetList

	/// Forgets the last transform, so that the next one counts as changed.
	void forget_transform() { _is_sampled = false; }
	/// True if the node is where it was at the last `read_pose`.
	[[nodiscard]] bool is_unchanged(const godot::Transform3D &transform) const { return _is_sampled && transform == _transform; }
	/// The pose of the node's current transform. Reports, once each, a transform that is not a pose, and a non-uniform scale.
	[[nodiscard]] std::optional<cga::Pose<double>> read_pose(const godot::Transform3D &transform);
	/// Reports once that the pose is out of range for a stream.
	void report_out_of_range();
	/// Call when the stream accepts a pose, so that the next fault is reported again.
	void clear_fault() { _is_faulty = false; }

	/// Records whether the node moved between the last tick and this one's scripts: in a frame.
	void before_scripts(const godot::Transform3D &transform);
	/// Records whether the scripts of this tick moved the node. Returns true if it moves in frames instead.
	bool after_scripts(const godot::Transform3D &transform);
	net::FrameSampler sampler; ///< of a node that moves in frames
	bool is_settled = false; ///< the last pose of `sampler` has been observed

	/// Sets the node's transform to the one shown by its stream.
	void place(const godot::Transform3D &transform, bool is_physics_interpolated);
	/// Begins to blend from where the node is to `transform`, the first of a new source.
	void begin_blend(const godot::Transform3D &from, const godot::Transform3D &transform, double now);
	/// `transform` with the rest of the blend of `duration` seconds.
	[[nodiscard]] godot::Transform3D blended(const godot::Transform3D &transform, double now, double duration) const;
	/// Hides the node until `reveal`.
	void hide();
	void reveal();
	/// Restores what the stream has changed of the node: its visibility, physics interpolation and sync_to_physics.
	void release();

private:
	void report(const char *fault);

	godot::Transform3D _transform; // of the last sample
	godot::Transform3D _early_transform; // before the scripts of this tick
	int32_t _frame_motions = 0; // motions in frames since the last one in a tick, up to the number that counts
	bool _is_sampled = false;
	bool _is_faulty = false; // a fault of the transform has been reported
	bool _is_non_uniform = false; // a non-uniform scale has been reported
	bool _is_hidden = false;
	int32_t _own_interpolation = -1; // physics_interpolation_mode before the stream moved the node
	bool _was_synced_to_physics = false; // sync_to_physics before the stream moved the node
	std::optional<double> _blend_begin;
	cga::Pose<double> _blend_from; // the difference to blend, relative to the new source
};

} // namespace ga_godot
