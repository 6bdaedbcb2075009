#include "godot/drawing/drawn_part.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

namespace ga_godot {

using playground::drawing::Form;

DrawnPart::DrawnPart(FormMeshes &p_meshes, Form p_form, const playground::drawing::Strokes &p_own, const godot::RID &p_scenario) :
		_meshes(p_meshes), _form(p_form), _scenario(p_scenario) {
	if (p_form == Form::own) {
		_own_mesh = _meshes.make_mesh(p_own);
	}
	const godot::RID mesh = p_form == Form::own ? _own_mesh : _meshes.fill_of(p_form);
	if (mesh.is_valid()) {
		_alone = std::make_unique<MultiMeshInstance>(mesh, p_scenario);
		_alone->allocate(1);
	}
}

DrawnPart::~DrawnPart() {
	if (_batch) {
		_batch->remove(_number);
	}
	_alone.reset();
	if (_own_mesh.is_valid()) {
		godot::RenderingServer::get_singleton()->free_rid(_own_mesh);
	}
}

void DrawnPart::write(const InstanceLook &p_look) {
	if (_alone) {
		_alone->write(0, p_look);
		_alone->set_bounds(p_look.bounds);
	}
	if (_batch) {
		_batch->change(_number, p_look);
	} else if (_form != Form::own) {
		_batch = &StrokeBatch::of(_form, _meshes.strokes_of(_form), _scenario);
		_number = _batch->add(p_look);
	}
}

} // namespace ga_godot
