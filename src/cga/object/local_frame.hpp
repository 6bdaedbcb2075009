#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/vector.hpp"

// A place and a length of unit in which two objects are near the origin and about one unit large.
//
// Coefficients hold squares of distances: two circles of a metre that are a kilometre away look alike to the sixth
// digit, and all that tells them apart is next to lost in a product. So meet, join and reflections move them here first.

namespace cga {

class LocalFrame {
public:
	LocalFrame(const Multivector &first, const Multivector &second);

	// `blade` of grade k in this frame, of size 1; and back.
	[[nodiscard]] Multivector enter(const Multivector &blade, int k) const;
	[[nodiscard]] Multivector leave(const Multivector &blade, int k) const;
	// The digits that the two objects have here are worth: what is smaller, relative to 1, is rounding.
	[[nodiscard]] double rounding() const { return _rounding; }

private:
	Vector3<double> _place{};
	double _unit = 1.0;
	double _rounding;
};

} // namespace cga
