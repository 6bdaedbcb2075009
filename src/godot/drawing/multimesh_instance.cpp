#include "godot/drawing/multimesh_instance.hpp"

#include "godot/algebra/conversions.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

namespace ga_godot {

using godot::RenderingServer;
using playground::drawing::Box;

MultiMeshInstance::MultiMeshInstance(const godot::RID &mesh, const godot::RID &scenario) {
	RenderingServer *server = RenderingServer::get_singleton();
	_multimesh = server->multimesh_create();
	server->multimesh_set_mesh(_multimesh, mesh);
	_instance = server->instance_create2(_multimesh, scenario);
	server->instance_geometry_set_cast_shadows_setting(_instance, RenderingServer::SHADOW_CASTING_SETTING_OFF);
}

MultiMeshInstance::~MultiMeshInstance() {
	RenderingServer *server = RenderingServer::get_singleton();
	server->free_rid(_instance);
	server->free_rid(_multimesh);
}

void MultiMeshInstance::allocate(size_t count) {
	RenderingServer::get_singleton()->multimesh_allocate_data(_multimesh, int32_t(count), RenderingServer::MULTIMESH_TRANSFORM_3D, true, true);
}

void MultiMeshInstance::set_visible_count(size_t count) {
	RenderingServer::get_singleton()->multimesh_set_visible_instances(_multimesh, int32_t(count));
}

void MultiMeshInstance::write(size_t slot, const InstanceData &data, const InstanceData *previous) {
	RenderingServer *server = RenderingServer::get_singleton();
	const int32_t index = int32_t(slot);
	if (!previous || data.transform != previous->transform) {
		server->multimesh_instance_set_transform(_multimesh, index, data.transform);
	}
	if (!previous || data.color != previous->color) {
		server->multimesh_instance_set_color(_multimesh, index, data.color);
	}
	if (!previous || data.custom != previous->custom) {
		server->multimesh_instance_set_custom_data(_multimesh, index, data.custom);
	}
}

void MultiMeshInstance::set_bounds(const Box &bounds) {
	RenderingServer *server = RenderingServer::get_singleton();
	const godot::AABB box(to_godot(bounds.min), to_godot(bounds.max - bounds.min));
	server->multimesh_set_custom_aabb(_multimesh, box);
	server->instance_set_custom_aabb(_instance, box);
}

} // namespace ga_godot
