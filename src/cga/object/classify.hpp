#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/vector.hpp"

#include <array>
#include <optional>
#include <string>

namespace cga {

enum class Kind {
	SCALAR,
	POINT,
	POINT_PAIR,
	CIRCLE,
	SPHERE,
	FLAT_POINT,
	LINE,
	PLANE,
	DIRECTION, // the meet of parallel lines or planes; also e_inf, which has no direction vector
	TANGENT, // a round of radius zero: a point with a direction or a normal
	ROTOR, // a rotation about an axis through the origin; about any other axis it is a MOTOR
	TRANSLATOR,
	DILATOR,
	MOTOR,
	NONE, // neither blade nor motor, or zero, the pseudoscalar, not finite
};

// The geometric interpretation of an element. Only fields that apply have a value; lengths in meters, directions of unit length.
struct Classification {
	Kind kind = Kind::NONE;
	// The representation in which the element is that object: the requested one, unless only the other has a meaning
	// (n + k e_inf is a plane in IPNS, and not a set of points in OPNS).
	bool ipns = false;
	bool imaginary = false; // the squared radius is negative
	std::optional<Vector3<double>> center; // of rounds and points; of lines, the point nearest to the origin
	std::optional<double> radius; // sqrt(|r^2|)
	std::optional<Vector3<double>> normal; // of circles, planes, and tangents and directions of planes
	std::optional<Vector3<double>> direction; // of point pairs, lines, and tangents and directions of lines
	std::optional<double> distance; // of a plane from the origin, along its normal
	std::optional<std::array<Vector3<double>, 2>> points; // of real point pairs; the direction points from the first to the second
	// The deviation from a blade, relative to the element's size: 0 for blades, up to about 1.
	double residual = 0.0;
};

// Interprets an element of any weight and sign as an object, in OPNS or in IPNS, or as a motor. With the parts of
// conformal_parts.hpp:
//
//   e_inf ^ X = 0, e_inf . X = 0   direction
//   e_inf ^ X = 0                  flat: F from D, foot Q F^-1
//   e_inf . X = 0                  dual flat
//   else                           round: E from R, center (A - D) E^-1, r^2 = 2 Q E^-1 + (c along E)^2 - (c across E)^2
//
// A round is a tangent (a point at grade 1) if r^2 is zero within rounding. Rounding grows with the distance from the origin,
// since coefficients hold c^2: radii of some centimeters at 1 km and of some 100 m at 100 km count as zero.
[[nodiscard]] Classification classify(const Multivector &x, bool ipns = false);

// The name in the API: "point_pair".
[[nodiscard]] const char *name_of(Kind kind);

// One line: "circle, radius 1.5, center (0, 1, 0), normal (0, 0, 1)", "imaginary point pair, ...", "dual plane, ...",
// "not a blade (residual 0.02)".
[[nodiscard]] std::string describe(const Classification &classification);

} // namespace cga
