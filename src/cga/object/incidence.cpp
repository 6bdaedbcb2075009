#include "cga/object/incidence.hpp"

#include "cga/algebra/is_blade.hpp"
#include "cga/object/conformal_parts.hpp"
#include "cga/object/local_frame.hpp"

#include <cmath>
#include <limits>
#include <utility>

// meet and join are intersection and sum of the subspaces of R^5 that blades stand for, which no metric changes. In
// that of Cl(4,1) the products that find them vanish where what is shared is null, as for parallel lines; so vectors
// are compared in the metric where e5 squares to +1.

namespace cga {

namespace {

// Of one object's image, relative to its largest coefficient in the frame.
constexpr double IMAGE_ROUNDING = 1e-10;

struct Blades {
	LocalFrame frame;
	Multivector a, b;
	int grade_a, grade_b;
};

Result<Blades> enter(const Multivector &a, const Multivector &b) {
	if (!a.is_finite() || !b.is_finite()) {
		return Failure{ "An element has a coefficient that is not finite; give finite ones" };
	}
	const std::optional<int> grade_a = single_grade(a), grade_b = single_grade(b);
	if (!grade_a || !is_blade(a)) {
		return Failure{ "The first element is no blade (an outer product of vectors, other than zero), so it is no object" };
	}
	if (!grade_b || !is_blade(b)) {
		return Failure{ "The second element is no blade (an outer product of vectors, other than zero), so it is no object" };
	}
	const Multivector first = a.times_power_of_two(-std::ilogb(a.max_abs())), second = b.times_power_of_two(-std::ilogb(b.max_abs()));
	const LocalFrame frame(first, second);
	const Blades blades{ frame, frame.enter(first, *grade_a), frame.enter(second, *grade_b), *grade_a, *grade_b };
	if (!blades.a.is_finite() || !blades.b.is_finite()) {
		return Failure{ "The objects are too far away or too different in size for double; move them nearer to each other" };
	}
	return blades;
}

// The left contraction in the metric where e5 squares to +1.
Multivector contraction(const Multivector &left, const Multivector &right) {
	Multivector mirrored = left;
	for (unsigned bitmap = E5_BIT; bitmap < BLADE_COUNT; ++bitmap) {
		mirrored[BLADE_INDICES[bitmap]] *= -1.0;
	}
	return mirrored.left_contraction(right);
}

// The root of the sum of squares: the norm in that metric.
double length(const Multivector &x) {
	double sum = 0.0;
	for (double coefficient : x.coefficients()) {
		sum += coefficient * coefficient;
	}
	return std::sqrt(sum);
}

Multivector unit(const Multivector &x) {
	return x * (1.0 / length(x));
}

// The part of a vector in a unit blade.
Multivector projected(const Multivector &vector, const Multivector &blade) {
	return contraction(contraction(vector, blade), blade.reverse());
}

struct Span {
	Multivector meet, join;
	int meet_grade, join_grade;
};

// Takes from A, one after the other, the vectors that are farthest from B, until all that is left of it is in B.
Span span(const Blades &blades) {
	const Multivector b = unit(blades.b);
	Span span{ unit(blades.a), b, blades.grade_a, blades.grade_b };
	while (span.meet_grade > 0) {
		Multivector farthest;
		double distance = blades.frame.rounding();
		for (int k = 1; k <= DIMENSION; ++k) {
			const Multivector vector = projected(Multivector::basis_blade(k), span.meet);
			const Multivector outside = vector - projected(vector, span.join);
			const double outside_length = length(outside);
			if (outside_length > distance) {
				distance = outside_length;
				farthest = outside;
			}
		}
		if (farthest == Multivector()) {
			break;
		}
		farthest = unit(farthest);
		span.meet = unit(contraction(farthest, span.meet).grade(--span.meet_grade));
		span.join = unit(span.join.outer_product(farthest).grade(++span.join_grade));
	}
	// (B . J) . A: the same at once, without the rounding of the steps.
	const Multivector at_once = contraction(contraction(b, span.join.reverse()), blades.a).grade(span.meet_grade);
	if (length(at_once) > 0.0) {
		span.meet = unit(at_once);
	}
	return span;
}

// A blade of the frame without the parts that are rounding: a round whose radius is large beyond all digits is a flat,
// one whose radius is rounding is what tangent objects share, a flat out of sight is a direction.
Multivector cleaned(const Multivector &x, int grade, double rounding, double touching) {
	if (grade == 0 || grade == DIMENSION) {
		return x;
	}
	const Multivector blade = unit(x);
	ConformalParts parts = parts_of(blade);
	if (parts.origin.max_abs() > rounding) {
		const RoundParameters found = round_parameters(parts, grade - 1);
		const bool touches = std::abs(found.squared_radius) <= 2.0 * touching;
		return round_blade(found.center, found.attitude, touches ? 0.0 : found.squared_radius);
	}
	parts.origin = {};
	const bool kills_infinity = parts.euclidean.max_abs() <= rounding;
	const bool across_infinity = parts.both.max_abs() <= rounding;
	if (kills_infinity) {
		parts.euclidean = {};
	}
	if (across_infinity) {
		parts.both = {};
	}
	if (kills_infinity && !across_infinity) {
		const FlatParameters found = flat_parameters(parts, grade - 2);
		return flat_blade(found.foot, found.attitude);
	}
	return from_parts(parts);
}

// A result of grade k, out of the frame.
Result<Multivector> left(const Blades &blades, const Multivector &x, int k, double rounding) {
	if (!(x.max_abs() > 0.0)) {
		return Multivector();
	}
	const Multivector result = blades.frame.leave(cleaned(x.grade(k), k, rounding, blades.frame.rounding()), k);
	if (!result.is_finite()) {
		return Failure{ "The result is too far away or too large for double; move the objects nearer to the origin" };
	}
	return result;
}

Result<Multivector> inverse_of(const Multivector &blade) {
	const std::optional<Multivector> inverse = blade.inverse_of_versor();
	if (!inverse) {
		return Failure{ "The second element is null (a point, a tangent or a direction), so it has no inverse to project or reflect with" };
	}
	return *inverse;
}

} // namespace

Result<Multivector> meet(const Multivector &a, const Multivector &b) {
	const Result<Blades> blades = enter(a, b);
	if (!blades) {
		return blades.failure();
	}
	const Span found = span(*blades);
	return left(*blades, found.meet, found.meet_grade, blades->frame.rounding());
}

Result<Multivector> join(const Multivector &a, const Multivector &b) {
	const Result<Blades> blades = enter(a, b);
	if (!blades) {
		return blades.failure();
	}
	const Span found = span(*blades);
	return left(*blades, found.join, found.join_grade, blades->frame.rounding());
}

Result<Multivector> project_onto(const Multivector &x, const Multivector &onto) {
	const Result<Blades> blades = enter(x, onto);
	if (!blades) {
		return blades.failure();
	}
	const Result<Multivector> inverse = inverse_of(blades->b);
	if (!inverse) {
		return inverse;
	}
	return left(*blades, blades->a.left_contraction(blades->b).geometric_product(*inverse), blades->grade_a, IMAGE_ROUNDING);
}

Result<Multivector> reject_from(const Multivector &x, const Multivector &from) {
	const Result<Blades> blades = enter(x, from);
	if (!blades) {
		return blades.failure();
	}
	const Result<Multivector> inverse = inverse_of(blades->b);
	if (!inverse) {
		return inverse;
	}
	return left(*blades, blades->a.outer_product(blades->b).geometric_product(*inverse), blades->grade_a, IMAGE_ROUNDING);
}

Result<Multivector> reflect_in(const Multivector &x, const Multivector &mirror) {
	const Result<Blades> blades = enter(x, mirror);
	if (!blades) {
		return blades.failure();
	}
	const Result<Multivector> inverse = inverse_of(blades->b);
	if (!inverse) {
		return inverse;
	}
	const std::optional<Multivector> image = blades->b.dual().sandwich(blades->a);
	return image ? left(*blades, *image, blades->grade_a, IMAGE_ROUNDING) : inverse;
}

} // namespace cga
