#include "godot/algebra/multivector.hpp"

#include "cga/algebra/null_basis.hpp"
#include "godot/algebra/conversions.hpp"
#include "playground/expression/evaluate.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

// Multivectors computed from expressions.

namespace ga_godot {

using godot::Array;
using godot::Dictionary;
using godot::String;
using godot::Variant;
using godot::Vector3;
using godot::vformat;

// The multivector that a script's value stands for in an expression; false if it is none.
static bool value_of_variable(const Variant &p_variable, cga::Multivector &r_value) {
	switch (p_variable.get_type()) {
		case Variant::INT:
		case Variant::FLOAT:
			r_value = cga::Multivector::scalar(p_variable);
			return true;
		case Variant::VECTOR3:
			r_value = cga::euclidean(to_glm(Vector3(p_variable)));
			return true;
		case Variant::OBJECT: {
			const Multivector::Handle multivector = p_variable;
			if (multivector.is_valid()) {
				r_value = multivector->get_value();
			}
			return multivector.is_valid();
		}
		default:
			return false;
	}
}

Multivector::Handle Multivector::evaluate(const String &p_expression, const Dictionary &p_variables) {
	playground::Variables variables;
	const Array names = p_variables.keys();
	for (const Variant &name : names) {
		const Variant::Type type = name.get_type();
		ERR_FAIL_COND_V_MSG(type != Variant::STRING && type != Variant::STRING_NAME, Handle(), vformat("Multivector.evaluate: the name of a variable must be a string, not %s.", Variant::get_type_name(type)));
		const Variant variable = p_variables[name];
		cga::Multivector value;
		ERR_FAIL_COND_V_MSG(!value_of_variable(variable, value), Handle(), vformat("Multivector.evaluate: the variable \"%s\" must be a Multivector, a number or a Vector3, not %s.", name, Variant::get_type_name(variable.get_type())));
		variables.insert_or_assign(to_utf8(name), value);
	}
	const cga::TextResult<cga::Multivector> value = playground::evaluate(to_utf8(p_expression), variables);
	ERR_FAIL_COND_V_MSG(!value, Handle(), vformat("Multivector.evaluate: %s.", ga_godot::to_godot(value.error().describe())));
	return make(*value);
}

} // namespace ga_godot
