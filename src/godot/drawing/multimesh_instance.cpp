#include "godot/drawing/multimesh_instance.hpp"

#include "godot/algebra/conversions.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

namespace ga_godot {

using godot::RenderingServer;
using playground::drawing::Box;

MultiMeshInstance::MultiMeshInstance(const godot::RID &p_mesh, const godot::RID &p_scenario) {
	RenderingServer *server = RenderingServer::get_singleton();
	_multimesh = server->multimesh_create();
	server->multimesh_set_mesh(_multimesh, p_mesh);
	_instance = server->instance_create2(_multimesh, p_scenario);
	server->instance_geometry_set_cast_shadows_setting(_instance, RenderingServer::SHADOW_CASTING_SETTING_OFF);
}

MultiMeshInstance::~MultiMeshInstance() {
	RenderingServer *server = RenderingServer::get_singleton();
	server->free_rid(_instance);
	server->free_rid(_multimesh);
}

void MultiMeshInstance::allocate(size_t p_count) {
	RenderingServer::get_singleton()->multimesh_allocate_data(_multimesh, int32_t(p_count), RenderingServer::MULTIMESH_TRANSFORM_3D, true, true);
}

void MultiMeshInstance::draw_first(size_t p_count) {
	RenderingServer::get_singleton()->multimesh_set_visible_instances(_multimesh, int32_t(p_count));
}

void MultiMeshInstance::write(size_t p_index, const InstanceLook &p_look) {
	RenderingServer *server = RenderingServer::get_singleton();
	const int32_t index = int32_t(p_index);
	server->multimesh_instance_set_transform(_multimesh, index, p_look.place);
	server->multimesh_instance_set_color(_multimesh, index, p_look.color);
	server->multimesh_instance_set_custom_data(_multimesh, index, p_look.style);
}

void MultiMeshInstance::write_changes(size_t p_index, const InstanceLook &p_before, const InstanceLook &p_look) {
	RenderingServer *server = RenderingServer::get_singleton();
	const int32_t index = int32_t(p_index);
	if (p_look.place != p_before.place) {
		server->multimesh_instance_set_transform(_multimesh, index, p_look.place);
	}
	if (p_look.color != p_before.color) {
		server->multimesh_instance_set_color(_multimesh, index, p_look.color);
	}
	if (p_look.style != p_before.style) {
		server->multimesh_instance_set_custom_data(_multimesh, index, p_look.style);
	}
}

void MultiMeshInstance::set_bounds(const Box &p_bounds) {
	RenderingServer *server = RenderingServer::get_singleton();
	const godot::AABB box(to_godot(p_bounds.least), to_godot(p_bounds.greatest - p_bounds.least));
	server->multimesh_set_custom_aabb(_multimesh, box);
	server->instance_set_custom_aabb(_instance, box);
}

} // namespace ga_godot
