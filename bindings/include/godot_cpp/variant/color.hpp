#pragma once

namespace godot {

struct Color {
	float r = 0;
	float g = 0;
	float b = 0;
	float a = 1;

	Color() = default;
	Color(float p_r, float p_g, float p_b, float p_a = 1) :
			r(p_r), g(p_g), b(p_b), a(p_a) {}

	bool operator==(const Color &p_other) const { return r == p_other.r && g == p_other.g && b == p_other.b && a == p_other.a; }
	bool operator!=(const Color &p_other) const { return !(*this == p_other); }
};

} // namespace godot
