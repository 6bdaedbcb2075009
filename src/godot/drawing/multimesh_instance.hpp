#pragma once

#include "playground/drawing/figure.hpp"

#include <godot_cpp/variant/color.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <cstddef>

namespace ga_godot {

/// Data of one instance of a MultiMesh, in world space.
struct InstanceData {
	godot::Transform3D transform;
	playground::drawing::Box bounds;
	godot::Color color;
	godot::Color custom; ///< INSTANCE_CUSTOM, see playground/drawing/shader.hpp
};

/// Owns a MultiMesh with colors and custom data and its instance in a scenario, both on the rendering server.
class MultiMeshInstance {
public:
	MultiMeshInstance(const godot::RID &mesh, const godot::RID &scenario);
	~MultiMeshInstance();
	MultiMeshInstance(const MultiMeshInstance &) = delete;
	MultiMeshInstance &operator=(const MultiMeshInstance &) = delete;

	/// Discards all instance data.
	void allocate(size_t count);
	void set_visible_count(size_t count);
	/// Writes only what differs from the previous data of the slot, if given.
	void write(size_t slot, const InstanceData &data, const InstanceData *previous = nullptr);
	void set_bounds(const playground::drawing::Box &bounds);

private:
	godot::RID _multimesh;
	godot::RID _instance;
};

} // namespace ga_godot
