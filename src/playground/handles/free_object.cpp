#include "playground/handles/free_object.hpp"

#include "cga/algebra/null_basis.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "playground/expression/functions.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace playground::handles {

std::optional<FreeObject> FreeObject::find(const Document &document, std::string_view name) {
	const Entry *entry = document.find(name);
	return entry && entry->value ? std::optional<FreeObject>(FreeObject(document, *entry)) : std::nullopt;
}

FreeObject::FreeObject(const Document &document, const Entry &entry) :
		_document(&document), _parameters(parameters_of(entry.text)), _arguments(arguments_of(entry.text)), _classification(cga::classify(*entry.value, is_set(entry.attributes, "ipns"))) {
	const std::optional<cga::Motor<double>> motor = cga::to_motor(*entry.value);
	_pose = motor ? motor->to_pose() : std::nullopt;
	if (_pose && !matches_parameters(*_pose)) {
		_pose.reset();
	}
}

const LiteralValue *FreeObject::literal(std::string_view parameter) const {
	const auto found = std::find_if(_parameters.begin(), _parameters.end(), [parameter](const Parameter &candidate) { return candidate.name == parameter; });
	return found == _parameters.end() ? nullptr : &found->literal.value;
}

bool FreeObject::has_argument(std::string_view name) const {
	return std::any_of(_arguments.begin(), _arguments.end(), [name](const Argument &argument) { return argument.name == name; });
}

std::optional<cga::Multivector> FreeObject::computed(std::string_view name) const {
	for (const Argument &argument : _arguments) {
		if (argument.name == name) {
			const cga::TextResult<cga::Multivector> value = _document->evaluate(argument.text);
			return value ? std::optional<cga::Multivector>(*value) : std::nullopt;
		}
	}
	return std::nullopt;
}

std::optional<Vector> FreeObject::vector(std::string_view name) const {
	if (const LiteralValue *value = literal(name)) {
		const Vector *vector = std::get_if<Vector>(value);
		return vector ? std::optional<Vector>(*vector) : std::nullopt;
	}
	const std::optional<cga::Multivector> value = computed(name);
	if (!value) {
		return std::nullopt;
	}
	return is_of_kind(*value, ArgumentKind::VECTOR) ? std::optional<Vector>(Vector((*value)[1], (*value)[2], (*value)[3])) : cga::position_of(*value);
}

std::optional<double> FreeObject::number(std::string_view name) const {
	if (const LiteralValue *value = literal(name)) {
		const double *number = std::get_if<double>(value);
		return number ? std::optional<double>(*number) : std::nullopt;
	}
	const std::optional<cga::Multivector> value = computed(name);
	return value && is_of_kind(*value, ArgumentKind::NUMBER) ? std::optional<double>((*value)[0]) : std::nullopt;
}

const cga::Quaternion<double> *FreeObject::rotation() const {
	return std::get_if<cga::Quaternion<double>>(literal("rotation"));
}

const cga::Multivector *FreeObject::coefficients() const {
	return std::get_if<cga::Multivector>(literal("coefficients"));
}

bool FreeObject::matches_parameters(const cga::Pose<double> &pose) const {
	constexpr double TOLERANCE = 1e-6;
	const std::optional<Vector> offset = can_set("offset") ? vector("offset") : (can_set("translation") ? vector("translation") : std::nullopt);
	if (offset && glm::distance(*offset, pose.translation) > TOLERANCE * (1.0 + glm::length(*offset))) {
		return false;
	}
	const cga::Quaternion<double> *literal_rotation = rotation();
	if (literal_rotation && std::abs(glm::dot(glm::normalize(*literal_rotation), pose.rotation)) < 1.0 - TOLERANCE) {
		return false;
	}
	const std::optional<double> scale = number("scale");
	return !scale || std::abs(*scale - pose.scale) <= TOLERANCE * pose.scale;
}

} // namespace playground::handles
