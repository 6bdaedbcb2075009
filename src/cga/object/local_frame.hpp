#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/object/conformal_parts.hpp"
#include "cga/vector.hpp"

// A place and a length of unit in which two objects are near the origin and the smaller one is about one unit large.
//
// Coefficients hold squares of distances: two circles of a metre that are a kilometre away look alike to the sixth
// digit, and all that tells them apart is next to lost in a product. So meet, join and reflections move them here first.
//
// The place is the centre of the smaller round. The unit is its radius, or how far the other object passes from it if
// that is more: what is e_o for the one, directions for the other and e_inf for both is then of the same size. In the unit
// of the larger one, of n times the size, what they share would be right to n^2 roundings only.

namespace cga {

class LocalFrame {
public:
	// What the frame is for: to say what objects share, or to compute an image of the first, where nothing is decided.
	enum class Purpose {
		INCIDENCE,
		IMAGE,
	};

	LocalFrame(const Multivector &first, int first_grade, const Multivector &second, int second_grade, Purpose purpose);

	// `blade` of grade k in this frame, of size 1; and back.
	[[nodiscard]] ConformalParts enter(const Multivector &blade, int k) const;
	[[nodiscard]] Multivector leave(const ConformalParts &parts, int k) const;
	// The digits that the two objects have here are worth: what is smaller, relative to 1, is rounding.
	[[nodiscard]] double rounding() const { return _rounding; }
	// The weight of e_o below which a round of size 1 is flat.
	[[nodiscard]] double flatness() const { return _flatness; }

private:
	struct Object;

	Vector3<double> _place{};
	double _unit = 1.0;
	double _rounding;
	double _flatness;
};

} // namespace cga
