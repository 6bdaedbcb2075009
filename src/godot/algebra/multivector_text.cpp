#include "godot/algebra/multivector.hpp"

#include "cga/text/json.hpp"
#include "cga/text/text.hpp"
#include "godot/algebra/conversions.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

// Multivectors as text, written and read.

namespace ga_godot {

using godot::String;
using godot::vformat;

String Multivector::to_text(bool p_null_basis) const {
	return ga_godot::to_godot(cga::to_text(_value, p_null_basis));
}

String Multivector::to_latex() const {
	return ga_godot::to_godot(cga::to_latex(_value));
}

String Multivector::to_json() const {
	return ga_godot::to_godot(cga::to_json(_value));
}

Multivector::Handle Multivector::from_json(const String &p_text) {
	const cga::TextResult<cga::Multivector> value = cga::from_json(to_utf8(p_text));
	ERR_FAIL_COND_V_MSG(!value, Handle(), vformat("Multivector.from_json: %s.", ga_godot::to_godot(value.error().describe())));
	return make(*value);
}

} // namespace ga_godot
