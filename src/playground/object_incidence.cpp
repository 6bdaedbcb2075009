#include "playground/object_incidence.hpp"

#include "cga/algebra/inverse.hpp"
#include "cga/algebra/is_blade.hpp"

#include <cmath>

namespace playground {

namespace {

using cga::BLADE_BITMAPS;
using cga::BLADE_COUNT;
using cga::BLADE_INDICES;
using cga::Failure;
using cga::Multivector;
using cga::Result;

constexpr double ROUNDING = 1e-9;
constexpr Failure NO_BLADE{ "expected blades: outer products of vectors, as all objects are" };

double size(const Multivector &x) {
	double sum = 0.0;
	for (const double coefficient : x.coefficients()) {
		sum += coefficient * coefficient;
	}
	return std::sqrt(sum);
}

// `x` of unit size, and empty for zero.
std::optional<Multivector> unit(const Multivector &x) {
	const double largest = x.max_abs();
	if (!(largest > 0.0)) {
		return std::nullopt;
	}
	const Multivector near_one = x * (1.0 / largest);
	return near_one * (1.0 / size(near_one));
}

// The geometric product where all basis vectors square to 1; with `contraction` its parts of grade j - i alone.
Multivector euclidean_product(const Multivector &left, const Multivector &right, bool contraction = false) {
	Multivector product;
	for (int l = 0; l < BLADE_COUNT; ++l) {
		for (int r = 0; r < BLADE_COUNT; ++r) {
			const unsigned i = BLADE_BITMAPS[size_t(l)];
			const unsigned j = BLADE_BITMAPS[size_t(r)];
			const bool is_kept = !contraction || (i & ~j) == 0;
			if (is_kept && left[l] != 0.0 && right[r] != 0.0) {
				const int metric = cga::grade_of_bitmap(i & j & cga::NEGATIVE_VECTORS) % 2 == 0 ? 1 : -1;
				product[BLADE_INDICES[i ^ j]] += metric * cga::product_sign(i, j) * left[l] * right[r];
			}
		}
	}
	return product;
}

// Blades of unit size, and their relation.
struct Pair {
	Multivector a, b;
	int grade_of_join = 0;
	Multivector join; // of unit size
};

// The top grade of A B, which is what A and B do not share.
int difference_grade(const Multivector &product) {
	for (int grade = cga::DIMENSION; grade > 0; --grade) {
		if (size(product.grade(grade)) > ROUNDING) {
			return grade;
		}
	}
	return 0;
}

// A ^ v ^ ..., with vectors v of B until the grade is reached, each time the one that is least contained so far.
Multivector extended(const Multivector &a, const Multivector &b, int count) {
	Multivector join = a;
	for (; count > 0; --count) {
		Multivector best;
		for (int index = 0; index < BLADE_COUNT; ++index) {
			const Multivector vector = euclidean_product(Multivector::basis_blade(index), b, true).grade(1);
			const Multivector longer = join.outer_product(vector);
			if (size(longer) > size(best)) {
				best = longer;
			}
		}
		join = unit(best).value_or(join);
	}
	return join;
}

Result<Pair> pair_of(const Multivector &left, const Multivector &right) {
	const std::optional<Multivector> a = unit(left);
	const std::optional<Multivector> b = unit(right);
	if (!a || !b || !cga::is_blade(*a) || !cga::is_blade(*b)) {
		return NO_BLADE;
	}
	const int grade_a = *cga::single_grade(*a);
	const int grade_b = *cga::single_grade(*b);
	const int difference = difference_grade(euclidean_product(*a, *b));
	Pair pair{ a->grade(grade_a), b->grade(grade_b), (grade_a + grade_b + difference) / 2, {} };
	// The orientation of the join: the pseudoscalar's, or that of the blade that contains the other; else A's with what
	// B adds to it.
	if (pair.grade_of_join == cga::DIMENSION) {
		pair.join = Multivector::basis_blade(BLADE_COUNT - 1);
	} else if (pair.grade_of_join == grade_b) {
		pair.join = pair.b;
	} else {
		pair.join = extended(pair.a, pair.b, pair.grade_of_join - grade_a);
	}
	return pair;
}

} // namespace

Result<Multivector> join(const Multivector &a, const Multivector &b) {
	const Result<Pair> pair = pair_of(a, b);
	if (!pair) {
		return pair.failure();
	}
	return pair->join;
}

Result<Multivector> meet(const Multivector &a, const Multivector &b) {
	const Result<Pair> pair = pair_of(a, b);
	if (!pair) {
		return pair.failure();
	}
	// J has unit size, so that its inverse in the Euclidean metric is its reverse.
	return euclidean_product(euclidean_product(pair->a, pair->join.reverse()), pair->b, true);
}

Result<Multivector> project_onto(const Multivector &x, const Multivector &onto) {
	if (!cga::is_blade(x) || !cga::is_blade(onto)) {
		return NO_BLADE;
	}
	const Result<Multivector> inverse = cga::inverse(onto);
	if (!inverse) {
		return inverse;
	}
	return x.left_contraction(onto).geometric_product(*inverse);
}

Result<Multivector> reject_from(const Multivector &x, const Multivector &from) {
	const Result<Multivector> projection = project_onto(x, from);
	if (!projection) {
		return projection;
	}
	return x - *projection;
}

Result<Multivector> reflect_in(const Multivector &x, const Multivector &mirror) {
	if (!cga::is_blade(mirror)) {
		return NO_BLADE;
	}
	const std::optional<Multivector> reflected = mirror.dual().sandwich(x);
	if (!reflected) {
		return Failure{ "expected a mirror that has an inverse; null blades reflect nothing" };
	}
	return *reflected;
}

} // namespace playground
