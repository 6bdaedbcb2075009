#pragma once

#include "playground/drawing/figure.hpp"

#include <godot_cpp/variant/color.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <cstddef>

namespace ga_godot {

/// How one instance of a MultiMesh is drawn, in the space of the world.
struct InstanceLook {
	godot::Transform3D place;
	playground::drawing::Box bounds;
	godot::Color color;
	godot::Color style; ///< INSTANCE_CUSTOM, see playground/drawing/shader.hpp
};

/// A MultiMesh with colours and custom data, and its instance in a world: what StrokeBatch and a part that
/// is drawn alone keep on the rendering server. Frees both when it goes.
class MultiMeshInstance {
public:
	MultiMeshInstance(const godot::RID &p_mesh, const godot::RID &p_scenario);
	~MultiMeshInstance();
	MultiMeshInstance(const MultiMeshInstance &) = delete;
	MultiMeshInstance &operator=(const MultiMeshInstance &) = delete;

	/// Room for that many; what was written is lost.
	void allocate(size_t p_count);
	void draw_first(size_t p_count);
	void write(size_t p_index, const InstanceLook &p_look);
	/// Only what is another than before.
	void write_changes(size_t p_index, const InstanceLook &p_before, const InstanceLook &p_look);
	void set_bounds(const playground::drawing::Box &p_bounds);

private:
	godot::RID _multimesh;
	godot::RID _instance;
};

} // namespace ga_godot
