#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/vector.hpp"
#include "playground/drawing/form.hpp"

#include <optional>
#include <vector>

// What is drawn for an element: which forms, where. Metres, in the space that the element lives in.

namespace playground::drawing {

using Vector = cga::Vector3<double>;

// Where the axes and the origin of a form come to lie.
struct Placement {
	Vector x{ 1.0, 0.0, 0.0 }, y{ 0.0, 1.0, 0.0 }, z{ 0.0, 0.0, 1.0 };
	Vector origin{ 0.0 };

	[[nodiscard]] Vector apply(const Vector &point) const { return origin + x * point.x + y * point.y + z * point.z; }
};

struct Part {
	Form form = Form::point;
	Placement placement;
	double radius = 1.0; // of rings and globes; negative where the orientation points inward
	bool dashed = false;
};

struct Figure {
	std::vector<Part> parts;
	Strokes own; // of Form::own
	bool imaginary = false; // drawn dashed and hollow
	bool dual = false; // drawn with double lines
	std::optional<Vector> label_place;
};

// Empty of parts for what has no place and no direction: scalars, e_inf, what is no object.
[[nodiscard]] Figure figure_of(const cga::Multivector &x, bool ipns = false);

// The corners of a box around a form, before it is placed. Signs of constant size on the screen count as a tenth of a
// metre; endless forms as 1e6 m.
struct Box {
	Vector least, greatest;
};
[[nodiscard]] Box box_of(const Part &part, const Strokes &own);
// The box along the axes around a placed one, and around two.
[[nodiscard]] Box placed(const Box &box, const Placement &placement);
[[nodiscard]] Box around_both(const Box &a, const Box &b);
[[nodiscard]] bool contains(const Box &outer, const Box &inner);
// What is placed there within a space that is itself placed.
[[nodiscard]] Placement placed(const Placement &inner, const Placement &space);

// Rounds from this radius on are anchored where they pass the origin, smaller ones as it looks best.
inline constexpr double LARGE_RADIUS = 100.0;

} // namespace playground::drawing
