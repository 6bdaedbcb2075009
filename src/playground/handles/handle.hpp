#pragma once

#include "playground/handles/constraint.hpp"

#include <string>

namespace playground::handles {

// A point in the viewport that changes a parameter of an object when dragged.
struct Handle {
	std::string key; // the parameter: "center", "radius", ...; "object" for the position of the whole
	Constraint constraint;
	// The start of the line drawn to it; its own position if there is no line.
	Vector stem{ 0.0 };
	// Whether it is the tip of an arm of one meter from `stem`. Only its direction matters, so that the arm may be drawn with
	// another length.
	bool is_arm = false;
	// Whether dragging the object itself drags this handle.
	bool moves_body = false;
	// The offset from its position to the grabbed point of the object, which is kept under the mouse.
	Vector grab{ 0.0 };
};

} // namespace playground::handles
