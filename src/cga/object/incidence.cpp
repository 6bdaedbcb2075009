#include "cga/object/incidence.hpp"

#include "cga/algebra/is_blade.hpp"
#include "cga/algebra/null_coefficients.hpp"
#include "cga/object/conformal_parts.hpp"
#include "cga/object/local_frame.hpp"

#include <cmath>
#include <limits>
#include <utility>

// Meet and join are the intersection and sum of the subspaces of R^5 that blades represent, and do not depend on the metric. In
// the metric of Cl(4,1), the products that compute them vanish where the intersection is null, as for parallel lines; so
// vectors are compared in the metric where e5 squares to +1.

namespace cga {

namespace {

// The rounding error of an image, relative to its largest coefficient in the frame.
constexpr double IMAGE_ROUNDING = 1e-10;

struct Blades {
	LocalFrame frame;
	// In the null basis, as conformal_parts.hpp says.
	Multivector a, b;
	int grade_a, grade_b;
};

Multivector of_size_one(const ConformalParts &parts) {
	const Multivector null = null_of_parts(parts);
	return null * (1.0 / null.max_abs());
}

Result<Blades, AlgebraError> enter(const Multivector &a, const Multivector &b, LocalFrame::Purpose purpose) {
	if (!a.is_finite() || !b.is_finite()) {
		return AlgebraError::NOT_FINITE;
	}
	const std::optional<int> grade_a = single_grade(a), grade_b = single_grade(b);
	if (!grade_a || !is_blade(a)) {
		return AlgebraError::FIRST_NOT_A_BLADE;
	}
	if (!grade_b || !is_blade(b)) {
		return AlgebraError::SECOND_NOT_A_BLADE;
	}
	const Multivector first = a.times_power_of_two(-std::ilogb(a.max_abs())), second = b.times_power_of_two(-std::ilogb(b.max_abs()));
	const LocalFrame frame(first, *grade_a, second, *grade_b, purpose);
	const Blades blades{ frame, of_size_one(frame.enter(first, *grade_a)), of_size_one(frame.enter(second, *grade_b)), *grade_a, *grade_b };
	if (!blades.a.is_finite() || !blades.b.is_finite()) {
		return AlgebraError::OBJECTS_TOO_FAR_APART;
	}
	return blades;
}

// The left contraction in the metric where all basis vectors square to +1.
Multivector contraction(const Multivector &left, const Multivector &right) {
	Multivector mirrored = left;
	for (unsigned bitmap = E5_BIT; bitmap < BLADE_COUNT; ++bitmap) {
		mirrored[BLADE_INDICES[bitmap]] *= -1.0;
	}
	return mirrored.left_contraction(right);
}

// The norm in that metric.
double length(const Multivector &x) {
	return std::sqrt(x.sum_of_squares());
}

Multivector unit(const Multivector &x) {
	return x * (1.0 / length(x));
}

// The projection of a vector onto a unit blade.
Multivector projected(const Multivector &vector, const Multivector &blade) {
	return contraction(contraction(vector, blade), blade.reverse());
}

struct Span {
	Multivector meet, join;
	int meet_grade, join_grade;
};

// x normalized, with the sign of `wanted`, to which it is equal up to weight and rounding.
Multivector with_sign_of(const Multivector &wanted, const Multivector &x) {
	double product = 0.0;
	for (int i = 0; i < BLADE_COUNT; ++i) {
		product += wanted[i] * x[i];
	}
	return unit(product < 0.0 ? -x : x);
}

// Recomputes a span in one step, without the rounding of the iteration: M = (B . J) . A and J = A ^ (M . B), or the blades
// themselves if one contains the other. For a scalar M or a pseudoscalar J, the result does not depend on the unit of length.
Span recomputed(const Blades &blades, Span span) {
	const Multivector b = unit(blades.b), meet = contraction(contraction(b, span.join.reverse()), blades.a).grade(span.meet_grade);
	if (length(meet) > 0.0) {
		span.meet = unit(meet);
	}
	const bool a_in_b = span.meet_grade == blades.grade_a, b_in_a = span.meet_grade == blades.grade_b;
	if (a_in_b || b_in_a) {
		span.meet = with_sign_of(span.meet, a_in_b ? blades.a : blades.b);
		span.join = with_sign_of(span.join, a_in_b ? blades.b : blades.a);
		return span;
	}
	const Multivector join = blades.a.outer_product(contraction(span.meet, b)).grade(span.join_grade);
	if (length(join) > 0.0) {
		span.join = with_sign_of(span.join, join);
	}
	return span;
}

// Removes from A, one after the other, the vectors farthest from B, until the rest of A lies in B.
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
	return recomputed(blades, span);
}

bool is_tangent(const RoundParameters &round, double tangency) {
	return std::abs(round.squared_radius()) <= 2.0 * tangency;
}

// Removes the parts of a blade that are only rounding errors: a round with too large a radius to resolve becomes a flat, one
// with a radius of zero within rounding a tangent, and an infinitely distant flat a direction.
ConformalParts cleaned(ConformalParts parts, int grade, double flatness, double rounding, double tangency) {
	if (grade == 0 || grade == DIMENSION) {
		parts.origin = {};
		return parts;
	}
	if (parts.origin.max_abs() > flatness) {
		const RoundParameters found = round_parameters(parts, grade - 1);
		return round_parts(is_tangent(found, tangency) ? with_radius_zero(found) : found);
	}
	parts.origin = {};
	const bool contains_infinity = parts.euclidean.max_abs() <= rounding;
	const bool is_orthogonal_to_infinity = parts.both.max_abs() <= rounding;
	if (contains_infinity) {
		parts.euclidean = {};
	}
	if (is_orthogonal_to_infinity) {
		parts.both = {};
	}
	if (contains_infinity && !is_orthogonal_to_infinity) {
		const FlatParameters found = flat_parameters(parts, grade - 2);
		return parts_of(flat_blade(found.foot, found.attitude));
	}
	return parts;
}

// A result of grade k in the null basis, transformed from the frame to the world.
MultivectorResult leave(const Blades &blades, const Multivector &x, int k, double flatness, double rounding, double tangency) {
	const Multivector null = x.grade(k);
	if (!(null.max_abs() > 0.0)) {
		return Multivector();
	}
	const ConformalParts parts = cleaned(parts_of_null(unit(null)), k, flatness, rounding, tangency);
	const Multivector result = blades.frame.leave(parts, k);
	return result.is_finite() ? MultivectorResult(result) : AlgebraError::RESULT_OVERFLOW;
}

// The meet or the join, as members of Span.
MultivectorResult meet_or_join(const Multivector &a, const Multivector &b, Multivector Span::*blade, int Span::*grade) {
	const Result<Blades, AlgebraError> blades = enter(a, b, LocalFrame::Purpose::INCIDENCE);
	if (!blades) {
		return blades.error();
	}
	const Span found = span(*blades);
	const double rounding = blades->frame.rounding();
	return leave(*blades, found.*blade, found.*grade, blades->frame.flatness(), rounding, rounding);
}

// Both blades in the basis e1 .. e5, the second with its inverse.
struct Factors {
	Multivector a, b, inverse;
};

// The result of `image`, which has the grade of the first factor. A versor maps points and tangents to points and tangents.
template <class Image>
MultivectorResult image_of(const Multivector &a, const Multivector &b, bool by_versor, Image image) {
	const Result<Blades, AlgebraError> blades = enter(a, b, LocalFrame::Purpose::IMAGE);
	if (!blades) {
		return blades.error();
	}
	const Multivector x = from_null_coefficients(blades->a.coefficients()), factor = from_null_coefficients(blades->b.coefficients());
	const std::optional<Multivector> inverse = factor.inverse_of_versor();
	if (!inverse) {
		return AlgebraError::SECOND_IS_NULL;
	}
	const Multivector result = image(Factors{ x, factor, *inverse });
	const ConformalParts parts = parts_of_null(blades->a);
	const bool is_point = by_versor && is_round(parts) && is_tangent(round_parameters(parts, blades->grade_a - 1), blades->frame.rounding());
	const double tangency = is_point ? std::numeric_limits<double>::infinity() : blades->frame.rounding();
	return leave(*blades, Multivector(to_null_coefficients(result)), blades->grade_a, IMAGE_ROUNDING, IMAGE_ROUNDING, tangency);
}

} // namespace

MultivectorResult meet(const Multivector &a, const Multivector &b) {
	return meet_or_join(a, b, &Span::meet, &Span::meet_grade);
}

MultivectorResult join(const Multivector &a, const Multivector &b) {
	return meet_or_join(a, b, &Span::join, &Span::join_grade);
}

MultivectorResult project_onto(const Multivector &x, const Multivector &onto) {
	return image_of(x, onto, false, [](const Factors &in) { return in.a.left_contraction(in.b).geometric_product(in.inverse); });
}

MultivectorResult reject_from(const Multivector &x, const Multivector &from) {
	return image_of(x, from, false, [](const Factors &in) { return in.a.outer_product(in.b).geometric_product(in.inverse); });
}

MultivectorResult reflect_in(const Multivector &x, const Multivector &mirror) {
	return image_of(x, mirror, true, [](const Factors &in) { return in.b.dual().sandwich(in.a).value_or(Multivector()); });
}

} // namespace cga
