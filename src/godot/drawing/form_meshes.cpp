#include "godot/drawing/form_meshes.hpp"

#include "godot/algebra/conversions.hpp"

#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <algorithm>

namespace ga_godot {

using godot::Array;
using godot::PackedFloat32Array;
using godot::PackedInt32Array;
using godot::PackedVector3Array;
using godot::RenderingServer;
using godot::RID;
using playground::drawing::Fill;
using playground::drawing::Form;
using playground::drawing::FormMesh;
using playground::drawing::Space;
using playground::drawing::Strokes;
using playground::drawing::StrokeVertex;

// Drawing order of the passes, see StrokePass.
static constexpr int CORE_PRIORITY = -1, FILL_PRIORITY = 0, FRINGE_PRIORITY = 1;

FormMeshes::FormMeshes() {
	const bool opengl = RenderingServer::get_singleton()->get_current_rendering_method() == "gl_compatibility";
	_renderer = opengl ? playground::drawing::Renderer::COMPATIBILITY : playground::drawing::Renderer::RENDERING_DEVICE;
}

FormMeshes::~FormMeshes() {
	RenderingServer *server = RenderingServer::get_singleton();
	const auto free_valid = [&](const auto &rids) {
		for (const RID &rid : rids) {
			if (rid.is_valid()) {
				server->free_rid(rid);
			}
		}
	};
	free_valid(_strokes);
	free_valid(_fills);
	free_valid(_materials);
	free_valid(_shaders);
}

std::shared_ptr<FormMeshes> FormMeshes::shared() {
	static std::weak_ptr<FormMeshes> current;
	std::shared_ptr<FormMeshes> meshes = current.lock();
	if (!meshes) {
		meshes = std::make_shared<FormMeshes>();
		current = meshes;
	}
	return meshes;
}

RID FormMeshes::strokes_of(Form form) {
	make_form(form);
	return _strokes[size_t(form)];
}

RID FormMeshes::fill_of(Form form) {
	make_form(form);
	return _fills[size_t(form)];
}

RID FormMeshes::make_mesh(const Strokes &strokes) {
	return make_strokes(strokes, Space::MODEL);
}

void FormMeshes::make_form(Form form) {
	if (!_strokes[size_t(form)].is_valid()) {
		const FormMesh mesh = playground::drawing::mesh_of(form);
		_strokes[size_t(form)] = make_strokes(mesh.strokes, mesh.space);
		_fills[size_t(form)] = make_fill(mesh.fill, mesh.space);
	}
}

RID FormMeshes::stroke_material(Space space) {
	RID &material = _stroke_materials[size_t(space)];
	if (!material.is_valid()) {
		using playground::drawing::stroke_shader;
		using playground::drawing::StrokePass;
		material = make_material(stroke_shader(space, _renderer, StrokePass::CORE), CORE_PRIORITY);
		const RID fringe = make_material(stroke_shader(space, _renderer, StrokePass::FRINGE), FRINGE_PRIORITY);
		RenderingServer::get_singleton()->material_set_next_pass(material, fringe);
	}
	return material;
}

RID FormMeshes::fill_material(Space space) {
	RID &material = _fill_materials[size_t(space)];
	if (!material.is_valid()) {
		material = make_material(playground::drawing::fill_shader(space, _renderer), FILL_PRIORITY);
	}
	return material;
}

RID FormMeshes::make_material(const std::string &code, int priority) {
	RenderingServer *server = RenderingServer::get_singleton();
	const RID shader = server->shader_create();
	server->shader_set_code(shader, to_godot(code));
	const RID material = server->material_create();
	server->material_set_shader(material, shader);
	server->material_set_render_priority(material, priority);
	_shaders.push_back(shader);
	_materials.push_back(material);
	return material;
}

static PackedInt32Array packed(const std::vector<int32_t> &indices) {
	PackedInt32Array result;
	result.resize(int64_t(indices.size()));
	std::copy(indices.begin(), indices.end(), result.ptrw());
	return result;
}

static godot::Vector3 narrow(const glm::vec3 &vector) {
	return godot::Vector3(vector.x, vector.y, vector.z);
}

RID FormMeshes::make_strokes(const Strokes &strokes, Space space) {
	RenderingServer *server = RenderingServer::get_singleton();
	const RID mesh = server->mesh_create();
	if (strokes.vertices.empty()) {
		return mesh;
	}
	const int64_t count = int64_t(strokes.vertices.size());
	PackedVector3Array positions;
	PackedFloat32Array tangents, offsets, colors; // CUSTOM0, CUSTOM1, CUSTOM2: shader.hpp
	positions.resize(count);
	tangents.resize(4 * count);
	offsets.resize(4 * count);
	colors.resize(4 * count);
	godot::Vector3 *position = positions.ptrw();
	float *tangent = tangents.ptrw();
	float *offset = offsets.ptrw();
	float *color = colors.ptrw();
	for (const StrokeVertex &vertex : strokes.vertices) {
		*position++ = narrow(vertex.position);
		for (const float value : { vertex.tangent.x, vertex.tangent.y, vertex.tangent.z, vertex.arc }) {
			*tangent++ = value;
		}
		for (const float value : { vertex.offset.x, vertex.offset.y, float(vertex.profile), vertex.opacity }) {
			*offset++ = value;
		}
		for (const float value : { vertex.color.r, vertex.color.g, vertex.color.b, vertex.color.a }) {
			*color++ = value;
		}
	}
	Array arrays;
	arrays.resize(RenderingServer::ARRAY_MAX);
	arrays[RenderingServer::ARRAY_VERTEX] = positions;
	arrays[RenderingServer::ARRAY_CUSTOM0] = tangents;
	arrays[RenderingServer::ARRAY_CUSTOM1] = offsets;
	arrays[RenderingServer::ARRAY_CUSTOM2] = colors;
	arrays[RenderingServer::ARRAY_INDEX] = packed(strokes.indices);
	constexpr int64_t FLOATS = RenderingServer::ARRAY_CUSTOM_RGBA_FLOAT;
	const int64_t format = FLOATS << RenderingServer::ARRAY_FORMAT_CUSTOM0_SHIFT | FLOATS << RenderingServer::ARRAY_FORMAT_CUSTOM1_SHIFT | FLOATS << RenderingServer::ARRAY_FORMAT_CUSTOM2_SHIFT;
	server->mesh_add_surface_from_arrays(mesh, RenderingServer::PRIMITIVE_TRIANGLES, arrays, Array(), godot::Dictionary(), godot::BitField<RenderingServer::ArrayFormat>(format));
	server->mesh_surface_set_material(mesh, 0, stroke_material(space));
	return mesh;
}

RID FormMeshes::make_fill(const Fill &fill, Space space) {
	if (fill.vertices.empty()) {
		return RID();
	}
	PackedVector3Array positions;
	positions.resize(int64_t(fill.vertices.size()));
	godot::Vector3 *position = positions.ptrw();
	for (const glm::vec3 &vertex : fill.vertices) {
		*position++ = narrow(vertex);
	}
	Array arrays;
	arrays.resize(RenderingServer::ARRAY_MAX);
	arrays[RenderingServer::ARRAY_VERTEX] = positions;
	arrays[RenderingServer::ARRAY_INDEX] = packed(fill.indices);
	RenderingServer *server = RenderingServer::get_singleton();
	const RID mesh = server->mesh_create();
	server->mesh_add_surface_from_arrays(mesh, RenderingServer::PRIMITIVE_TRIANGLES, arrays);
	server->mesh_surface_set_material(mesh, 0, fill_material(space));
	return mesh;
}

} // namespace ga_godot
