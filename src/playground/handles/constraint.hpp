#pragma once

#include "playground/handles/view_ray.hpp"

#include <optional>

// The positions that a handle can be dragged to.

namespace playground::handles {

enum class Motion {
	FREE, // in the plane through it perpendicular to the view
	LINE, // the line through it along `axis`
	CIRCLE, // around `center`, perpendicular to `axis`
	SPHERE, // around `center`
};

struct Constraint {
	Motion motion = Motion::FREE;
	Vector position{ 0.0 }; // of the handle, meters
	Vector center{ 0.0 };
	Vector axis{ 0.0 }; // unit vector, for LINE and CIRCLE
};

// Handles are not dragged beyond this distance from the origin, in meters: near a vanishing point a pixel spans any
// distance.
inline constexpr double MAX_DISTANCE = 1e9;

// The allowed position closest to the ray, in front of the eye. Where the ray meets a sphere twice, the position on the same
// side as the current one. Empty if no such position exists or it is not unique: for a ray along the line or plane, a circle
// or sphere of radius zero, and positions behind the eye, beyond MAX_DISTANCE or not finite.
[[nodiscard]] std::optional<Vector> position_on(const ViewRay &ray, const Constraint &constraint);

} // namespace playground::handles
