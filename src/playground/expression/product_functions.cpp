#include "playground/expression/function_table.hpp"

#include "cga/algebra/is_blade.hpp"
#include "cga/algebra/null_basis.hpp"
#include "cga/text/readable.hpp"
#include "cga/versor/inverse.hpp"
#include "cga/versor/is_versor.hpp"
#include "cga/versor/normalized.hpp"

#include <cmath>

namespace playground {

namespace {

using cga::Multivector;

template <Multivector (Multivector::*METHOD)() const>
FunctionResult unary(const Arguments &arguments) {
	return (arguments[0].*METHOD)();
}

template <Multivector (Multivector::*METHOD)(const Multivector &) const>
FunctionResult binary(const Arguments &arguments) {
	return (arguments[0].*METHOD)(arguments[1]);
}

// An integer in 0..last; empty for other numbers.
std::optional<int> integer(double value, int last) {
	return value == std::floor(value) && value >= 0.0 && value <= last ? std::optional<int>(int(value)) : std::nullopt;
}

FunctionResult grade(const Arguments &arguments) {
	const std::optional<int> k = integer(arguments.number(1), cga::DIMENSION);
	if (!k) {
		return Error("the grade must be an integer in 0..5, not " + cga::readable(arguments.number(1)));
	}
	return arguments[0].grade(*k);
}

FunctionResult basis_blade(const Arguments &arguments) {
	const std::optional<int> index = integer(arguments.number(0), cga::BLADE_COUNT - 1);
	if (!index) {
		return Error("the index of a basis blade must be an integer in 0..31, not " + cga::readable(arguments.number(0)));
	}
	return Multivector::basis_blade(*index);
}

constexpr Overload TABLE[] = {
	{ "scalar", "value", 1, { N }, [](const Arguments &a) { return number(a.number(0)); }, "the number value" },
	{ "basis_blade", "index", 1, { N }, basis_blade, "the basis blade with an index in 0..31" },
	{ "vector", "x, y, z", 3, { N, N, N }, [](const Arguments &a) -> FunctionResult { return cga::euclidean(a.numbers(0)); }, "x e1 + y e2 + z e3" },

	{ "add", "x, y", 2, { X, X }, [](const Arguments &a) -> FunctionResult { return a[0] + a[1]; }, "x + y" },
	{ "subtract", "x, y", 2, { X, X }, [](const Arguments &a) -> FunctionResult { return a[0] - a[1]; }, "x - y" },
	{ "scaled", "x, factor", 2, { X, N }, [](const Arguments &a) -> FunctionResult { return a[0] * a.number(1); }, "x * factor" },
	{ "geometric_product", "x, y", 2, { X, X }, binary<&Multivector::geometric_product>, "x * y" },
	{ "outer_product", "x, y", 2, { X, X }, binary<&Multivector::outer_product>, "x ^ y" },
	{ "inner_product", "x, y", 2, { X, X }, binary<&Multivector::inner_product>, "x | y" },
	{ "left_contraction", "x, y", 2, { X, X }, binary<&Multivector::left_contraction>, "x << y" },
	{ "right_contraction", "x, y", 2, { X, X }, binary<&Multivector::right_contraction>, "x >> y" },
	{ "regressive_product", "x, y", 2, { X, X }, binary<&Multivector::regressive_product>, "x & y" },
	{ "commutator_product", "x, y", 2, { X, X }, binary<&Multivector::commutator_product>, "(x * y - y * x) / 2" },
	{ "scalar_product", "x, y", 2, { X, X }, [](const Arguments &a) { return number(a[0].scalar_product(a[1])); }, "the scalar part of x * y" },

	{ "reverse", "x", 1, { X }, unary<&Multivector::reverse>, "~x: grades 2 and 3 change sign" },
	{ "grade_involution", "x", 1, { X }, unary<&Multivector::grade_involution>, "odd grades change sign" },
	{ "clifford_conjugate", "x", 1, { X }, unary<&Multivector::clifford_conjugate>, "grades 1, 2 and 5 change sign" },
	{ "dual", "x", 1, { X }, unary<&Multivector::dual>, "!x, which is x / I" },
	{ "undual", "x", 1, { X }, unary<&Multivector::undual>, "x * I, the inverse of dual" },
	{ "grade", "x, k", 2, { X, N }, grade, "the part of grade k, in 0..5" },
	{ "inverse", "x", 1, { X }, [](const Arguments &a) -> FunctionResult { return cga::inverse(a[0]); }, "1 / x" },
	{ "norm", "x", 1, { X }, [](const Arguments &a) { return number(a[0].norm()); }, "sqrt(abs(norm_squared(x)))" },
	{ "norm_squared", "x", 1, { X }, [](const Arguments &a) { return number(a[0].norm_squared()); }, "the scalar part of x * ~x; it may be negative" },
	{ "normalized", "x", 1, { X }, [](const Arguments &a) -> FunctionResult { return cga::normalized(a[0]); }, "x scaled to norm 1" },
	{ "normalize", "x", 1, { X }, [](const Arguments &a) -> FunctionResult { return cga::normalized(a[0]); }, "as normalized" },

	{ "is_equal_approx", "x, y", 2, { X, X }, [](const Arguments &a) { return truth(a[0].is_equal_approx(a[1])); }, "1 if all coefficients agree to 1e-9, else 0" },
	{ "is_blade", "x", 1, { X }, [](const Arguments &a) { return truth(cga::is_blade(a[0])); }, "1 if x is an outer product of vectors, else 0" },
	{ "is_versor", "x", 1, { X }, [](const Arguments &a) { return truth(cga::is_versor(a[0])); }, "1 if x is a geometric product of vectors with an inverse, else 0" },
	{ "is_motor", "x", 1, { X }, [](const Arguments &a) { return truth(cga::is_motor(a[0])); }, "1 if x is a motor, else 0" },
};

} // namespace

FunctionTable product_functions() {
	return { TABLE, std::size(TABLE) };
}

} // namespace playground
