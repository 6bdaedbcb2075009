#pragma once

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

// An axis-aligned box: its minimum corner and its size.
struct AABB {
	Vector3 position;
	Vector3 size;

	AABB() = default;
	AABB(const Vector3 &p_position, const Vector3 &p_size) :
			position(p_position), size(p_size) {}
};

} // namespace godot
