#pragma once

#include "playground/handles/constraint.hpp"

#include <string>

namespace playground::handles {

// A point in the viewport that changes a parameter of an object when dragged.
struct Handle {
	std::string key; // the parameter: "center", "radius", ...; "object" for the position of the whole object
	Constraint constraint;
	// The start of the line drawn to the handle; the handle's position if there is no line.
	Vector stem{ 0.0 };
	// Whether the handle is the tip of an arm of one meter from `stem`. Only the direction matters, so the arm may be drawn with
	// another length.
	bool is_arm = false;
	// Whether dragging the object itself drags this handle.
	bool moves_body = false;
	// The offset from the handle to the grabbed point of the object. That point stays under the mouse.
	Vector grab{ 0.0 };
};

} // namespace playground::handles
