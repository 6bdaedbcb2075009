#pragma once

#include "godot/drawing/form_meshes.hpp"
#include "godot/drawing/multimesh_instance.hpp"
#include "godot/drawing/stroke_batch.hpp"
#include "playground/drawing/figure.hpp"

#include <godot_cpp/variant/color.hpp>
#include <godot_cpp/variant/rid.hpp>

#include <cstddef>
#include <memory>

namespace ga_godot {

/// One part of a figure in a world, while it is to be seen: its lines and signs in the batch of their form, its surface
/// alone, since surfaces are drawn from back to front. Strokes that are no shared form are drawn alone, too.
class DrawnPart {
public:
	/// The meshes outlive it. Nothing is seen before write().
	DrawnPart(FormMeshes &p_meshes, playground::drawing::Form p_form, const playground::drawing::Strokes &p_own, const godot::RID &p_scenario);
	~DrawnPart();
	DrawnPart(const DrawnPart &) = delete;
	DrawnPart &operator=(const DrawnPart &) = delete;

	playground::drawing::Form form() const { return _form; }
	void write(const InstanceLook &p_look);

private:
	FormMeshes &_meshes;
	playground::drawing::Form _form;
	godot::RID _scenario;
	StrokeBatch *_batch = nullptr; // once it is in it
	size_t _number = 0; // there
	godot::RID _own_mesh;
	std::unique_ptr<MultiMeshInstance> _alone;
};

} // namespace ga_godot
