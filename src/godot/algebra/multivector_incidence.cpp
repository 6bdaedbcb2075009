#include "godot/algebra/multivector.hpp"

#include "cga/object/incidence.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

// What two objects have to do with each other.

namespace ga_godot {

using godot::vformat;

Multivector::Handle Multivector::binary(BinaryFunction p_function, const Handle &p_other, const char *p_method) const {
	ERR_FAIL_COND_V_MSG(p_other.is_null(), Handle(), vformat("Multivector.%s: the other multivector is null.", p_method));
	return make(p_function(_value, p_other->_value), p_method);
}

Multivector::Handle Multivector::meet(const Handle &p_other) const {
	return binary(&cga::meet, p_other, "meet");
}

Multivector::Handle Multivector::join(const Handle &p_other) const {
	return binary(&cga::join, p_other, "join");
}

Multivector::Handle Multivector::project_onto(const Handle &p_onto) const {
	return binary(&cga::project_onto, p_onto, "project_onto");
}

Multivector::Handle Multivector::reject_from(const Handle &p_from) const {
	return binary(&cga::reject_from, p_from, "reject_from");
}

Multivector::Handle Multivector::reflect_in(const Handle &p_mirror) const {
	return binary(&cga::reflect_in, p_mirror, "reflect_in");
}

} // namespace ga_godot
