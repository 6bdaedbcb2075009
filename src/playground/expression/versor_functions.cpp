#include "playground/expression/function_table.hpp"

#include "cga/motor/axis_angle.hpp"
#include "cga/motor/motor_factors.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "cga/versor/exponential.hpp"
#include "cga/versor/logarithm.hpp"
#include "cga/versor/power.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace playground {

namespace {

using cga::Failure;
using cga::Multivector;
using cga::Pose;
using cga::Quaternion;
using cga::Vector3;

constexpr const char *NO_MOTOR = "Expected a motor: a product of translators, rotors and dilators";

double largest(double a, double b, double c) {
	return std::max({ std::abs(a), std::abs(b), std::abs(c) });
}

Outcome rotor_of_axis(const Arguments &arguments) {
	const Vector3<double> axis = arguments.vector(0);
	const double angle = arguments.number(1);
	const double size = largest(axis.x, axis.y, axis.z);
	if (size == 0.0) {
		return Failure{ "The axis has length zero; give a direction" };
	}
	// Brought near 1 first, so that squares neither overflow nor vanish.
	const Vector3<double> sines = glm::normalize(axis / size) * std::sin(0.5 * angle);
	return cga::rotor({ std::cos(0.5 * angle), sines.x, sines.y, sines.z });
}

// In the order of Godot's Quaternion(x, y, z, w).
Outcome rotor_of_quaternion(const Arguments &arguments) {
	const Vector3<double> imaginary = arguments.numbers(0);
	const double real = arguments.number(3);
	const double size = std::max(largest(imaginary.x, imaginary.y, imaginary.z), std::abs(real));
	if (size == 0.0) {
		return Failure{ "A quaternion of length zero is no rotation" };
	}
	return cga::rotor(glm::normalize(Quaternion<double>(real / size, imaginary.x / size, imaginary.y / size, imaginary.z / size)));
}

Outcome dilator(const Arguments &arguments) {
	if (!(arguments.number(0) > 0.0)) {
		return Failure{ "The scale must be above 0" };
	}
	return cga::dilator(arguments.number(0));
}

// T R D
Outcome motor(const Vector3<double> &translation, const Quaternion<double> &rotation, double scale) {
	if (!(scale > 0.0)) {
		return Failure{ "The scale must be above 0" };
	}
	return cga::to_multivector(cga::Motor<double>::from_pose({ translation, rotation, scale }));
}

Outcome rigid_motor(const Arguments &arguments) {
	return motor(arguments.vector(0), arguments.rotation(1), 1.0);
}

Outcome scaled_motor(const Arguments &arguments) {
	return motor(arguments.vector(0), arguments.rotation(1), arguments.number(2));
}

// What `part` takes from the pose of a motor.
template <class Part>
Outcome of_pose(const Multivector &x, Part part) {
	const std::optional<cga::Motor<double>> motor = cga::to_motor(x);
	const std::optional<Pose<double>> pose = motor ? motor->to_pose() : std::nullopt;
	if (!pose) {
		return Failure{ NO_MOTOR };
	}
	return part(*pose);
}

Outcome transform_point(const Arguments &arguments) {
	const std::optional<cga::Motor<double>> motor = cga::to_motor(arguments[0]);
	if (!motor) {
		return Failure{ NO_MOTOR };
	}
	return cga::euclidean(motor->transform_point(arguments.location(1)));
}

Outcome sandwich(const Arguments &arguments) {
	const std::optional<Multivector> moved = arguments[0].sandwich(arguments[1]);
	if (!moved) {
		return Failure{ "Expected a versor: a product of vectors that has an inverse" };
	}
	return *moved;
}

constexpr Overload TABLE[] = {
	{ "translator", "offset", 1, { V }, [](const Arguments &a) -> Outcome { return cga::translator(a.vector(0)); }, "moves by a vector" },
	{ "translator", "x, y, z", 3, { N, N, N }, [](const Arguments &a) -> Outcome { return cga::translator(a.numbers(0)); }, "moves by (x, y, z)" },
	{ "rotor", "axis, angle", 2, { V, N }, rotor_of_axis, "turns about an axis through the origin, by radians, right-handed" },
	{ "rotor", "x, y, z, w", 4, { N, N, N, N }, rotor_of_quaternion, "turns by a quaternion, in the order of Godot's Quaternion" },
	{ "dilator", "scale", 1, { N }, dilator, "scales about the origin" },
	{ "motor", "translation, rotor", 2, { V, R }, rigid_motor, "turns, then moves" },
	{ "motor", "translation, rotor, scale", 3, { V, R, N }, scaled_motor, "scales, then turns, then moves" },
	{ "motor_from", "translation, rotor, scale", 3, { V, R, N }, scaled_motor, "the same as motor" },

	{ "exp", "x", 1, { X }, [](const Arguments &a) { return cga::exp(a[0]); }, "exponential; of a bivector a versor" },
	{ "log", "versor", 1, { X }, [](const Arguments &a) { return cga::log(a[0]); }, "logarithm of a versor, the short way round" },
	{ "sqrt", "versor", 1, { X }, [](const Arguments &a) { return cga::sqrt(a[0]); }, "half of a versor's motion" },
	{ "power", "versor, exponent", 2, { X, N }, [](const Arguments &a) { return cga::power(a[0], a.number(1)); }, "a part or a multiple of a versor's motion" },

	{ "sandwich", "versor, x", 2, { X, X }, sandwich, "the versor applied to x: M x / M, with the sign right for odd versors" },
	{ "transform_point", "motor, point", 2, { X, P }, transform_point, "where a motor carries a point, as a vector" },
	{ "get_translation", "motor", 1, { X }, [](const Arguments &a) { return of_pose(a[0], [](const Pose<double> &pose) -> Outcome { return cga::euclidean(pose.translation); }); }, "the translation of a motor, as a vector" },
	{ "get_rotation", "motor", 1, { X }, [](const Arguments &a) { return of_pose(a[0], [](const Pose<double> &pose) -> Outcome { return cga::rotor(pose.rotation); }); }, "the rotation of a motor, as a rotor" },
	{ "get_scale", "motor", 1, { X }, [](const Arguments &a) { return of_pose(a[0], [](const Pose<double> &pose) { return number(pose.scale); }); }, "the scale of a motor, a number" },
};

} // namespace

FunctionTable versor_functions() {
	return { TABLE, std::size(TABLE) };
}

} // namespace playground
