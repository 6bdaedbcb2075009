#include "godot/algebra/conversions.hpp"
#include "godot/playground/ga_scene.hpp"
#include "playground/document/parameters.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/packed_float64_array.hpp>
#include <godot_cpp/variant/quaternion.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <algorithm>

// What can be dragged of free objects.

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

static Variant to_variant(const LiteralValue &p_value) {
	if (const double *number = std::get_if<double>(&p_value)) {
		return *number;
	}
	if (const cga::Vector3<double> *vector = std::get_if<cga::Vector3<double>>(&p_value)) {
		return to_godot(*vector);
	}
	if (const cga::Quaternion<double> *rotation = std::get_if<cga::Quaternion<double>>(&p_value)) {
		return to_godot(*rotation);
	}
	const cga::Multivector::Coefficients &coefficients = std::get_if<cga::Multivector>(&p_value)->coefficients();
	PackedFloat64Array numbers;
	numbers.resize(cga::BLADE_COUNT);
	std::copy(coefficients.begin(), coefficients.end(), numbers.ptrw());
	return numbers;
}

// False if a value of this type is no parameter.
static bool to_literal(const Variant &p_value, LiteralValue &r_value) {
	switch (p_value.get_type()) {
		case Variant::INT:
		case Variant::FLOAT:
			r_value = double(p_value);
			return true;
		case Variant::VECTOR3: {
			const Vector3 vector = p_value;
			r_value = to_glm(vector);
			return true;
		}
		case Variant::QUATERNION: {
			const Quaternion rotation = p_value;
			r_value = to_glm(rotation);
			return true;
		}
		case Variant::PACKED_FLOAT64_ARRAY: {
			const PackedFloat64Array numbers = p_value;
			cga::Multivector multivector;
			const bool is_complete = numbers.size() == cga::BLADE_COUNT;
			for (int i = 0; is_complete && i < cga::BLADE_COUNT; i++) {
				multivector[i] = numbers[i];
			}
			r_value = multivector;
			return is_complete;
		}
		case Variant::OBJECT: {
			const Multivector::Handle multivector = p_value;
			if (multivector.is_valid()) {
				r_value = multivector->get_value();
			}
			return multivector.is_valid();
		}
		default:
			return false;
	}
}

Dictionary GAScene::get_parameters(const String &p_name) const {
	Dictionary parameters;
	if (const playground::Entry *entry = find(p_name, "get_parameters")) {
		for (const playground::Parameter &parameter : playground::parameters_of(entry->text)) {
			parameters[to_godot(parameter.name)] = to_variant(parameter.literal.value);
		}
	}
	return parameters;
}

Error GAScene::set_parameter(const String &p_name, const String &p_key, const Variant &p_value) {
	LiteralValue value;
	ERR_FAIL_COND_V_MSG(!to_literal(p_value, value), godot::ERR_INVALID_PARAMETER, vformat("GAScene.set_parameter: a parameter is a number, a Vector3, a Quaternion, or a Multivector or its 32 coefficients as PackedFloat64Array; \"%s\" was given as %s.", p_key, Variant::get_type_name(p_value.get_type())));
	return finish(_document.set_parameter(to_utf8(p_name), to_utf8(p_key), value), "set_parameter");
}

} // namespace ga_godot
