#pragma once

#include "cga/vector.hpp"

namespace playground::handles {

using Vector = cga::Vector3<double>;

// The ray through a point of the screen, in meters, in the space of the objects.
struct ViewRay {
	Vector origin; // the eye, or a point on the screen plane in an orthogonal view
	Vector direction; // any length except zero
	Vector view; // normal of the drag plane of Motion::FREE: the view direction, or the up vector to keep the height
};

} // namespace playground::handles
