#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/vector.hpp"
#include "playground/drawing/form.hpp"

#include <optional>
#include <vector>

// The forms that draw a multivector, and their placement. Meters, in the space of the multivector.

namespace playground::drawing {

using Vector = cga::Vector3<double>;

// An affine map: the images of the axes and of the origin of a form.
struct Placement {
	Vector x{ 1.0, 0.0, 0.0 }, y{ 0.0, 1.0, 0.0 }, z{ 0.0, 0.0, 1.0 };
	Vector origin{ 0.0 };

	[[nodiscard]] Vector apply(const Vector &point) const { return origin + x * point.x + y * point.y + z * point.z; }
};

struct Part {
	Form form = Form::POINT;
	Placement placement;
	double radius = 1.0; // of circles and spheres; negative if the orientation points inward
	bool dashed = false;
};

struct Figure {
	std::vector<Part> parts;
	Strokes custom; // of Form::CUSTOM
	bool imaginary = false; // dashed lines, hollow dots
	bool dual = false; // double lines
	std::optional<Vector> label_position;
};

// The figure of a scalar, of e_inf, or of a multivector that is not an object has no parts.
[[nodiscard]] Figure figure_of(const cga::Multivector &x, bool ipns = false);

struct Box {
	Vector min, max;
};
// Bounds of a form in its own space. Dots count as 0.1 m, arrows and discs of constant size on the screen as 1 m,
// unbounded forms as 1e6 m.
[[nodiscard]] Box bounds_of(const Part &part, const Strokes &custom);
// The axis-aligned bounding box of the transformed box.
[[nodiscard]] Box placed(const Box &box, const Placement &placement);
[[nodiscard]] Box merged(const Box &a, const Box &b);
[[nodiscard]] bool contains(const Box &outer, const Box &inner);
// The composition: first `inner`, then `space`.
[[nodiscard]] Placement placed(const Placement &inner, const Placement &space);

// If the radius of a circle or sphere is at least this, its anchor is its point nearest to the origin. Meters.
inline constexpr double LARGE_RADIUS = 100.0;

} // namespace playground::drawing
