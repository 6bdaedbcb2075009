#include "godot/drawing/drawn_part.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

namespace ga_godot {

using playground::drawing::Form;

DrawnPart::DrawnPart(FormMeshes &meshes, Form form, const playground::drawing::Strokes &custom, const godot::RID &scenario) :
		_meshes(meshes), _form(form), _scenario(scenario) {
	if (form == Form::CUSTOM) {
		_custom_mesh = _meshes.make_mesh(custom);
	}
	const godot::RID mesh = form == Form::CUSTOM ? _custom_mesh : _meshes.fill_of(form);
	if (mesh.is_valid()) {
		_single = std::make_unique<MultiMeshInstance>(mesh, scenario);
		_single->allocate(1);
	}
}

DrawnPart::~DrawnPart() {
	if (_batch) {
		_batch->remove(_batch_id);
	}
	_single.reset();
	if (_custom_mesh.is_valid()) {
		godot::RenderingServer::get_singleton()->free_rid(_custom_mesh);
	}
}

void DrawnPart::write(const InstanceData &data) {
	if (_single) {
		_single->write(0, data);
		_single->set_bounds(data.bounds);
	}
	if (_batch) {
		_batch->change(_batch_id, data);
	} else if (_form != Form::CUSTOM) {
		_batch = &StrokeBatch::of(_form, _meshes.strokes_of(_form), _scenario);
		_batch_id = _batch->add(data);
	}
}

} // namespace ga_godot
