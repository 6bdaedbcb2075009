#pragma once

#include "playground/handles/constraint.hpp"

#include <string>

namespace playground::handles {

// What a person takes hold of to change a number or a vector of an object.
struct Handle {
	std::string key; // what it changes: "center", "radius", ...; "object" for the place of the whole
	Constraint constraint;
	// Where the line to it begins; the place itself if it needs none.
	Vector stem{ 0.0 };
	// The tip of an arm of one metre from `stem`, which may be drawn longer or shorter: of the place only its direction counts.
	bool is_arm = false;
	// The one that follows when the object itself is dragged.
	bool moves_body = false;
	// From the place to the point of the object that was taken hold of, which is to stay under the mouse.
	Vector grab{ 0.0 };
};

} // namespace playground::handles
