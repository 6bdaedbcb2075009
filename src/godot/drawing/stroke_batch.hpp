#pragma once

#include "godot/drawing/multimesh_instance.hpp"
#include "playground/drawing/form.hpp"
#include "playground/drawing/instance_slots.hpp"

#include <godot_cpp/variant/rid.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace ga_godot {

/// The strokes of all objects of one form in one world: a single MultiMesh, so that a thousand circles are as many draw
/// calls as one. They need no order among each other (StrokePass); surfaces do, and are drawn one by one.
///
/// There is a batch while something is in it. Main thread only.
class StrokeBatch {
public:
	StrokeBatch(playground::drawing::Form p_form, const godot::RID &p_mesh, const godot::RID &p_scenario);

	/// That of a form in a world, or one made now with the form's mesh.
	static StrokeBatch &of(playground::drawing::Form p_form, const godot::RID &p_mesh, const godot::RID &p_scenario);

	/// The number by which to change and to remove it.
	size_t add(const InstanceLook &p_look);
	void change(size_t p_owner, const InstanceLook &p_look);
	/// The batch is gone after the last one.
	void remove(size_t p_owner);

private:
	void make_room();
	void include(const playground::drawing::Box &p_bounds);

	playground::drawing::Form _form;
	godot::RID _scenario;
	MultiMeshInstance _drawn;
	playground::drawing::InstanceSlots _slots;
	std::vector<InstanceLook> _looks; // by slot
	size_t _room = 0;
	playground::drawing::Box _bounds;
};

} // namespace ga_godot
