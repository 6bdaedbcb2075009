#include "cga/object/local_frame.hpp"

#include "cga/object/classify.hpp"
#include "cga/object/conformal_parts.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace cga {

namespace {

constexpr double EPSILON = std::numeric_limits<double>::epsilon();
constexpr double ALWAYS = 1e-10;

struct Place {
	bool exists = false;
	bool is_round = false;
	Vector3<double> center{};
	double radius = 0.0;
	// Of the squared radius of a round.
	double rounding = 0.0;
};

Place place_of(const Multivector &blade) {
	const Classification found = classify(blade);
	Place place;
	place.is_round = found.radius || found.kind == Kind::point || found.kind == Kind::tangent;
	place.radius = found.radius.value_or(0.0);
	if (place.is_round) {
		const ConformalParts parts = parts_of(blade);
		const double radius = found.imaginary ? -place.radius : place.radius;
		place.rounding = squared_radius_rounding(parts, { *found.center, {}, radius * place.radius });
	}
	if (found.center) {
		place.exists = true;
		place.center = *found.center;
	} else if (found.distance) {
		place.exists = true;
		place.center = *found.normal * *found.distance;
	}
	return place;
}

// In a frame of this unit: of flats the distance is all that is held.
double rounding_of(const Place &place, double unit) {
	return place.is_round ? place.rounding / (unit * unit) : EPSILON * (1.0 + glm::length(place.center) / unit);
}

} // namespace

LocalFrame::LocalFrame(const Multivector &first, const Multivector &second) {
	const Place a = place_of(first), b = place_of(second);
	const Place &main = a.is_round || !b.is_round ? a : b;
	_place = main.exists ? main.center : (a.exists ? a.center : b.center);
	double size = std::max(a.radius, b.radius);
	if (!a.is_round && !b.is_round) {
		size = std::max(glm::length(a.center), glm::length(b.center));
		size = size > 0.0 ? size : 1.0;
	} else if (a.exists && b.exists && (a.is_round == b.is_round || size == 0.0)) {
		size = std::max(size, glm::length(a.center - b.center));
	}
	// Smaller than this, objects are one: what is left of their differences is rounding.
	size = std::max(size, 8.0 * std::sqrt(std::max(a.rounding, b.rounding)));
	// A power of two changes no digit.
	_unit = std::isfinite(size) ? std::ldexp(1.0, std::ilogb(size)) : 1.0;
	_rounding = ALWAYS + std::max(rounding_of(a, _unit), rounding_of(b, _unit));
}

// Rounds are made anew from their centre and radius: moved as they are, rounding would tilt them.
Multivector LocalFrame::enter(const Multivector &blade, int k) const {
	const ConformalParts parts = parts_of(blade.grade(k));
	Multivector moved;
	if (is_round(parts)) {
		const RoundParameters found = round_parameters(parts, k - 1);
		moved = round_blade((found.center - _place) / _unit, found.attitude, found.squared_radius / (_unit * _unit));
	} else {
		moved = from_parts(resized(translated(parts, -_place, k), 1.0 / _unit));
	}
	return moved * (1.0 / moved.max_abs());
}

Multivector LocalFrame::leave(const Multivector &blade, int k) const {
	const ConformalParts parts = parts_of(blade.grade(k));
	if (is_round(parts)) {
		const RoundParameters found = round_parameters(parts, k - 1);
		return round_blade(_place + _unit * found.center, found.attitude, found.squared_radius * (_unit * _unit));
	}
	return from_parts(translated(resized(parts, _unit), _place, k));
}

} // namespace cga
