#pragma once

#include "playground/handles/view_ray.hpp"

#include <optional>

// The positions that a handle can be dragged to.

namespace playground::handles {

enum class Motion {
	FREE, // the plane through the handle, perpendicular to ViewRay::view
	LINE, // the line through the handle along `axis`
	CIRCLE, // the circle through the handle around `center`, perpendicular to `axis`
	SPHERE, // the sphere through the handle around `center`
};

struct Constraint {
	Motion motion = Motion::FREE;
	Vector position{ 0.0 }; // of the handle, meters
	Vector center{ 0.0 };
	Vector axis{ 0.0 }; // unit vector, for LINE and CIRCLE
};

// Handles cannot be dragged farther than this from the origin, in meters: near a vanishing point a pixel spans any
// distance.
inline constexpr double MAX_DISTANCE = 1e9;

// The allowed position closest to the ray, in front of the eye. If the ray meets a sphere twice, the position on the same
// side as the current one. Empty if no such position exists or it is not unique: for a ray along the line or plane, a circle
// or sphere of radius zero, and positions behind the eye, beyond MAX_DISTANCE or not finite.
[[nodiscard]] std::optional<Vector> position_on(const ViewRay &ray, const Constraint &constraint);

} // namespace playground::handles
