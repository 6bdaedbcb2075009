#pragma once

#include <godot_cpp/core/defs.hpp>

namespace godot {

struct Quaternion {
	real_t x = 0;
	real_t y = 0;
	real_t z = 0;
	real_t w = 1;

	Quaternion() = default;
	Quaternion(real_t p_x, real_t p_y, real_t p_z, real_t p_w) :
			x(p_x), y(p_y), z(p_z), w(p_w) {}
};

} // namespace godot
