#include "cga/object/local_frame.hpp"

#include "cga/object/classify.hpp"
#include "cga/object/conformal_parts.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cga {

namespace {

// The relative error that earlier operations may have left in objects near the origin.
constexpr double PRIOR_ERROR = 1e-10;
// The relative error of the coefficients of the input.
constexpr double INPUT_ROUNDING = 16.0 * std::numeric_limits<double>::epsilon();
// A part is significant if its rounding error is at most this fraction of it.
constexpr double MAX_ROUNDING = 1.0 / 64.0;

// The sizes of the parts of an object, or of their rounding errors, relative to a given origin.
struct Extent {
	double euclidean, infinity, origin, both;

	// The largest part in a frame with the given unit.
	[[nodiscard]] double largest(double unit) const {
		return std::max({ origin, std::max(euclidean, both) / unit, infinity / (unit * unit) });
	}
	// The unit in which Q is not the largest part: the distance of the object from the origin.
	[[nodiscard]] double gap() const {
		const double flat = euclidean + both + std::sqrt(infinity * origin);
		return infinity > 0.0 ? infinity / flat : 0.0;
	}
};

Extent extent_of(const ConformalParts &parts) {
	return { parts.euclidean.max_abs(), parts.infinity.max_abs(), parts.origin.max_abs(), parts.both.max_abs() };
}

// The rounding errors of `parts` after a translation by t. The coefficients of e4 and e5 hold Q +- R / 2, so that Q and R have
// the error of the larger; the translation adds R t to A and D, and R t^2 to Q. `squares` is c^2 + |r^2| of a round.
Extent rounding_of(const Extent &parts, double t, double squares) {
	const double held = parts.origin > 0.0 ? INPUT_ROUNDING * (parts.infinity + parts.origin) : 0.0;
	const double flat = INPUT_ROUNDING * (parts.euclidean + parts.both);
	const double infinity = INPUT_ROUNDING * (parts.infinity + parts.origin * (1.0 + squares));
	return { flat + held * t, infinity + flat * t + held * t * t, held, flat + held * t };
}

} // namespace

struct LocalFrame::Object {
	int grade;
	ConformalParts parts;
	bool is_round;
	std::optional<Vector3<double>> position; // the center, or the point nearest to the origin
	double radius = 0.0; // of real and imaginary rounds; exactly 0 if zero within rounding
	double squares = 0.0; // c^2 + |r^2|
	// Relative to the origin of the frame.
	Extent extent{}, rounding{};

	Object(const Multivector &blade, int k) :
			grade(k), parts(parts_of(blade.grade(k))), is_round(cga::is_round(parts)) {
		if (is_round) {
			const RoundParameters found = round_parameters(parts, k - 1);
			const double square = std::abs(found.squared_radius());
			position = found.center();
			radius = square > squared_radius_rounding(parts, found) ? std::sqrt(square) : 0.0;
			squares = square + glm::dot(*position, *position);
		} else {
			const Classification found = classify(blade);
			position = found.distance ? *found.normal * *found.distance : found.center;
			parts.origin = {};
		}
	}

	// Rounds are recomposed from their parameters: translating their parts would tilt them by rounding.
	[[nodiscard]] ConformalParts moved(const Vector3<double> &t, double factor) const {
		return is_round ? round_parts(resized(translated(round_parameters(parts, grade - 1), t), factor)) : resized(translated(parts, t, grade), factor);
	}

	void measure_from(const Vector3<double> &origin) {
		extent = extent_of(moved(-origin, 1.0));
		rounding = rounding_of(extent_of(parts), glm::length(origin), squares);
	}

	[[nodiscard]] double distance() const { return position ? glm::length(*position) : 0.0; }

	// The smallest unit in which the rounding error of Q is insignificant beside R, or beside A and D.
	[[nodiscard]] double min_unit() const {
		const double round = std::sqrt(rounding.infinity / (MAX_ROUNDING * extent.origin));
		const double flat = rounding.infinity / (MAX_ROUNDING * std::max(extent.euclidean, extent.both));
		const double unit = std::min(round, flat);
		return std::isfinite(unit) ? unit : 0.0;
	}

	[[nodiscard]] double rounding_in(double unit) const { return rounding.largest(unit) / extent.largest(unit); }
};

LocalFrame::LocalFrame(const Multivector &first, int first_grade, const Multivector &second, int second_grade, Purpose purpose) {
	Object a(first, first_grade), b(second, second_grade);
	const bool by_second = a.is_round ? b.is_round && b.radius < a.radius : b.is_round || !a.position;
	Object &main = by_second ? b : a, &other = by_second ? a : b;
	_origin = main.position.value_or(other.position.value_or(Vector3<double>()));
	main.measure_from(_origin);
	other.measure_from(_origin);

	double size = main.radius;
	if (main.is_round && other.is_round) {
		// A point has no size of its own.
		const bool is_point = main.radius == 0.0 && purpose == Purpose::INCIDENCE;
		size = std::max(is_point ? other.radius : main.radius, other.extent.gap());
	} else if (!main.is_round) {
		size = std::max(main.distance(), other.distance());
		size = size > 0.0 ? size : 1.0;
	} else if (main.radius == 0.0 && other.position) {
		size = glm::length(_origin - *other.position);
	}
	size = std::max({ size, main.min_unit(), other.min_unit() });
	// Scaling by a power of two is exact.
	_unit = std::isfinite(size) && size > 0.0 ? std::ldexp(1.0, std::ilogb(size)) : 1.0;
	_rounding = PRIOR_ERROR + std::max(main.rounding_in(_unit), other.rounding_in(_unit));
	// A large round is nearly flat at the scale of a small one.
	_flatness = _rounding * std::min(1.0, _unit / std::max(main.radius, other.radius));
}

ConformalParts LocalFrame::enter(const Multivector &blade, int k) const {
	return Object(blade, k).moved(-_origin, 1.0 / _unit);
}

Multivector LocalFrame::leave(const ConformalParts &parts, int k) const {
	if (parts.origin.max_abs() > 0.0) {
		const RoundParameters found = round_parameters(parts, k - 1), moved = translated(resized(found, _unit), _origin);
		const double squares = glm::dot(found.along, found.along) + glm::dot(found.across, found.across);
		// Preserves a radius of zero, which the rounding of the translation would not.
		return from_parts(round_parts(std::abs(found.squared_radius()) <= INPUT_ROUNDING * squares ? with_radius_zero(moved) : moved));
	}
	return from_parts(translated(resized(parts, _unit), _origin, k));
}

} // namespace cga
