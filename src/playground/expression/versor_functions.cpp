#include "playground/expression/function_table.hpp"

#include "cga/motor/interpolate.hpp"
#include "cga/motor/motor_factors.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "cga/text/readable.hpp"
#include "cga/versor/exponential.hpp"
#include "cga/versor/logarithm.hpp"
#include "cga/versor/power.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace playground {

namespace {

using cga::Multivector;
using cga::Pose;
using cga::Quaternion;
using cga::Vector3;

constexpr const char *NOT_A_MOTOR = "expected a motor (a product of translators, rotors and dilators)";

double largest(double a, double b, double c) {
	return std::max({ std::abs(a), std::abs(b), std::abs(c) });
}

Error scale_error(double scale) {
	return "the scale must be above 0, not " + cga::readable(scale);
}

FunctionResult rotor_of_axis(const Arguments &arguments) {
	const Vector3<double> axis = arguments.vector(0);
	const double angle = arguments.number(1);
	const double size = largest(axis.x, axis.y, axis.z);
	if (size == 0.0) {
		return Error("the axis is zero; pass a vector of any other length");
	}
	// Scaled first, so that the squares neither overflow nor underflow.
	const Vector3<double> sines = glm::normalize(axis / size) * std::sin(0.5 * angle);
	return cga::rotor({ std::cos(0.5 * angle), sines.x, sines.y, sines.z });
}

// Takes the components in the order of Godot's Quaternion(x, y, z, w).
FunctionResult rotor_of_quaternion(const Arguments &arguments) {
	const Vector3<double> imaginary = arguments.numbers(0);
	const double real = arguments.number(3);
	const double size = std::max(largest(imaginary.x, imaginary.y, imaginary.z), std::abs(real));
	if (size == 0.0) {
		return Error("the quaternion is zero; use (0, 0, 0, 1) for no rotation");
	}
	return cga::rotor(glm::normalize(Quaternion<double>(real / size, imaginary.x / size, imaginary.y / size, imaginary.z / size)));
}

FunctionResult dilator(const Arguments &arguments) {
	const double scale = arguments.number(0);
	if (!(scale > 0.0)) {
		return scale_error(scale);
	}
	return cga::dilator(scale);
}

// T R D
FunctionResult motor(const Vector3<double> &translation, const Quaternion<double> &rotation, double scale) {
	if (!(scale > 0.0)) {
		return scale_error(scale);
	}
	return cga::to_multivector(cga::Motor<double>::from_pose({ translation, rotation, scale }));
}

FunctionResult rigid_motor(const Arguments &arguments) {
	return motor(arguments.vector(0), arguments.rotation(1), 1.0);
}

FunctionResult scaled_motor(const Arguments &arguments) {
	return motor(arguments.vector(0), arguments.rotation(1), arguments.number(2));
}

// `part` of the pose of a motor.
template <class Part>
FunctionResult of_pose(const Multivector &x, Part part) {
	const std::optional<cga::Motor<double>> motor = cga::to_motor(x);
	const std::optional<Pose<double>> pose = motor ? motor->to_pose() : std::nullopt;
	if (!pose) {
		return Error(NOT_A_MOTOR);
	}
	return part(*pose);
}

FunctionResult transform_point(const Arguments &arguments) {
	const std::optional<cga::Motor<double>> motor = cga::to_motor(arguments[0]);
	if (!motor) {
		return Error(NOT_A_MOTOR);
	}
	return cga::euclidean(motor->transform_point(arguments.location(1)));
}

FunctionResult sandwich(const Arguments &arguments) {
	const std::optional<Multivector> moved = arguments[0].sandwich(arguments[1]);
	if (!moved) {
		return Error("expected a versor (a product of non-null vectors)");
	}
	return *moved;
}

// Normalizes to unit weight, as MultivectorLerp.interpolate does.
template <cga::Mode MODE>
FunctionResult interpolate(const Arguments &arguments) {
	const Pose<double> pose = cga::interpolate(arguments.pose(0), arguments.pose(1), arguments.number(2), MODE);
	return cga::to_multivector(cga::Motor<double>::from_pose(pose));
}

constexpr Overload TABLE[] = {
	{ "translator", "offset", 1, { V }, [](const Arguments &a) -> FunctionResult { return cga::translator(a.vector(0)); }, "translates by a vector" },
	{ "translator", "x, y, z", 3, { N, N, N }, [](const Arguments &a) -> FunctionResult { return cga::translator(a.numbers(0)); }, "translates by (x, y, z)" },
	{ "rotor", "axis, angle", 2, { V, N }, rotor_of_axis, "rotates about an axis through the origin by an angle in radians, right-handed" },
	{ "rotor", "x, y, z, w", 4, { N, N, N, N }, rotor_of_quaternion, "rotates by a quaternion, in the order of Godot's Quaternion" },
	{ "dilator", "scale", 1, { N }, dilator, "scales about the origin" },
	{ "motor", "translation, rotor", 2, { V, R }, rigid_motor, "rotates, then translates" },
	{ "motor", "translation, rotor, scale", 3, { V, R, N }, scaled_motor, "scales, then rotates, then translates" },
	{ "motor_from", "translation, rotor, scale", 3, { V, R, N }, scaled_motor, "as motor" },

	{ "exp", "x", 1, { X }, [](const Arguments &a) -> FunctionResult { return cga::exp(a[0]); }, "the exponential; of a bivector, a versor" },
	{ "log", "versor", 1, { X }, [](const Arguments &a) -> FunctionResult { return cga::log(a[0]); }, "the logarithm of a versor, by the shorter rotation" },
	{ "sqrt", "versor", 1, { X }, [](const Arguments &a) -> FunctionResult { return cga::sqrt(a[0]); }, "the versor of half the motion" },
	{ "power", "versor, exponent", 2, { X, N }, [](const Arguments &a) -> FunctionResult { return cga::power(a[0], a.number(1)); }, "the versor of a fraction or a multiple of the motion" },

	{ "sandwich", "versor, x", 2, { X, X }, sandwich, "x transformed by a versor: M x / M, with the sign corrected for odd versors" },
	{ "transform_point", "motor, point", 2, { X, P }, transform_point, "the image of a point under a motor, as a vector" },
	{ "get_translation", "motor", 1, { X }, [](const Arguments &a) -> FunctionResult { return of_pose(a[0], [](const Pose<double> &pose) -> FunctionResult { return cga::euclidean(pose.translation); }); }, "the translation of a motor, as a vector" },
	{ "get_rotation", "motor", 1, { X }, [](const Arguments &a) -> FunctionResult { return of_pose(a[0], [](const Pose<double> &pose) -> FunctionResult { return cga::rotor(pose.rotation); }); }, "the rotation of a motor, as a rotor" },
	{ "get_scale", "motor", 1, { X }, [](const Arguments &a) -> FunctionResult { return of_pose(a[0], [](const Pose<double> &pose) { return number(pose.scale); }); }, "the scale of a motor, a number" },

	{ "interpolate_linear", "from, to, t", 3, { M, M, N }, interpolate<cga::Mode::LINEAR>, "blends the coefficients of two motors, and the scale separately; t in 0..1" },
	{ "interpolate_screw", "from, to, t", 3, { M, M, N }, interpolate<cga::Mode::SCREW>, "the fraction or multiple t of the screw motion between two motors" },
	{ "interpolate_separate", "from, to, t", 3, { M, M, N }, interpolate<cga::Mode::SEPARATE>, "blends translation, rotation and scale of two motors separately; t in 0..1" },
};

} // namespace

FunctionTable versor_functions() {
	return { TABLE, std::size(TABLE) };
}

} // namespace playground
