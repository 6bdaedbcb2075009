#pragma once

#include "playground/document/document.hpp"
#include "playground/handles/handle.hpp"

#include <string_view>
#include <vector>

namespace playground::handles {

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
