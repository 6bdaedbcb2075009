#include "cga/object/classify.hpp"

#include "cga/algebra/is_blade.hpp"
#include "cga/algebra/null_basis.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "cga/object/conformal_parts.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace cga {

namespace {

constexpr double EPSILON = std::numeric_limits<double>::epsilon();
// Parts at most this large, relative to the numbers they were computed from, are zero within rounding.
constexpr double ROUNDING = 64.0 * EPSILON;
// Parts of other grades below this are noise.
constexpr double NOISE = 1e-10;
// X ^ X below this is noise, which products and motions of distant objects accumulate.
constexpr double BLADE_NOISE = 1e-8;

using Vector = Vector3<double>;

void set_attitude(Classification &found, const Multivector &attitude, int grade) {
	if (grade == 1) {
		found.direction = glm::normalize(vector_of(attitude));
	} else if (grade == 2) {
		found.normal = glm::normalize(normal_of(attitude));
	}
}

Classification flat(const ConformalParts &parts, int grade) {
	const int k = grade - 2;
	const FlatParameters parameters = flat_parameters(parts, k);
	const Vector foot = parameters.foot;
	Classification found;
	set_attitude(found, parameters.attitude, k);
	if (k == 2) {
		found.kind = Kind::PLANE;
		found.distance = glm::dot(foot, *found.normal);
	} else {
		found.kind = k == 0 ? Kind::FLAT_POINT : Kind::LINE;
		found.center = foot;
	}
	return found;
}

Classification round(const ConformalParts &parts, int grade) {
	const int k = grade - 1;
	const RoundParameters parameters = round_parameters(parts, k);
	const Vector center = parameters.center();
	const double squared_radius = parameters.squared_radius();

	Classification found;
	found.center = center;
	set_attitude(found, parameters.attitude, k);
	if (std::abs(squared_radius) <= squared_radius_rounding(parts, parameters)) {
		// e_o + c + c^2/2 e_inf is a point; its dual, the sphere of radius zero, is one in IPNS.
		found.kind = k == 0 || k == 3 ? Kind::POINT : Kind::TANGENT;
		found.ipns = k == 3;
		return found;
	}
	constexpr Kind KIND_OF_K[] = { Kind::SPHERE, Kind::POINT_PAIR, Kind::CIRCLE, Kind::SPHERE };
	found.kind = KIND_OF_K[k];
	// A vector that is not null, e_o + c + (c^2 - r^2)/2 e_inf, is a sphere in IPNS.
	found.ipns = k == 0;
	found.imaginary = k == 0 ? squared_radius > 0.0 : squared_radius < 0.0;
	found.radius = std::sqrt(std::abs(squared_radius));
	if (k == 1 && !found.imaginary) {
		const Vector to_end = *found.direction * *found.radius;
		found.points = std::array<Vector, 2>{ center - to_end, center + to_end };
	}
	return found;
}

Classification flipped(Classification found) {
	found.ipns = !found.ipns;
	return found;
}

// Classifies an OPNS blade of grade 1 to 4.
Classification blade(const Multivector &x, int grade) {
	const ConformalParts parts = parts_of(x);
	const double a = parts.euclidean.max_abs(), q = parts.infinity.max_abs(), d = parts.both.max_abs();
	if (is_round(parts)) {
		return round(parts, grade);
	}
	const bool contains_infinity = a <= NOISE * d + ROUNDING * q; // e_inf ^ X = 0
	const bool is_orthogonal_to_infinity = d <= NOISE * a + ROUNDING * q; // e_inf . X = 0
	if (contains_infinity && is_orthogonal_to_infinity) {
		Classification found;
		found.kind = Kind::DIRECTION;
		set_attitude(found, parts.infinity, grade - 1);
		return found;
	}
	if (contains_infinity) {
		return flat(parts, grade);
	}
	if (is_orthogonal_to_infinity) {
		return flipped(flat(parts_of(x.undual()), DIMENSION - grade));
	}
	return {};
}

Kind kind_of(const Motor<double> &motor) {
	const std::optional<Pose<double>> pose = motor.to_pose();
	if (!pose) {
		return Kind::NONE;
	}
	const bool rotates = glm::length(vector_part(pose->rotation)) > ROUNDING;
	const bool translates = glm::length(pose->translation) > 0.0;
	const bool scales = std::abs(pose->scale - 1.0) > ROUNDING;
	if (int(rotates) + int(translates) + int(scales) > 1) {
		return Kind::MOTOR;
	}
	return rotates ? Kind::ROTOR : (scales ? Kind::DILATOR : Kind::TRANSLATOR);
}

} // namespace

Classification classify(const Multivector &x, bool ipns) {
	Classification found;
	found.ipns = ipns;
	if (!x.is_finite() || !(x.max_abs() > 0.0)) {
		return found;
	}
	const Multivector scaled = x.times_power_of_two(-std::ilogb(x.max_abs()));
	const std::optional<int> grade = single_grade(scaled, std::abs(scaled[0]) > 0.0 ? ROUNDING : NOISE);
	if (!grade) {
		const std::optional<Motor<double>> motor = to_motor(scaled);
		found.kind = motor ? kind_of(*motor) : Kind::NONE;
		if (found.kind == Kind::NONE) {
			double second = 0.0, first = 0.0;
			for (int k = 0; k <= DIMENSION; ++k) {
				const double size = scaled.grade(k).max_abs();
				second = std::max(second, std::min(first, size));
				first = std::max(first, size);
			}
			found.residual = second / first;
		}
		return found;
	}
	if (*grade == 0 || *grade == DIMENSION) {
		found.kind = (*grade == 0) != ipns ? Kind::SCALAR : Kind::NONE;
		return found;
	}
	const Multivector only = scaled.grade(*grade);
	const Multivector bivector = *grade == 3 ? only.dual() : only;
	const double residual = *grade == 2 || *grade == 3 ? bivector.outer_product(bivector).max_abs() / std::pow(only.max_abs(), 2.0) : 0.0;
	if (residual <= BLADE_NOISE) {
		found = ipns ? flipped(blade(only.undual(), DIMENSION - *grade)) : blade(only, *grade);
	}
	found.residual = residual;
	return found;
}

} // namespace cga
