#include "cga/object/conformal_parts.hpp"

#include "cga/algebra/null_basis.hpp"
#include "cga/algebra/null_coefficients.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace cga {

namespace {

constexpr unsigned EUCLIDEAN_BLADES = 8;

constexpr double ROUNDING = 64.0 * std::numeric_limits<double>::epsilon();
constexpr double FLATNESS = 1e-12;

double parity_sign(int grade) {
	return grade % 2 == 0 ? 1.0 : -1.0;
}

Multivector inverse_of_euclidean(const Multivector &blade) {
	return blade.reverse() * (1.0 / blade.norm_squared());
}

// The projection of t onto a Euclidean blade: (t . E) E^-1.
Vector3<double> inside(const Vector3<double> &t, const Multivector &attitude) {
	return vector_of(euclidean(t).left_contraction(attitude).geometric_product(inverse_of_euclidean(attitude)));
}

// The grade of a Euclidean blade.
int grade_of(const Multivector &blade) {
	int grade = 0;
	double largest = 0.0;
	for (int k = 0; k <= 3; ++k) {
		const double size = blade.grade(k).max_abs();
		if (size > largest) {
			largest = size;
			grade = k;
		}
	}
	return grade;
}

} // namespace

ConformalParts parts_of(const Multivector &x) {
	return parts_of_null(Multivector(to_null_coefficients(x)));
}

Multivector from_parts(const ConformalParts &parts) {
	return from_null_coefficients(null_of_parts(parts).coefficients());
}

ConformalParts parts_of_null(const Multivector &null) {
	ConformalParts parts;
	for (unsigned bitmap = 0; bitmap < EUCLIDEAN_BLADES; ++bitmap) {
		const int index = BLADE_INDICES[bitmap];
		parts.euclidean[index] = null[BLADE_INDICES[bitmap]];
		parts.infinity[index] = null[BLADE_INDICES[bitmap | E4_BIT]];
		parts.origin[index] = null[BLADE_INDICES[bitmap | E5_BIT]];
		parts.both[index] = null[BLADE_INDICES[bitmap | E4_BIT | E5_BIT]];
	}
	return parts;
}

Multivector null_of_parts(const ConformalParts &parts) {
	Multivector null;
	for (unsigned bitmap = 0; bitmap < EUCLIDEAN_BLADES; ++bitmap) {
		const int index = BLADE_INDICES[bitmap];
		null[BLADE_INDICES[bitmap]] = parts.euclidean[index];
		null[BLADE_INDICES[bitmap | E4_BIT]] = parts.infinity[index];
		null[BLADE_INDICES[bitmap | E5_BIT]] = parts.origin[index];
		null[BLADE_INDICES[bitmap | E4_BIT | E5_BIT]] = parts.both[index];
	}
	return null;
}

// A' = A + R ^ t,  R' = R,  D' = D + (-1)^k t . R,
// Q' = Q - D ^ t + t^2/2 R - (-1)^k (t . A + (t . R) ^ t)
ConformalParts translated(const ConformalParts &parts, const Vector3<double> &t, int k) {
	const Multivector vector = euclidean(t);
	const Multivector inside = vector.left_contraction(parts.origin);
	const double sign = parity_sign(k);
	return {
		parts.euclidean + parts.origin.outer_product(vector),
		parts.infinity - parts.both.outer_product(vector) + 0.5 * glm::dot(t, t) * parts.origin - sign * (vector.left_contraction(parts.euclidean) + inside.outer_product(vector)),
		parts.origin,
		parts.both + sign * inside,
	};
}

ConformalParts resized(const ConformalParts &parts, double factor) {
	return { parts.euclidean, parts.infinity * factor, parts.origin * (1.0 / factor), parts.both };
}

bool is_round(const ConformalParts &parts) {
	const double r = parts.origin.max_abs();
	return r > ROUNDING * (parts.infinity.max_abs() + r) && r > FLATNESS * (parts.euclidean.max_abs() + parts.both.max_abs());
}

RoundParameters round_parameters(const ConformalParts &parts, int k) {
	const Multivector attitude = parity_sign(k) * parts.origin;
	const Multivector inverse = inverse_of_euclidean(attitude);
	return {
		vector_of(-parts.both.geometric_product(inverse)),
		vector_of(parts.euclidean.geometric_product(inverse)),
		attitude,
		parity_sign(k) * parts.infinity.scalar_product(inverse),
	};
}

double RoundParameters::squared_radius() const {
	return 2.0 * half_power + glm::dot(along, along) - glm::dot(across, across);
}

RoundParameters translated(const RoundParameters &parameters, const Vector3<double> &t) {
	const Multivector &attitude = parameters.attitude;
	const Vector3<double> along = inside(t, attitude), across = t - along;
	return {
		parameters.along + along,
		parameters.across + across,
		attitude,
		parameters.half_power + glm::dot(parameters.across + 0.5 * across, across) - glm::dot(parameters.along + 0.5 * along, along),
	};
}

RoundParameters with_radius_zero(const RoundParameters &parameters) {
	const Vector3<double> &along = parameters.along, &across = parameters.across;
	return { along, across, parameters.attitude, 0.5 * (glm::dot(across, across) - glm::dot(along, along)) };
}

RoundParameters resized(const RoundParameters &parameters, double factor) {
	return { parameters.along * factor, parameters.across * factor, parameters.attitude, parameters.half_power * (factor * factor) };
}

ConformalParts round_parts(const RoundParameters &parameters) {
	const Multivector &attitude = parameters.attitude;
	const Multivector across = euclidean(parameters.across), inside = euclidean(parameters.along).left_contraction(attitude);
	const double sign = parity_sign(grade_of(attitude));
	return { across.outer_product(attitude), sign * (parameters.half_power * attitude - across.outer_product(inside)), sign * attitude, -inside };
}

double squared_radius_rounding(const ConformalParts &parts, const RoundParameters &parameters) {
	const Vector3<double> center = parameters.center();
	const double squares = glm::dot(center, center) + std::abs(parameters.squared_radius());
	const double held = 2.0 * parts.infinity.max_abs() / parts.origin.max_abs();
	return std::numeric_limits<double>::epsilon() * (1.0 + squares) * (64.0 + held);
}

FlatParameters flat_parameters(const ConformalParts &parts, int k) {
	const Multivector attitude = -parity_sign(k) * parts.both;
	return { vector_of(parts.infinity.geometric_product(inverse_of_euclidean(attitude))), attitude };
}

Multivector round_blade(const Vector3<double> &center, const Multivector &attitude, double squared_radius) {
	const Vector3<double> along = inside(center, attitude), across = center - along;
	return from_parts(round_parts({ along, across, attitude, 0.5 * (squared_radius - glm::dot(along, along) + glm::dot(across, across)) }));
}

Multivector flat_blade(const Vector3<double> &position, const Multivector &attitude) {
	const double sign = parity_sign(grade_of(attitude));
	return from_parts({ {}, euclidean(position).outer_product(attitude), {}, -sign * attitude });
}

Multivector plane_across(const Vector3<double> &normal) {
	Multivector plane;
	plane[E23] = normal.x;
	plane[E13] = -normal.y;
	plane[E12] = normal.z;
	return plane;
}

Vector3<double> normal_of(const Multivector &bivector) {
	return { bivector[E23], -bivector[E13], bivector[E12] };
}

Vector3<double> vector_of(const Multivector &x) {
	return { x[E1], x[E2], x[E3] };
}

} // namespace cga
