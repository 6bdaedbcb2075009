#pragma once

#include "playground/drawing/form.hpp"
#include "playground/drawing/shader.hpp"

#include <godot_cpp/variant/rid.hpp>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace ga_godot {

/// Meshes, materials and shaders on the rendering server, created on demand and shared by all GANode3D. Main thread only.
///
/// Freed with the last node that uses them rather than with the library: the engine hangs at exit if the mobile renderer
/// is still compiling a shader that was not freed.
class FormMeshes {
public:
	FormMeshes();
	~FormMeshes();
	FormMeshes(const FormMeshes &) = delete;
	FormMeshes &operator=(const FormMeshes &) = delete;

	/// Returns the shared instance, or creates it if no node holds one.
	static std::shared_ptr<FormMeshes> shared();

	/// The mesh of a form's lines and markers.
	godot::RID strokes_of(playground::drawing::Form form);
	/// The mesh of a form's surface; an invalid RID if the form has no surface.
	godot::RID fill_of(playground::drawing::Form form);
	/// A new mesh of strokes in meters; the caller frees it.
	godot::RID make_mesh(const playground::drawing::Strokes &strokes);

private:
	static constexpr size_t SPACE_COUNT = 5;

	godot::RID stroke_material(playground::drawing::Space space);
	godot::RID fill_material(playground::drawing::Space space);
	godot::RID make_material(const std::string &code, int priority);
	void make_form(playground::drawing::Form form);
	godot::RID make_strokes(const playground::drawing::Strokes &strokes, playground::drawing::Space space);
	godot::RID make_fill(const playground::drawing::Fill &fill, playground::drawing::Space space);

	playground::drawing::Renderer _renderer = playground::drawing::Renderer::COMPATIBILITY;
	std::array<godot::RID, playground::drawing::SHARED_FORM_COUNT> _strokes;
	std::array<godot::RID, playground::drawing::SHARED_FORM_COUNT> _fills;
	std::array<godot::RID, SPACE_COUNT> _stroke_materials;
	std::array<godot::RID, SPACE_COUNT> _fill_materials;
	std::vector<godot::RID> _materials; // all, including those of the second pass of strokes
	std::vector<godot::RID> _shaders;
};

} // namespace ga_godot
