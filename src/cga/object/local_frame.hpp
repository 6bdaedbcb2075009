#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/object/conformal_parts.hpp"
#include "cga/vector.hpp"

// An origin and a unit of length in which two objects are near the origin and the smaller one is about one unit large.
//
// Coefficients hold squares of distances: two circles of 1 m at a distance of 1 km agree in the first six digits, and their
// difference is nearly lost in a product. Meet, join and reflections therefore work in this frame.
//
// The origin is the center of the smaller round. The unit is its radius, or its distance from the other object if that is
// larger: the parts with e_o, the Euclidean parts and those with e_inf then have similar sizes. In the unit of the larger
// object, n times as large, the error of the result would be n^2 times as large.

namespace cga {

class LocalFrame {
public:
	// INCIDENCE decides what the objects share; IMAGE computes an image of the first, without decisions.
	enum class Purpose {
		INCIDENCE,
		IMAGE,
	};

	LocalFrame() = default; // the frame of the world
	LocalFrame(const Multivector &first, int first_grade, const Multivector &second, int second_grade, Purpose purpose);

	// `blade` of grade k in this frame, of size 1, and back.
	[[nodiscard]] ConformalParts enter(const Multivector &blade, int k) const;
	[[nodiscard]] Multivector leave(const ConformalParts &parts, int k) const;
	// The rounding error of the two objects in this frame, relative to 1: anything smaller is rounding.
	[[nodiscard]] double rounding() const { return _rounding; }
	// The weight of e_o below which a round of size 1 is flat.
	[[nodiscard]] double flatness() const { return _flatness; }

private:
	struct Object;

	Vector3<double> _origin{};
	double _unit = 1.0;
	double _rounding = 0.0;
	double _flatness = 0.0;
};

} // namespace cga
