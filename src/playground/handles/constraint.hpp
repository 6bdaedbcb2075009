#pragma once

#include "playground/handles/view_ray.hpp"

#include <optional>

// Where something can be dragged to.

namespace playground::handles {

enum class Motion {
	FREE, // in the plane through it across the view
	LINE, // along `axis`
	CIRCLE, // about `center`, across `axis`
	SPHERE, // about `center`
};

struct Constraint {
	Motion motion = Motion::FREE;
	Vector place{ 0.0 };
	Vector center{ 0.0 };
	Vector axis{ 0.0 }; // unit, where the motion has one
};

// Beyond this distance from the origin, in metres, nothing is dragged: near a vanishing point a pixel is any distance.
inline constexpr double FARTHEST = 1e9;

// The place that lies on the ray, in front of the eye, or if none does, that is nearest to it. Of a sphere that the ray
// meets twice the place on the side on which it is now. Empty where that is no place, or any: with a ray along the line or
// the plane, a circle or sphere without radius, behind the eye, beyond FARTHEST, not finite.
[[nodiscard]] std::optional<Vector> place_under(const ViewRay &ray, const Constraint &constraint);

} // namespace playground::handles
