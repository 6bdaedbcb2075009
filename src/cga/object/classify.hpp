#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/vector.hpp"

#include <array>
#include <optional>
#include <string>

namespace cga {

enum class Kind {
	scalar,
	point,
	point_pair,
	circle,
	sphere,
	flat_point,
	line,
	plane,
	direction, // what parallel lines or planes share; e_inf, which has no direction vector, too
	tangent, // a round of radius zero: a point with a direction, or with the normal of a plane
	rotor, // about an axis through the origin; about others it is a motor
	translator,
	dilator,
	motor,
	none, // no blade and no motor, zero, the pseudoscalar, not finite
};

// What an element is, geometrically. Only what applies has a value; lengths in metres, directions of unit length.
struct Classification {
	Kind kind = Kind::none;
	// The convention in which it is that: the one asked for, unless the element is nothing but a dual there (n + k e_inf
	// is a plane in IPNS, and no set of points in OPNS).
	bool ipns = false;
	bool imaginary = false; // the squared radius is negative
	std::optional<Vector3<double>> center; // of rounds; the point itself; of a line the foot of the origin
	std::optional<double> radius; // sqrt(|r^2|)
	std::optional<Vector3<double>> normal; // of circles, planes, tangents and directions across
	std::optional<Vector3<double>> direction; // of pairs, lines, tangents and directions along
	std::optional<double> distance; // of a plane from the origin, along its normal
	std::optional<std::array<Vector3<double>, 2>> points; // of real pairs, the second along the direction
	// How far the element is from being a blade, relative to its size: 0 for blades, up to about 1.
	double residual = 0.0;
};

// Reads an element of any weight and sign as an object in OPNS, or in IPNS, or as a motor. By the parts of
// conformal_parts.hpp:
//
//   e_inf ^ X = 0, e_inf . X = 0   direction
//   e_inf ^ X = 0                  flat: F from D, foot Q F^-1
//   e_inf . X = 0                  dual flat
//   else                           round: E from R, centre (A - D) E^-1, r^2 = 2 Q E^-1 + (c along E)^2 - (c across E)^2
//
// A round is tangent (a point at grade 1) where r^2 is within rounding of zero. What rounding is grows with the distance
// from the origin, as coefficients hold c^2: some centimetres of radius at 1 km, some 100 m at 100 km.
[[nodiscard]] Classification classify(const Multivector &x, bool ipns = false);

// "point_pair": the kind as api and users write it.
[[nodiscard]] const char *name_of(Kind kind);

// One line: "circle, radius 1.5, center (0, 1, 0), normal (0, 0, 1)", "imaginary point pair, ...", "dual plane, ...",
// "not a blade (residual 0.02)".
[[nodiscard]] std::string describe(const Classification &classification);

} // namespace cga
