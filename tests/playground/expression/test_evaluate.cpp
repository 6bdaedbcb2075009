#include "playground/expression/evaluate.hpp"

#include "../../cga/random_poses.hpp"
#include "cga/text/text.hpp"
#include "playground/expression/parser.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace playground;
using cga::Multivector;
using cga_test::Random;

namespace {

std::string error_of(std::string_view text, const Variables &variables = {}) {
	const cga::TextResult<Multivector> result = evaluate(text, variables);
	return result ? "no error: " + cga::to_text(*result) : result.error().describe();
}

} // namespace

TEST_CASE("each operator computes its product or sign") {
	Random random(1);
	for (int repeat = 0; repeat < 200; ++repeat) {
		const Multivector a = random.multivector();
		const Multivector b = random.multivector();
		const Variables variables = { { "a", a }, { "b", b } };
		const auto value = [&variables](std::string_view text) { return *evaluate(text, variables); };
		CHECK(value("a + b") == a + b);
		CHECK(value("a - b") == a - b);
		CHECK(value("a * b") == a.geometric_product(b));
		CHECK(value("a ^ b") == a.outer_product(b));
		CHECK(value("a | b") == a.inner_product(b));
		CHECK(value("a << b") == a.left_contraction(b));
		CHECK(value("a >> b") == a.right_contraction(b));
		CHECK(value("a & b") == a.regressive_product(b));
		CHECK(value("~a") == a.reverse());
		CHECK(value("!a") == a.dual());
		CHECK(value("-a") == -a);
		CHECK(value("+a") == a);
		CHECK(value("2 a") == a * 2.0);
		CHECK(value("a / 3")[7] == a[7] / 3.0);
		// The tolerance allows for an ill-conditioned b.
		const Multivector quotient = value("a / b");
		CHECK(quotient.geometric_product(b).is_equal_approx(a, 1e-9));
		CHECK(value("(a + b) * ~(a - b)") == (a + b).geometric_product((a - b).reverse()));
		CHECK(value("a") == a);
	}
}

TEST_CASE("numbers and constants") {
	const auto value = [](std::string_view text) { return *evaluate(text); };
	CHECK(value("1 + 2 * 3 - 4 / 8") == Multivector::scalar(6.5));
	CHECK(value("2 ^ 3") == Multivector::scalar(6.0));
	CHECK(value("eo | einf") == Multivector::scalar(-1.0));
	CHECK(value("ei") == value("einf"));
	CHECK(value("e1 * e2") == *Multivector::basis("e12"));
	CHECK(value("e21") == -*Multivector::basis("e12"));
	CHECK(value("E * E") == Multivector::scalar(1.0));
	CHECK(value("I * I") == Multivector::scalar(-1.0));
	CHECK(value("einf ^ eo") == value("E"));
	CHECK(value("tau / pi") == Multivector::scalar(2.0));
	CHECK(value("0.1") == Multivector::scalar(0.1));
}

TEST_CASE("variables") {
	const Variables variables = { { "x", Multivector::scalar(3.0) }, { "größe", *Multivector::basis("e1") }, { "sin", Multivector::scalar(0.5) } };
	CHECK(*evaluate("x * größe", variables) == *Multivector::basis("e1") * 3.0);
	// A variable may have the name of a function.
	CHECK((*evaluate("sin + sin(0)", variables))[0] == 0.5);
	// The same expression with other values.
	const Expression expression = *parse("x ^ größe + 1");
	CHECK(*evaluate(expression, variables) == *Multivector::basis("e1") * 3.0 + Multivector::scalar(1.0));
	CHECK(*evaluate(expression, { { "x", *Multivector::basis("e2") }, { "größe", *Multivector::basis("e1") } }) == Multivector::scalar(1.0) - *Multivector::basis("e12"));
}

TEST_CASE("an evaluation error gives the column and what was expected") {
	const double most = std::numeric_limits<double>::max();
	Multivector not_finite;
	not_finite[3] = std::numeric_limits<double>::infinity();
	const Variables variables = { { "fob", Multivector::scalar(1.0) }, { "Sphere1", Multivector::scalar(1.0) }, { "large", Multivector::scalar(most) }, { "bad", not_finite } };
	const std::vector<std::pair<std::string, std::string>> errors = {
		{ "1 + foo", "column 5: unknown name 'foo'; did you mean 'fob'?" },
		{ "sphere1", "column 1: unknown name 'sphere1'; did you mean 'Sphere1'?" },
		{ "xyz", "column 1: unknown name 'xyz'" },
		{ "2 * rotor", "column 5: unknown name 'rotor'; to call the function write 'rotor('" },
		{ "1 / 0", "column 3: division by zero" },
		{ "e1 / (e2 - e2)", "column 4: division by zero" },
		{ "2 * large", "column 3: the result of '*' is too large" },
		{ "large e1", "column 7: expected an operator or the end, found 'e1'; write '*' to multiply" },
		{ "1 + (large + large) * 0", "column 12: the result of '+' is too large" },
		{ "-large - large", "column 8: the result of '-' is too large" },
		{ "(large * e12) ^ (e34 * 2)", "column 15: the result of '^' is too large" },
		{ "(large * e12 + large) * (e12 + e34 + 1)", "column 23: the result of '*' is too large" },
		{ "fob + bad", "column 7: 'bad' has a coefficient that is not finite" },
		{ "exp(1000)", "column 1: the result of 'exp' is too large" },
		{ "1 / 1e-320", "column 3: the result of '/' is too large" },
		{ "rotor(e3, e1)", "column 11: expected a number as second argument of rotor(axis, angle)" },
		{ "rotor(3, 1)", "column 7: expected a vector (of e1, e2, e3) as first argument of rotor(axis, angle)" },
		{ "rotor(1, 2, 1 + e1, 4)", "column 13: expected a number as third argument of rotor(x, y, z, w)" },
		{ "rotor(1, 2, 3,   -e1)", "column 18: expected a number as fourth argument of rotor(x, y, z, w)" },
		{ "2 sin( e1 + 1)", "column 8: expected a number as first argument of sin(angle)" },
		{ "translator(e1 + e4)", "column 12: expected a vector (of e1, e2, e3) as first argument of translator(offset)" },
		{ "motor(e1, e14, 2)", "column 11: expected a rotor about the origin as second argument of motor(translation, rotor, scale)" },
		{ "transform_point(1, e4)", "column 20: expected a point or a vector (of e1, e2, e3) as second argument of transform_point(motor, point)" },
		{ "sphere(e1, e2)", "column 12: expected a number as second argument of sphere(center, radius)" },
		{ "circle(e1, e4, 1)", "column 12: expected a point or a vector (of e1, e2, e3) as second argument of circle(center, normal, radius) or circle(a, b, c)" },
		{ "sphere(einf, 1, 1, 1)", "column 8: expected a number or a point or a vector (of e1, e2, e3) as first argument of sphere(x, y, z, radius) or sphere(a, b, c, d)" },
		{ "1 + sqrt(-1)", "column 5: sqrt: expected a number of at least 0, not -1" },
		{ "dilator(-1)", "column 1: dilator: the scale must be above 0, not -1" },
		{ "grade(e1, 1.5)", "column 1: grade: the grade must be an integer in 0..5, not 1.5" },
	};
	for (const auto &each : errors) {
		CAPTURE(each.first);
		CHECK(error_of(each.first, variables) == each.second);
	}
	// Errors of functions in cga are passed on.
	CHECK(error_of("1 + inverse(e1 + e5)").find("column 5: inverse: ") == 0);
	CHECK(error_of("e1 / (e1 + e5)").find("column 4: ") == 0);
	CHECK(error_of("  normalized(einf)").find("column 3: normalized: ") == 0);
	CHECK(error_of("log(e1)").find("column 1: log: ") == 0);
}

TEST_CASE("a variable with an invalid name is an error") {
	CHECK(error_of("1", { { "e1", Multivector() } }) == "column 1: invalid variable name: 'e1' is a constant; choose another name");
	CHECK(error_of("1", { { "a b", Multivector() } }) == "column 1: invalid variable name: a name may have only letters, digits and underscores, and may not begin with a digit");
}

TEST_CASE("evaluate reads the coefficients that to_text writes") {
	Random random(2);
	for (int repeat = 0; repeat < 5000; ++repeat) {
		Multivector x = random.multivector();
		for (int index = 0; index < cga::BLADE_COUNT; ++index) {
			const double chance = random.uniform(0.0, 1.0);
			if (chance < 0.5) {
				x[index] = chance < 0.1 ? std::round(x[index]) : 0.0;
			} else if (chance < 0.6) {
				x[index] *= std::pow(10.0, int(random.uniform(-300.0, 300.0)));
			}
		}
		const std::string text = cga::to_text(x);
		const cga::TextResult<Multivector> read = evaluate(text);
		REQUIRE_MESSAGE(read.has_value(), text);
		// == ignores only the sign of zero.
		CHECK_MESSAGE(*read == x, text);
	}
	const double most = std::numeric_limits<double>::max();
	for (int index = 0; index < cga::BLADE_COUNT; ++index) {
		for (const double value : { most, -most, std::numeric_limits<double>::denorm_min(), 1.0, -1.0 }) {
			const Multivector x = Multivector::basis_blade(index, value);
			CHECK(*evaluate(cga::to_text(x)) == x);
		}
	}
}

TEST_CASE("evaluate reads the null basis of to_text within rounding") {
	Random random(3);
	for (int repeat = 0; repeat < 5000; ++repeat) {
		Multivector x = random.multivector();
		for (int index = 0; index < cga::BLADE_COUNT; ++index) {
			x[index] = random.uniform(0.0, 1.0) < 0.5 ? 0.0 : x[index] * std::pow(10.0, int(random.uniform(-3.0, 3.0)));
		}
		const std::string text = cga::to_text(x, true);
		const cga::TextResult<Multivector> read = evaluate(text);
		REQUIRE_MESSAGE(read.has_value(), text);
		CHECK_MESSAGE(read->is_equal_approx(x, 1e-15 * x.max_abs()), text);
	}
}
