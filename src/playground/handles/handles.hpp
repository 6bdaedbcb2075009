#pragma once

#include "playground/document/document.hpp"
#include "playground/handles/handle.hpp"

#include <string_view>
#include <vector>

namespace playground::handles {

// The handles of an entry, of what can be set of it (parameters.hpp). Of
//
//   points, and each point that something goes through   position, a, b, c, d: free
//   spheres, circles, imaginary pairs                    center: free; radius: along a line; normal, direction: the tip of an arm
//   planes                                               distance: along the normal; normal: the tip of an arm, about the origin
//   lines, tangents                                      point: free; direction, normal: the tip of an arm
//   translators, vectors                                 offset, vector: free, from the origin
//   rotors, motors, dilators                             translation: free; axis: the tip of an arm; angle: on a circle about
//                                                        it; scale: along the x axis of the frame that is carried
//   objects written as a list or a sum of blades         object: free, of planes along the normal
//
// `right` is where the radius of a sphere is taken hold of, seen from its centre; of a circle as near to it as it gets. None
// of what has no value, is computed, or has no place.
[[nodiscard]] std::vector<Handle> handles_of(const Document &document, std::string_view name, const Vector &right = Vector(1.0, 0.0, 0.0));

} // namespace playground::handles
