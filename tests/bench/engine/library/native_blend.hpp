#pragma once

#include "../paper_method.hpp"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <vector>

namespace bench {

/// Moves each node between two poses, in C++, by one of the compared methods: one call a frame for all nodes, without the cost
/// of a script or component for each object.
class NativeBlend : public godot::RefCounted {
	GDCLASS(NativeBlend, godot::RefCounted)

public:
	void setup(const godot::TypedArray<godot::Node3D> &p_nodes, const godot::TypedArray<godot::Transform3D> &p_from, const godot::TypedArray<godot::Transform3D> &p_to);
	/// The paper's method with its pool of multivectors.
	void blend_paper_pooled(double p_weight);
	/// The paper's method with a new multivector for every operation.
	void blend_paper_allocating(double p_weight);
	/// Lerp of position and scale, slerp of rotation, with GLM.
	void blend_glm_slerp(double p_weight);
	/// No blend: sets the first pose again, to measure the cost of setting transforms.
	void set_only(double p_weight);

protected:
	static void _bind_methods();

private:
	template <class Blend>
	void move_all(Blend p_blend);

	std::vector<godot::Node3D *> _nodes;
	std::vector<godot::Transform3D> _transforms;
	std::vector<cga::Pose<float>> _from;
	std::vector<cga::Pose<float>> _to;
	std::vector<paper::Ends> _ends;
	paper::Pool _pool;
	paper::Allocating _allocating;
};

} // namespace bench
