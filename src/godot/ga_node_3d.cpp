#include "godot/ga_node_3d.hpp"

#include "godot/conversions.hpp"
#include "godot/form_meshes.hpp"

#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/aabb.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>

// How a GANode3D follows its value, and what it keeps on the rendering server.

namespace ga_godot {

using godot::RenderingServer;
using godot::RID;
using godot::Transform3D;
using playground::drawing::Form;
using playground::drawing::Part;

GANode3D::GANode3D() {
	set_notify_transform(true);
}

GANode3D::~GANode3D() {
	free_parts();
}

void GANode3D::_notification(int p_what) {
	switch (p_what) {
		case NOTIFICATION_ENTER_WORLD:
			_in_world = true;
			_stale = true;
			update_drawing();
			break;
		case NOTIFICATION_EXIT_WORLD:
			_in_world = false;
			free_parts();
			break;
		case NOTIFICATION_TRANSFORM_CHANGED:
			place_parts();
			break;
		case NOTIFICATION_VISIBILITY_CHANGED:
			show_parts();
			break;
		default:
			break;
	}
}

// Many changes in one frame are drawn once.
void GANode3D::queue_update() {
	_stale = true;
	if (_in_world && !_queued) {
		_queued = true;
		call_deferred("update_drawing");
	}
}

void GANode3D::value_changed() {
	queue_update();
}

// Comes after each change of the scene; most are none of this entry's.
void GANode3D::scene_changed() {
	const EntryLook look = get_entry_look();
	const godot::Color color = look.has_color ? look.color : _color;
	if (look.visible != _figure_visible || (look.ipns || _ipns) != _figure_ipns || color != _drawn_color) {
		queue_update();
	}
}

void GANode3D::entries_changed(const godot::PackedStringArray &p_names) {
	if (p_names.has(godot::String(_entry))) {
		queue_update();
	}
}

void GANode3D::update_drawing() {
	_queued = false;
	if (!_stale) {
		return;
	}
	_stale = false;
	const EntryLook look = get_entry_look();
	_figure_visible = look.visible;
	_figure_ipns = _ipns || look.ipns;
	_drawn_color = look.has_color ? look.color : _color;
	const godot::Ref<Multivector> value = look.visible ? get_value() : godot::Ref<Multivector>();
	_figure = value.is_valid() ? playground::drawing::figure_of(value->get_value(), _figure_ipns) : playground::drawing::Figure();
	if (_in_world) {
		draw_parts();
		update_label();
	}
}

// Instances stay where the new value has the same forms as the old one, which it has while something is dragged.
void GANode3D::draw_parts() {
	RenderingServer *server = RenderingServer::get_singleton();
	bool same = _drawn.size() == _figure.parts.size();
	for (size_t i = 0; same && i < _drawn.size(); i++) {
		same = _drawn[i].part.form == _figure.parts[i].form && _figure.parts[i].form != Form::own;
	}
	if (!same) {
		free_parts();
		const RID scenario = get_world_3d()->get_scenario();
		for (const Part &part : _figure.parts) {
			Drawn drawn;
			drawn.part = part;
			drawn.own_mesh = part.form == Form::own ? FormMeshes::get().make_mesh(_figure.own) : RID();
			drawn.multimesh = server->multimesh_create();
			server->multimesh_allocate_data(drawn.multimesh, 1, RenderingServer::MULTIMESH_TRANSFORM_3D, true, true);
			server->multimesh_set_mesh(drawn.multimesh, part.form == Form::own ? drawn.own_mesh : FormMeshes::get().mesh_of(part.form));
			drawn.instance = server->instance_create2(drawn.multimesh, scenario);
			server->instance_geometry_set_cast_shadows_setting(drawn.instance, RenderingServer::SHADOW_CASTING_SETTING_OFF);
			server->instance_attach_object_instance_id(drawn.instance, get_instance_id());
			_drawn.push_back(drawn);
		}
	}
	for (size_t i = 0; i < _drawn.size(); i++) {
		_drawn[i].part = _figure.parts[i];
		shape_part(_drawn[i]);
	}
	place_parts();
	paint_parts();
	show_parts();
}

void GANode3D::shape_part(const Drawn &p_drawn) const {
	RenderingServer *server = RenderingServer::get_singleton();
	const Part &part = p_drawn.part;
	const playground::drawing::Placement &place = part.placement;
	const double radius = std::abs(part.radius);
	const Transform3D local(godot::Basis(to_godot(place.x * radius), to_godot(place.y * radius), to_godot(place.z * radius)), to_godot(place.origin));
	server->multimesh_instance_set_transform(p_drawn.multimesh, 0, local);
	const playground::drawing::Box box = playground::drawing::placed(playground::drawing::box_of(part, _figure.own), place);
	const godot::AABB bounds(to_godot(box.least), to_godot(box.greatest - box.least));
	server->multimesh_set_custom_aabb(p_drawn.multimesh, bounds);
	server->instance_set_custom_aabb(p_drawn.instance, bounds);
}

void GANode3D::free_parts() {
	RenderingServer *server = _drawn.empty() ? nullptr : RenderingServer::get_singleton();
	for (const Drawn &drawn : _drawn) {
		server->free_rid(drawn.instance);
		server->free_rid(drawn.multimesh);
		if (drawn.own_mesh.is_valid()) {
			server->free_rid(drawn.own_mesh);
		}
	}
	_drawn.clear();
}

void GANode3D::place_parts() {
	if (_drawn.empty()) {
		return;
	}
	const Transform3D global = get_global_transform();
	for (const Drawn &drawn : _drawn) {
		RenderingServer::get_singleton()->instance_set_transform(drawn.instance, global);
	}
}

void GANode3D::paint_parts() {
	for (const Drawn &drawn : _drawn) {
		const bool dashed = _figure.imaginary || drawn.part.dashed;
		const double width = drawn.part.dashed ? 0.6 * _line_width : _line_width;
		const godot::Color style(drawn.part.radius < 0.0 ? -1.0f : 1.0f, dashed ? 1.0f : 0.0f, _figure.dual ? 1.0f : 0.0f, float(width));
		RenderingServer::get_singleton()->multimesh_instance_set_color(drawn.multimesh, 0, _drawn_color);
		RenderingServer::get_singleton()->multimesh_instance_set_custom_data(drawn.multimesh, 0, style);
	}
}

void GANode3D::show_parts() {
	const bool visible = !_drawn.empty() && is_visible_in_tree();
	for (const Drawn &drawn : _drawn) {
		RenderingServer::get_singleton()->instance_set_visible(drawn.instance, visible);
	}
}

} // namespace ga_godot
