#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/vector.hpp"

// Decomposes a blade into Euclidean blades, and composes one from its geometric parameters. The coefficients of e4 and e5,
// (p^2 -+ 1) / 2 for a point p, never occur as intermediate results: their rounding would lose digits of Q and R.
//
//   X = A + Q ^ e_inf + R ^ e_o + D ^ E,     A, Q, R, D in the algebra of e1, e2, e3
//
// A round with center c, attitude E_k (a Euclidean k-blade) and squared radius s is
// (e_o + c + b e_inf) ^ T_c[E_k] with b = (c^2 + s) / 2, so that
//   A = c ^ E_k,   D = -(c . E_k),   R = (-1)^k E_k,   Q = (-1)^k (b E_k - c ^ (c . E_k))
// A flat through p is (e_o + p) ^ F_k ^ e_inf: D = -(-1)^k F_k, Q = p ^ F_k.

namespace cga {

struct ConformalParts {
	Multivector euclidean; // A
	Multivector infinity; // Q
	Multivector origin; // R
	Multivector both; // D
};

[[nodiscard]] ConformalParts parts_of(const Multivector &x);
[[nodiscard]] Multivector from_parts(const ConformalParts &parts);
// The same for an element in the null basis (null_coefficients.hpp), which preserves the digits of Q and R whatever their
// relative size. Outer products of such elements are valid; inner products are not.
[[nodiscard]] ConformalParts parts_of_null(const Multivector &null);
[[nodiscard]] Multivector null_of_parts(const ConformalParts &parts);

// The parts of a blade of grade k, moved by t: e_o becomes e_o + t + t^2/2 e_inf, a vector u becomes u + (u . t) e_inf.
[[nodiscard]] ConformalParts translated(const ConformalParts &parts, const Vector3<double> &t, int k);
// All lengths times `factor`; this also changes the weight.
[[nodiscard]] ConformalParts resized(const ConformalParts &parts, double factor);

// Whether a blade with these parts is a round (or a point or tangent): R is not zero within rounding, and the center is within
// 1e12 meters, beyond which rounds count as flats.
[[nodiscard]] bool is_round(const ConformalParts &parts);

// The parameters of a round of grade k + 1: Q = (-1)^k (h E_k - across ^ (along . E_k)). Instead of s they hold
// 2 h = s - along^2 + across^2: near the surface of a large round, s and the squares are large and nearly cancel.
struct RoundParameters {
	Vector3<double> along, across; // the parts of c in E_k and across it
	Multivector attitude; // E_k
	double half_power; // h

	[[nodiscard]] Vector3<double> center() const { return along + across; }
	[[nodiscard]] double squared_radius() const;
};
// along = -D E^-1, across = A E^-1, h = (-1)^k Q . E^-1. R must not be zero.
[[nodiscard]] RoundParameters round_parameters(const ConformalParts &parts, int k);
// Moved by t: along and across by the parts of t, h by across . t - along . t + (t_across^2 - t_along^2) / 2.
[[nodiscard]] RoundParameters translated(const RoundParameters &parameters, const Vector3<double> &t);
[[nodiscard]] RoundParameters with_radius_zero(const RoundParameters &parameters);
[[nodiscard]] RoundParameters resized(const RoundParameters &parameters, double factor);
[[nodiscard]] ConformalParts round_parts(const RoundParameters &parameters);
// A bound on the error of r^2 due to rounding of the coefficients. Those of e4 and e5 hold 2 Q / R, about c^2 far from the
// origin, and their difference is the weight R; r^2 is a difference of squares.
[[nodiscard]] double squared_radius_rounding(const ConformalParts &parts, const RoundParameters &parameters);
// The parameters of a flat of grade k + 2: the point nearest to the origin, p = Q F^-1, and the attitude. D must not be zero.
struct FlatParameters {
	Vector3<double> foot;
	Multivector attitude;
};
[[nodiscard]] FlatParameters flat_parameters(const ConformalParts &parts, int k);

// `attitude` is a Euclidean blade of grade 0..3; a negative squared radius makes an imaginary round.
[[nodiscard]] Multivector round_blade(const Vector3<double> &center, const Multivector &attitude, double squared_radius);
// `attitude` is a Euclidean blade of grade 0..2.
[[nodiscard]] Multivector flat_blade(const Vector3<double> &position, const Multivector &attitude);

// The Euclidean bivector n I3 orthogonal to a vector n, right-handed (e12 for e3), and the vector of a bivector.
[[nodiscard]] Multivector plane_across(const Vector3<double> &normal);
[[nodiscard]] Vector3<double> normal_of(const Multivector &bivector);
// The coefficients of e1, e2, e3.
[[nodiscard]] Vector3<double> vector_of(const Multivector &x);

} // namespace cga
