#pragma once

#include "playground/drawing/figure.hpp"

#include <optional>

// What is under the mouse.

namespace playground::drawing {

// A ray of view through a pixel, in the space of the figure; a pixel is pixel_at_origin + pixel_per_metre * depth wide.
struct PickRay {
	Vector origin;
	Vector direction; // unit
	double pixel_at_origin = 0.0; // metres; of a parallel view
	double pixel_per_metre = 0.0; // of a perspective view

	[[nodiscard]] double pixel(double depth) const { return pixel_at_origin + pixel_per_metre * depth; }
};

struct Touch {
	double pixels; // from the ray to what is drawn, on the screen; 0 on a surface
	double depth; // metres along the ray
	bool on_surface; // inside a plane's or a sphere's face: what is a line or a point there goes before it
};

// The nearest of the figure on the screen; empty where all of it is behind the eye.
[[nodiscard]] std::optional<Touch> touch(const Figure &figure, const PickRay &ray);

} // namespace playground::drawing
