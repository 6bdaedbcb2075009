#pragma once

#include "../paper_method.hpp"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <vector>

namespace bench {

/// Moves each node between two poses by one of the methods to compare with. One call moves all nodes, which saves these
/// methods the cost of a script or component per object.
class NativeBlend : public godot::RefCounted {
	GDCLASS(NativeBlend, godot::RefCounted)

public:
	void setup(const godot::TypedArray<godot::Node3D> &nodes, const godot::TypedArray<godot::Transform3D> &from, const godot::TypedArray<godot::Transform3D> &to);
	/// The method of the GA-Unity paper with its pool of multivectors.
	void blend_paper_pooled(double weight);
	/// The method of the GA-Unity paper with a new multivector for each operation.
	void blend_paper_allocating(double weight);
	/// GLM: position and scale by lerp, rotation by slerp.
	void blend_glm_slerp(double weight);
	/// The cost of setting transforms alone: sets the first pose again.
	void set_only(double weight);

protected:
	static void _bind_methods();

private:
	template <class Blend>
	void move_all(Blend blend);

	std::vector<godot::Node3D *> _nodes;
	std::vector<godot::Transform3D> _transforms;
	std::vector<cga::Pose<float>> _from;
	std::vector<cga::Pose<float>> _to;
	std::vector<paper::Ends> _ends;
	paper::Pool _pool;
	paper::Allocating _allocating;
};

} // namespace bench
