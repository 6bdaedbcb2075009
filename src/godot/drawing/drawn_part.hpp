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

/// A visible part of a figure. Its strokes are batched by form (StrokeBatch). Its surface and the strokes of Form::CUSTOM
/// are separate instances, because the engine must sort surfaces from back to front.
class DrawnPart {
public:
	/// `meshes` must outlive it. Nothing is drawn before the first write().
	DrawnPart(FormMeshes &meshes, playground::drawing::Form form, const playground::drawing::Strokes &custom, const godot::RID &scenario);
	~DrawnPart();
	DrawnPart(const DrawnPart &) = delete;
	DrawnPart &operator=(const DrawnPart &) = delete;

	playground::drawing::Form form() const { return _form; }
	void write(const InstanceData &data);

private:
	FormMeshes &_meshes;
	playground::drawing::Form _form;
	godot::RID _scenario;
	StrokeBatch *_batch = nullptr; // null before the first write()
	size_t _batch_id = 0; // in _batch
	godot::RID _custom_mesh;
	std::unique_ptr<MultiMeshInstance> _single; // the surface or the custom strokes
};

} // namespace ga_godot
