#pragma once

#include "playground/drawing/form.hpp"
#include "playground/drawing/shader.hpp"

#include <godot_cpp/variant/rid.hpp>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace ga_godot {

/// The meshes, materials and shaders that all GANode3D share: one of each, made when first asked for, on the
/// rendering server. Main thread only.
///
/// They go with the last node that was drawn, not with the library: an engine that ends while the mobile renderer still
/// compiles shaders that nobody has freed waits for that forever.
class FormMeshes {
public:
	FormMeshes();
	~FormMeshes();
	FormMeshes(const FormMeshes &) = delete;
	FormMeshes &operator=(const FormMeshes &) = delete;

	/// Those there are, or new ones.
	static std::shared_ptr<FormMeshes> shared();

	/// The lines and signs of a form.
	godot::RID strokes_of(playground::drawing::Form p_form);
	/// Its surface, invalid if it has none.
	godot::RID fill_of(playground::drawing::Form p_form);
	/// A new mesh with an object's own strokes, in metres; the caller frees it.
	godot::RID make_mesh(const playground::drawing::Strokes &p_strokes);

private:
	static constexpr int SPACES = 5;

	godot::RID stroke_material(playground::drawing::Space p_space);
	godot::RID fill_material(playground::drawing::Space p_space);
	godot::RID make_material(const std::string &p_code, int p_priority);
	void make_form(playground::drawing::Form p_form);
	godot::RID make_strokes(const playground::drawing::Strokes &p_strokes, playground::drawing::Space p_space);
	godot::RID make_fill(const playground::drawing::Fill &p_fill, playground::drawing::Space p_space);

	playground::drawing::Renderer _renderer = playground::drawing::Renderer::compatibility;
	std::array<godot::RID, playground::drawing::SHARED_FORM_COUNT> _strokes;
	std::array<godot::RID, playground::drawing::SHARED_FORM_COUNT> _fills;
	std::array<godot::RID, SPACES> _stroke_materials;
	std::array<godot::RID, SPACES> _fringe_materials;
	std::array<godot::RID, SPACES> _fill_materials;
	std::vector<godot::RID> _shaders;
};

} // namespace ga_godot
