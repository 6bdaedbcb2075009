#include "godot/algebra/conversions.hpp"
#include "godot/playground/ga_scene.hpp"
#include "playground/document/parameters.hpp"
#include "playground/handles/drag.hpp"
#include "playground/handles/handles.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/packed_float64_array.hpp>
#include <godot_cpp/variant/quaternion.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

// Parameters of free objects, and the handles that change them in a viewport.

namespace ga_godot {

using godot::Dictionary;
using godot::Error;
using godot::PackedFloat64Array;
using godot::Quaternion;
using godot::String;
using godot::Variant;
using godot::Vector3;
using godot::vformat;
using playground::LiteralValue;
using playground::handles::Handle;
using playground::handles::Motion;

static Variant to_variant(const LiteralValue &value) {
	if (const double *number = std::get_if<double>(&value)) {
		return *number;
	}
	if (const cga::Vector3<double> *vector = std::get_if<cga::Vector3<double>>(&value)) {
		return to_godot(*vector);
	}
	if (const cga::Quaternion<double> *rotation = std::get_if<cga::Quaternion<double>>(&value)) {
		return to_godot(*rotation);
	}
	const cga::Multivector::Coefficients &coefficients = std::get_if<cga::Multivector>(&value)->coefficients();
	PackedFloat64Array numbers;
	numbers.resize(cga::BLADE_COUNT);
	std::copy(coefficients.begin(), coefficients.end(), numbers.ptrw());
	return numbers;
}

// Empty for types that cannot be a parameter, and for arrays that do not have 32 coefficients.
static std::optional<LiteralValue> to_literal(const Variant &value) {
	switch (value.get_type()) {
		case Variant::INT:
		case Variant::FLOAT:
			return LiteralValue(double(value));
		case Variant::VECTOR3: {
			const Vector3 vector = value;
			return LiteralValue(to_glm(vector));
		}
		case Variant::QUATERNION: {
			const Quaternion rotation = value;
			return LiteralValue(to_glm(rotation));
		}
		case Variant::PACKED_FLOAT64_ARRAY: {
			const PackedFloat64Array numbers = value;
			if (numbers.size() != cga::BLADE_COUNT) {
				return std::nullopt;
			}
			cga::Multivector multivector;
			for (int i = 0; i < cga::BLADE_COUNT; i++) {
				multivector[i] = numbers[i];
			}
			return LiteralValue(multivector);
		}
		case Variant::OBJECT: {
			const Multivector::Handle multivector = value;
			return multivector.is_valid() ? std::optional<LiteralValue>(multivector->get_value()) : std::nullopt;
		}
		default:
			return std::nullopt;
	}
}

// In the order of Motion.
static constexpr const char *MOTIONS[] = { "free", "line", "circle", "sphere" };

static Dictionary to_dictionary(const Handle &handle) {
	Dictionary dictionary;
	dictionary["key"] = to_godot(handle.key);
	dictionary["motion"] = MOTIONS[int(handle.constraint.motion)];
	dictionary["position"] = to_godot(handle.constraint.position);
	dictionary["center"] = to_godot(handle.constraint.center);
	dictionary["axis"] = to_godot(handle.constraint.axis);
	dictionary["stem"] = to_godot(handle.stem);
	dictionary["is_arm"] = handle.is_arm;
	dictionary["moves_body"] = handle.moves_body;
	dictionary["grab"] = Vector3();
	return dictionary;
}

// Empty if a key is missing or has a value that get_handles() cannot have returned.
static std::optional<Handle> to_handle(const Dictionary &dictionary) {
	Handle handle;
	const String key = dictionary.get("key", ""), motion = dictionary.get("motion", "");
	handle.key = to_utf8(key);
	const auto *const found = std::find_if(std::begin(MOTIONS), std::end(MOTIONS), [&motion](const char *name) { return motion == name; });
	if (found == std::end(MOTIONS)) {
		return std::nullopt;
	}
	handle.constraint.motion = Motion(found - std::begin(MOTIONS));
	bool is_complete = true;
	const auto read = [&dictionary, &is_complete](const char *name) {
		const Variant value = dictionary.get(name, Variant());
		const Vector3 vector = value.get_type() == Variant::VECTOR3 ? Vector3(value) : Vector3(NAN, NAN, NAN);
		is_complete = is_complete && is_finite(vector);
		return to_glm(vector);
	};
	handle.constraint.position = read("position");
	handle.constraint.center = read("center");
	handle.constraint.axis = read("axis");
	handle.stem = read("stem");
	handle.grab = read("grab");
	return is_complete ? std::optional<Handle>(handle) : std::nullopt;
}

Dictionary GAScene::get_parameters(const String &name) const {
	Dictionary parameters;
	if (const playground::Entry *entry = find(name, "get_parameters")) {
		for (const playground::Parameter &parameter : playground::parameters_of(entry->text)) {
			parameters[to_godot(parameter.name)] = to_variant(parameter.literal.value);
		}
	}
	return parameters;
}

Error GAScene::set_parameter(const String &name, const String &key, const Variant &value) {
	const std::optional<LiteralValue> literal = to_literal(value);
	ERR_FAIL_COND_V_MSG(!literal, godot::ERR_INVALID_PARAMETER, vformat("GAScene.set_parameter: the parameter \"%s\" must be a number, a Vector3, a Quaternion, a Multivector or a PackedFloat64Array of 32 coefficients, not %s.", to_godot(cga::shortened(to_utf8(key))), Variant::get_type_name(value.get_type())));
	return finish(_document.set_parameter(to_utf8(name), to_utf8(key), *literal), "set_parameter");
}

godot::TypedArray<Dictionary> GAScene::get_handles(const String &name, const Vector3 &right) const {
	godot::TypedArray<Dictionary> handles;
	if (const playground::Entry *entry = find(name, "get_handles")) {
		for (const Handle &handle : playground::handles::handles_of(_document, entry->name, to_glm(right))) {
			handles.push_back(to_dictionary(handle));
		}
	}
	return handles;
}

Error GAScene::drag_handle(const String &name, const Dictionary &handle, const Vector3 &ray_origin, const Vector3 &ray_direction, const Vector3 &view, double step, double angle_step) {
	const playground::Entry *entry = find(name, "drag_handle");
	if (!entry) {
		return godot::ERR_INVALID_PARAMETER;
	}
	const std::optional<Handle> start = to_handle(handle);
	ERR_FAIL_COND_V_MSG(!start, godot::ERR_INVALID_PARAMETER, "GAScene.drag_handle: the handle must be a dictionary from get_handles(), with all of its keys.");
	ERR_FAIL_COND_V_MSG(!std::isfinite(step) || !std::isfinite(angle_step) || step < 0.0 || angle_step < 0.0, godot::ERR_INVALID_PARAMETER, vformat("GAScene.drag_handle: step and angle_step must be finite and at least 0 (0 for no steps), not %f and %f.", step, angle_step));
	const std::optional<playground::handles::Drag> drag = playground::handles::drag(_document, entry->name, *start, { to_glm(ray_origin), to_glm(ray_direction), to_glm(view) }, { step, angle_step });
	if (!drag) {
		return godot::ERR_SKIP;
	}
	const playground::ChangeResult change = _document.set_parameter(entry->name, drag->parameter, drag->value);
	// No error message: a drag may reach invalid values, such as a negative radius, which the caller cannot avoid.
	return change ? finish(change, "drag_handle") : godot::ERR_SKIP;
}

} // namespace ga_godot
