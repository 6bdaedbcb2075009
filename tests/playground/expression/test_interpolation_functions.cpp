// interpolate_linear, interpolate_screw and interpolate_separate: values from other formulas, half turns and special cases.

#include "cga/text/text.hpp"
#include "playground/expression/evaluate.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace playground;
using cga::Multivector;

namespace {

const std::vector<std::string> METHODS = { "interpolate_linear", "interpolate_screw", "interpolate_separate" };

Multivector value_of(const std::string &text) {
	const cga::TextResult<Multivector> value = evaluate(text);
	REQUIRE_MESSAGE(value.has_value(), text, ": ", value.error().describe());
	return *value;
}

std::string call(const std::string &method, const std::string &from, const std::string &to, const std::string &t) {
	return method + "(" + from + ", " + to + ", " + t + ")";
}

void check_equal(const std::string &text, const std::string &expected, double tolerance = 1e-14) {
	const Multivector value = value_of(text);
	const Multivector other = value_of(expected);
	CHECK_MESSAGE(value.is_equal_approx(other, tolerance * std::max(1.0, other.max_abs())), text, " = ", cga::to_text(value), " is not ", cga::to_text(other));
}

// Compares poses: the motors may differ in sign.
void check_same_pose(const std::string &text, const std::string &expected, double tolerance = 1e-14) {
	const Multivector value = value_of(text);
	const Multivector other = value_of(expected);
	const double size = tolerance * std::max(1.0, other.max_abs());
	const bool is_same = value.is_equal_approx(other, size) || value.is_equal_approx(-other, size);
	CHECK_MESSAGE(is_same, text, " = ", cga::to_text(value), " is not +- ", cga::to_text(other));
}

} // namespace

TEST_CASE("interpolate_linear is the normalized blend of coefficients") {
	// A blend of planar motors is a planar motor, so it only needs normalization.
	check_equal("interpolate_linear(1, motor(e1, rotor(e3, 2)), 0.3)", "normalized(0.7 * 1 + 0.3 * motor(e1, rotor(e3, 2)))");
	check_equal("get_rotation(interpolate_linear(1, motor(e1, rotor(e3, 2)), 0.3))", "normalized(0.7 * 1 + 0.3 * rotor(e3, 2))");
	// Halfway it equals the screw motion, for any rotation.
	check_equal("interpolate_linear(translator(e2), motor(e1, rotor(e3, 2)), 0.5)", "interpolate_screw(translator(e2), motor(e1, rotor(e3, 2)), 0.5)");
	// A quarter of the way through a half turn, it lags by 45 - 2 atan(1/3) = 8.13 degrees.
	const Multivector quarter = value_of("get_rotation(interpolate_linear(1, rotor(e3, pi), 0.25))");
	CHECK(quarter[0] == doctest::Approx(3.0 / std::sqrt(10.0)).epsilon(1e-14));
	CHECK(quarter[6] == doctest::Approx(-1.0 / std::sqrt(10.0)).epsilon(1e-14));
}

TEST_CASE("interpolate_screw is a power of the motion between the motors") {
	for (const std::string t : { "0.1", "0.5", "0.9", "-0.5", "1.75" }) {
		check_equal(call("interpolate_screw", "motor(e1 + e2, rotor(e3, 1), 2)", "motor(3 e3, rotor(e1 + e2, 2), 0.7)", t),
				"power(motor(3 e3, rotor(e1 + e2, 2), 0.7) / motor(e1 + e2, rotor(e3, 1), 2), " + t + ") * motor(e1 + e2, rotor(e3, 1), 2)", 1e-13);
	}
}

TEST_CASE("interpolate_separate interpolates translation, rotation and scale separately") {
	const std::string middle = call("interpolate_separate", "motor(e1, rotor(e3, 1), 2)", "motor(5 e2, rotor(e3, 2), 4)", "0.25");
	check_equal(middle, "motor(0.75 * e1 + 1.25 * e2, rotor(e3, 1.25), 2.5)");
}

TEST_CASE("weight and sign of the motors are ignored") {
	const std::string from = "motor(e1 + e2, rotor(e3, 1), 2)";
	const std::string to = "motor(3 e3, rotor(e1 + e2, 2), 0.7)";
	for (const std::string &method : METHODS) {
		const std::string plain = call(method, from, to, "0.3");
		check_equal(call(method, "7 " + from, "0.01 * " + to, "0.3"), plain);
		check_same_pose(call(method, from, "-" + to, "0.3"), plain);
		check_same_pose(call(method, "-" + from, to, "0.3"), plain);
		check_same_pose(call(method, "-2 " + from, "-1e-5 * " + to, "0.3"), plain);
		// The result is normalized.
		CHECK(value_of("norm_squared(" + plain + ")")[0] == doctest::Approx(1.0).epsilon(1e-14));
	}
}

TEST_CASE("t = 0 and t = 1 give the poses, and equal poses give that pose") {
	const std::string from = "motor(e1 + e2, rotor(e3, 1), 2)";
	const std::string to = "motor(3 e3, rotor(e1 + e2, 2), 0.7)";
	for (const std::string &method : METHODS) {
		check_same_pose(call(method, from, to, "0"), from);
		check_same_pose(call(method, from, to, "1"), to);
		check_same_pose(call(method, from, from, "0.4"), from);
		check_same_pose(call(method, from, "-3 " + from, "0.4"), from);
		check_equal(call(method, "1", "1", "0.4"), "1");
	}
	for (const std::string method : { "interpolate_linear", "interpolate_separate" }) {
		check_same_pose(call(method, from, to, "-2"), from);
		check_same_pose(call(method, from, to, "2"), to);
	}
}

TEST_CASE("a half turn is interpolated in one of the two directions") {
	for (const std::string &method : METHODS) {
		for (const std::string half_turn : { "rotor(e3, pi)", "-rotor(e3, pi)", "e12", "-e12", "rotor(e3, pi - 1e-9)", "rotor(e3, pi + 1e-9)" }) {
			const Multivector middle = value_of(call(method, "1", half_turn, "0.5"));
			CAPTURE(half_turn);
			CHECK(std::abs(middle[0]) == doctest::Approx(std::sqrt(0.5)).epsilon(1e-8));
			CHECK(std::abs(middle[6]) == doctest::Approx(std::sqrt(0.5)).epsilon(1e-8));
		}
	}
	// A door that turns by 180 degrees keeps its distance from the hinge.
	check_equal("norm(get_translation(interpolate_screw(translator(e1), rotor(e3, pi) * translator(e1), 0.37)))", "1");
}

TEST_CASE("small and large motions, and a large ratio of scales") {
	for (const std::string &method : METHODS) {
		check_same_pose(call(method, "1", "rotor(e3, 1e-9)", "0.5"), "rotor(e3, 5e-10)");
		check_same_pose(call(method, "translator(1e6, 0, 0)", "translator(1e6 + 2, 0, 0)", "0.5"), "translator(1e6 + 1, 0, 0)");
	}
	check_equal("get_scale(interpolate_screw(dilator(1e-6), dilator(1e+6), 0.5))", "1", 1e-12);
	check_equal("get_scale(interpolate_linear(dilator(1e-6), dilator(1e+6), 0.5))", "0.5 * (1e+6 + 1e-6)", 1e-11);
	// Scaling about a point other than the origin keeps that point fixed.
	check_equal("get_translation(interpolate_screw(1, translator(-e1) * dilator(2), 0.5))", "(1 - sqrt(2)) * e1");
}

TEST_CASE("an error names the argument and its column") {
	const auto error_of = [](const std::string &text) {
		const cga::TextResult<Multivector> value = evaluate(text);
		REQUIRE_FALSE_MESSAGE(value.has_value(), text);
		return value.error().describe();
	};
	CHECK(error_of("interpolate_screw(e1, 1, 0.5)") == "column 19: expected a motor (a product of translators, rotors and dilators) as first argument of interpolate_screw(from, to, t)");
	CHECK(error_of("interpolate_linear(1, 0, 0.5)") == "column 23: expected a motor (a product of translators, rotors and dilators) as second argument of interpolate_linear(from, to, t)");
	CHECK(error_of("interpolate_separate(1, 1, e12)") == "column 28: expected a number as third argument of interpolate_separate(from, to, t)");
	CHECK(error_of("interpolate_screw(1, 1)") == "column 1: interpolate_screw takes 3 arguments, not 2");
	CHECK(error_of("interpolate(1, 1, 0)").find("unknown function 'interpolate'") != std::string::npos);
}
