#include "playground/document/describe_entry.hpp"

#include "cga/motor/axis_angle.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "cga/object/classify.hpp"
#include "cga/text/readable.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <optional>

namespace playground {

namespace {

constexpr double DEGREES = 180.0 / 3.14159265358979323846;
// Smaller angles and changes of scale are rounding errors.
constexpr double ROUNDING = 1e-9;

std::string motion(const cga::Pose<double> &pose) {
	std::string text;
	if (glm::length(pose.translation) > 0.0) {
		text += ", translation " + cga::readable(pose.translation);
	}
	const cga::AxisAngle<double> rotation = cga::short_axis_angle(pose.rotation);
	if (rotation.angle > 2.0 * ROUNDING) {
		text += ", " + cga::readable(rotation.angle * DEGREES) + " degrees about " + cga::readable(rotation.axis);
	}
	if (std::abs(pose.scale - 1.0) > ROUNDING) {
		text += ", scale " + cga::readable(pose.scale);
	}
	return text;
}

} // namespace

std::string describe(const Entry &entry) {
	if (!entry.value) {
		return "error: " + entry.value.error().message;
	}
	const cga::Multivector &value = *entry.value;
	// Zero represents no object, but a slider may produce it.
	if (value == cga::Multivector()) {
		return "number 0";
	}
	const cga::Classification found = cga::classify(value, is_set(entry.attributes, "ipns"));
	switch (found.kind) {
		case cga::Kind::SCALAR:
			return "number " + cga::readable(value[0]);
		case cga::Kind::ROTOR:
		case cga::Kind::TRANSLATOR:
		case cga::Kind::DILATOR:
		case cga::Kind::MOTOR: {
			const std::optional<cga::Motor<double>> motor = cga::to_motor(value);
			const std::optional<cga::Pose<double>> pose = motor ? motor->to_pose() : std::nullopt;
			return cga::name_of(found.kind) + (pose ? motion(*pose) : std::string());
		}
		default:
			return cga::describe(found);
	}
}

} // namespace playground
