#pragma once

#include "godot/drawing/multimesh_instance.hpp"
#include "playground/drawing/form.hpp"
#include "playground/drawing/instance_slots.hpp"

#include <godot_cpp/variant/rid.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace ga_godot {

/// A MultiMesh with the strokes of all objects of one form in one scenario, so that a thousand circles take as many
/// draw calls as one. Strokes need no sorting (StrokePass); surfaces do, and are drawn one by one.
///
/// A batch exists while it has members. Main thread only.
class StrokeBatch {
public:
	StrokeBatch(playground::drawing::Form form, const godot::RID &mesh, const godot::RID &scenario);

	/// The batch of a form in a scenario, created with the form's mesh if it does not exist.
	static StrokeBatch &of(playground::drawing::Form form, const godot::RID &mesh, const godot::RID &scenario);

	/// Returns the ID that change() and remove() take.
	size_t add(const InstanceData &data);
	void change(size_t id, const InstanceData &data);
	/// Deletes the batch with its last member.
	void remove(size_t id);

private:
	void grow();
	void include(const playground::drawing::Box &bounds);

	playground::drawing::Form _form;
	godot::RID _scenario;
	MultiMeshInstance _multimesh;
	playground::drawing::InstanceSlots _slots;
	std::vector<InstanceData> _instances; // by slot
	size_t _capacity = 0; // instances
	playground::drawing::Box _bounds;
};

} // namespace ga_godot
