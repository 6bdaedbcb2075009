#include "godot/algebra/multivector.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/variant.hpp>

// The methods and properties of Multivector, in the order of multivector.hpp.

namespace ga_godot {

void Multivector::_bind_methods() {
	using godot::ClassDB;
	using godot::D_METHOD;
	using godot::PropertyInfo;
	using godot::Variant;

	ClassDB::bind_method(D_METHOD("set_coefficients", "coefficients"), &Multivector::set_coefficients);
	ClassDB::bind_method(D_METHOD("get_coefficients"), &Multivector::get_coefficients);
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_FLOAT64_ARRAY, "coefficients"), "set_coefficients", "get_coefficients");

	ClassDB::bind_static_method("Multivector", D_METHOD("scalar", "value"), &Multivector::scalar);
	ClassDB::bind_static_method("Multivector", D_METHOD("basis_blade", "index"), &Multivector::basis_blade);
	ClassDB::bind_static_method("Multivector", D_METHOD("basis", "name"), &Multivector::basis);
	ClassDB::bind_static_method("Multivector", D_METHOD("point", "position"), &Multivector::point);
	ClassDB::bind_static_method("Multivector", D_METHOD("flat_point", "position"), &Multivector::flat_point);
	ClassDB::bind_static_method("Multivector", D_METHOD("point_pair", "a", "b"), &Multivector::point_pair);
	ClassDB::bind_static_method("Multivector", D_METHOD("line", "point", "direction"), &Multivector::line);
	ClassDB::bind_static_method("Multivector", D_METHOD("line_through", "a", "b"), &Multivector::line_through);
	ClassDB::bind_static_method("Multivector", D_METHOD("circle", "center", "normal", "radius"), &Multivector::circle);
	ClassDB::bind_static_method("Multivector", D_METHOD("circle_through", "a", "b", "c"), &Multivector::circle_through);
	ClassDB::bind_static_method("Multivector", D_METHOD("plane", "normal", "distance"), &Multivector::plane);
	ClassDB::bind_static_method("Multivector", D_METHOD("plane_through", "a", "b", "c"), &Multivector::plane_through);
	ClassDB::bind_static_method("Multivector", D_METHOD("sphere", "center", "radius"), &Multivector::sphere);
	ClassDB::bind_static_method("Multivector", D_METHOD("sphere_through", "a", "b", "c", "d"), &Multivector::sphere_through);
	ClassDB::bind_static_method("Multivector", D_METHOD("translator", "offset"), &Multivector::translator);
	ClassDB::bind_static_method("Multivector", D_METHOD("rotor", "quaternion"), &Multivector::rotor);
	ClassDB::bind_static_method("Multivector", D_METHOD("dilator", "scale"), &Multivector::dilator);
	ClassDB::bind_static_method("Multivector", D_METHOD("motor", "transform"), &Multivector::motor);
	ClassDB::bind_static_method("Multivector", D_METHOD("motor_from", "translation", "rotation", "scale"), &Multivector::motor_from);

	ClassDB::bind_static_method("Multivector", D_METHOD("evaluate", "expression", "variables"), &Multivector::evaluate, DEFVAL(godot::Dictionary()));
	ClassDB::bind_static_method("Multivector", D_METHOD("from_json", "text"), &Multivector::from_json);

	ClassDB::bind_method(D_METHOD("add", "other"), &Multivector::add);
	ClassDB::bind_method(D_METHOD("subtract", "other"), &Multivector::subtract);
	ClassDB::bind_method(D_METHOD("scaled", "factor"), &Multivector::scaled);
	ClassDB::bind_method(D_METHOD("geometric_product", "right"), &Multivector::geometric_product);
	ClassDB::bind_method(D_METHOD("outer_product", "right"), &Multivector::outer_product);
	ClassDB::bind_method(D_METHOD("inner_product", "right"), &Multivector::inner_product);
	ClassDB::bind_method(D_METHOD("left_contraction", "right"), &Multivector::left_contraction);
	ClassDB::bind_method(D_METHOD("right_contraction", "right"), &Multivector::right_contraction);
	ClassDB::bind_method(D_METHOD("regressive_product", "right"), &Multivector::regressive_product);
	ClassDB::bind_method(D_METHOD("commutator_product", "right"), &Multivector::commutator_product);
	ClassDB::bind_method(D_METHOD("scalar_product", "right"), &Multivector::scalar_product);
	ClassDB::bind_method(D_METHOD("sandwich", "x"), &Multivector::sandwich);

	ClassDB::bind_method(D_METHOD("meet", "other"), &Multivector::meet);
	ClassDB::bind_method(D_METHOD("join", "other"), &Multivector::join);
	ClassDB::bind_method(D_METHOD("project_onto", "onto"), &Multivector::project_onto);
	ClassDB::bind_method(D_METHOD("reject_from", "from"), &Multivector::reject_from);
	ClassDB::bind_method(D_METHOD("reflect_in", "mirror"), &Multivector::reflect_in);

	ClassDB::bind_method(D_METHOD("reverse"), &Multivector::reverse);
	ClassDB::bind_method(D_METHOD("grade_involution"), &Multivector::grade_involution);
	ClassDB::bind_method(D_METHOD("clifford_conjugate"), &Multivector::clifford_conjugate);
	ClassDB::bind_method(D_METHOD("dual"), &Multivector::dual);
	ClassDB::bind_method(D_METHOD("undual"), &Multivector::undual);
	ClassDB::bind_method(D_METHOD("grade", "k"), &Multivector::grade);

	ClassDB::bind_method(D_METHOD("norm"), &Multivector::norm);
	ClassDB::bind_method(D_METHOD("norm_squared"), &Multivector::norm_squared);
	ClassDB::bind_method(D_METHOD("normalized"), &Multivector::normalized);
	ClassDB::bind_method(D_METHOD("inverse"), &Multivector::inverse);
	ClassDB::bind_method(D_METHOD("exp"), &Multivector::exp);
	ClassDB::bind_method(D_METHOD("log"), &Multivector::log);
	ClassDB::bind_method(D_METHOD("sqrt"), &Multivector::sqrt);
	ClassDB::bind_method(D_METHOD("power", "exponent"), &Multivector::power);

	ClassDB::bind_method(D_METHOD("is_equal_approx", "other"), &Multivector::is_equal_approx);
	ClassDB::bind_method(D_METHOD("is_blade"), &Multivector::is_blade);
	ClassDB::bind_method(D_METHOD("is_versor"), &Multivector::is_versor);
	ClassDB::bind_method(D_METHOD("is_motor"), &Multivector::is_motor);

	ClassDB::bind_method(D_METHOD("to_transform"), &Multivector::to_transform);
	ClassDB::bind_method(D_METHOD("get_translation"), &Multivector::get_translation);
	ClassDB::bind_method(D_METHOD("get_rotation"), &Multivector::get_rotation);
	ClassDB::bind_method(D_METHOD("get_scale"), &Multivector::get_scale);
	ClassDB::bind_method(D_METHOD("transform_point", "point"), &Multivector::transform_point);

	ClassDB::bind_method(D_METHOD("classify", "ipns"), &Multivector::classify, DEFVAL(false));

	ClassDB::bind_method(D_METHOD("to_text", "null_basis"), &Multivector::to_text, DEFVAL(false));
	ClassDB::bind_method(D_METHOD("to_latex"), &Multivector::to_latex);
	ClassDB::bind_method(D_METHOD("to_json"), &Multivector::to_json);
}

} // namespace ga_godot
