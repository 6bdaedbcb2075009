#pragma once

#include "cga/vector.hpp"

namespace playground::handles {

using Vector = cga::Vector3<double>;

// What is seen through a place of the screen, in metres of the space that the objects live in.
struct ViewRay {
	Vector origin; // the eye; of a parallel view a point of the screen's plane
	Vector direction; // of any length but zero
	Vector view; // across the planes in which handles move freely: where the camera looks to, or up to stay on a level
};

} // namespace playground::handles
