#include "godot/algebra/multivector.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>
#include <optional>

// Sums, products, and what rearranges the grades.

namespace ga_godot {

using godot::vformat;

Multivector::Handle Multivector::binary(BinaryOperation p_operation, const Handle &p_right, const char *p_method) const {
	ERR_FAIL_COND_V_MSG(p_right.is_null(), Handle(), vformat("Multivector.%s: the other multivector is null.", p_method));
	return make((_value.*p_operation)(p_right->_value));
}

Multivector::Handle Multivector::add(const Handle &p_other) const {
	ERR_FAIL_COND_V_MSG(p_other.is_null(), Handle(), "Multivector.add: the other multivector is null.");
	return make(_value + p_other->_value);
}

Multivector::Handle Multivector::subtract(const Handle &p_other) const {
	ERR_FAIL_COND_V_MSG(p_other.is_null(), Handle(), "Multivector.subtract: the other multivector is null.");
	return make(_value - p_other->_value);
}

Multivector::Handle Multivector::scaled(double p_factor) const {
	ERR_FAIL_COND_V_MSG(!std::isfinite(p_factor), Handle(), "Multivector.scaled: the factor is not finite.");
	return make(_value * p_factor);
}

Multivector::Handle Multivector::geometric_product(const Handle &p_right) const {
	return binary(&cga::Multivector::geometric_product, p_right, "geometric_product");
}

Multivector::Handle Multivector::outer_product(const Handle &p_right) const {
	return binary(&cga::Multivector::outer_product, p_right, "outer_product");
}

Multivector::Handle Multivector::inner_product(const Handle &p_right) const {
	return binary(&cga::Multivector::inner_product, p_right, "inner_product");
}

Multivector::Handle Multivector::left_contraction(const Handle &p_right) const {
	return binary(&cga::Multivector::left_contraction, p_right, "left_contraction");
}

Multivector::Handle Multivector::right_contraction(const Handle &p_right) const {
	return binary(&cga::Multivector::right_contraction, p_right, "right_contraction");
}

Multivector::Handle Multivector::regressive_product(const Handle &p_right) const {
	return binary(&cga::Multivector::regressive_product, p_right, "regressive_product");
}

Multivector::Handle Multivector::commutator_product(const Handle &p_right) const {
	return binary(&cga::Multivector::commutator_product, p_right, "commutator_product");
}

double Multivector::scalar_product(const Handle &p_right) const {
	ERR_FAIL_COND_V_MSG(p_right.is_null(), 0.0, "Multivector.scalar_product: the other multivector is null.");
	const double product = _value.scalar_product(p_right->_value);
	ERR_FAIL_COND_V_MSG(!std::isfinite(product), 0.0, "Multivector.scalar_product: the result is beyond the range of 64-bit floats.");
	return product;
}

Multivector::Handle Multivector::sandwich(const Handle &p_x) const {
	ERR_FAIL_COND_V_MSG(p_x.is_null(), Handle(), "Multivector.sandwich: the multivector to transform is null.");
	const std::optional<cga::Multivector> image = _value.sandwich(p_x->_value);
	ERR_FAIL_COND_V_MSG(!image, Handle(), "Multivector.sandwich: this multivector is no versor (even or odd, with an inverse), so it transforms nothing.");
	return make(*image);
}

Multivector::Handle Multivector::reverse() const {
	return make(_value.reverse());
}

Multivector::Handle Multivector::grade_involution() const {
	return make(_value.grade_involution());
}

Multivector::Handle Multivector::clifford_conjugate() const {
	return make(_value.clifford_conjugate());
}

Multivector::Handle Multivector::dual() const {
	return make(_value.dual());
}

Multivector::Handle Multivector::undual() const {
	return make(_value.undual());
}

Multivector::Handle Multivector::grade(int64_t p_grade) const {
	ERR_FAIL_COND_V_MSG(p_grade < 0 || p_grade > 5, Handle(), vformat("Multivector.grade: grade %d is not in 0..5.", p_grade));
	return make(_value.grade(int(p_grade)));
}

} // namespace ga_godot
