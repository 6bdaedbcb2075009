#pragma once

#include "playground/document/document.hpp"
#include "playground/handles/constraint.hpp"

#include <string>
#include <string_view>
#include <vector>

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

// The handles of an entry, for its parameters (parameters.hpp):
//
//   points, and points that define other objects         position, a, b, c, d: free
//   points with one free coordinate: point(t, 1, u)      y: along the axis
//   spheres, circles, imaginary pairs                    center: free; radius: along a line; normal, direction: tip of an arm
//   planes                                               distance: along the normal; normal: tip of an arm, around the origin
//   lines, tangents                                      point: free; direction, normal: tip of an arm
//   translators, vectors                                 offset, vector: free, from the origin
//   rotors, motors, dilators                             translation: free; axis: tip of an arm; angle: on a circle around
//                                                        it; scale: along the diagonal of the transformed frame
//   objects written as a list or a sum of blades         object: free; planes along the normal
//
// `right` is the direction from the center of a sphere to its radius handle; for a circle the closest direction in its plane.
// Empty for entries without a value, parameters or a position.
[[nodiscard]] std::vector<Handle> handles_of(const Document &document, std::string_view name, const Vector &right = Vector(1.0, 0.0, 0.0));

} // namespace playground::handles
