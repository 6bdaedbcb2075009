#pragma once

#include "playground/drawing/figure.hpp"

#include <optional>

// Picking: the distance on the screen from the mouse to a figure.

namespace playground::drawing {

// A view ray through a pixel, in the space of the figure. The size of a pixel is pixel_at_origin + pixel_per_meter * depth.
struct PickRay {
	Vector origin;
	Vector direction; // unit
	double pixel_at_origin = 0.0; // meters; of an orthogonal view
	double pixel_per_meter = 0.0; // of a perspective view

	[[nodiscard]] double pixel(double depth) const { return pixel_at_origin + pixel_per_meter * depth; }
};

struct PickHit {
	double pixels; // distance from the ray on the screen; 0 on a surface
	double depth; // meters along the ray
	bool on_surface; // lines and points within a few pixels take precedence
};

// The part of the figure nearest on the screen; empty if the figure is behind the eye.
[[nodiscard]] std::optional<PickHit> pick(const Figure &figure, const PickRay &ray);

} // namespace playground::drawing
