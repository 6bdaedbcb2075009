#include "cga/text/text.hpp"

#include "../random_poses.hpp"
#include "cga/algebra/null_coefficients.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace cga;
using cga_test::Random;

namespace {

Multivector basis(const char *name) {
	return *Multivector::basis(name);
}

} // namespace

TEST_CASE("a multivector as a sum") {
	CHECK(to_text(Multivector()) == "0");
	CHECK(to_text(Multivector::scalar(-0.0)) == "0");
	CHECK(to_text(Multivector::scalar(1.0)) == "1");
	CHECK(to_text(Multivector::scalar(-1.0)) == "-1");
	CHECK(to_text(basis("e12")) == "e12");
	CHECK(to_text(-basis("e12")) == "-e12");
	CHECK(to_text(Multivector::scalar(1.0) + basis("e12") * 2.0 - basis("e4") * 0.5) == "1 - 0.5 e4 + 2 e12");
	CHECK(to_text(basis("I") * -1.5e-7 + basis("e1") * 1e20) == "1e+20 e1 - 1.5e-07 e12345");
	CHECK(to_text(basis("einf")) == "e4 + e5");
}

TEST_CASE("a multivector in the null basis") {
	CHECK(to_text(Multivector(), true) == "0");
	CHECK(to_text(basis("einf"), true) == "einf");
	CHECK(to_text(basis("eo"), true) == "eo");
	CHECK(to_text(basis("E"), true) == "einf^eo");
	CHECK(to_text(basis("I"), true) == "e123^einf^eo");
	CHECK(to_text(Multivector::scalar(1.0) + basis("e12") * 2.0 - basis("einf") * 0.5, true) == "1 - 0.5 einf + 2 e12");
	CHECK(to_text(basis("e12").outer_product(basis("einf")) * 3.0 - basis("e3").outer_product(basis("eo")), true) == "-e3^eo + 3 e12^einf");
	// The point (1, 2, 3).
	CHECK(to_text(basis("e1") + basis("e2") * 2.0 + basis("e3") * 3.0 + basis("einf") * 7.0 + basis("eo"), true) == "e1 + 2 e2 + 3 e3 + 7 einf + eo");
}

TEST_CASE("coefficients whose sums overflow in the null basis are written without it") {
	const double most = std::numeric_limits<double>::max();
	const Multivector x = basis("e5") * most - basis("e4") * most;
	CHECK(to_text(x, true) == "-1.7976931348623157e+308 e4 + 1.7976931348623157e+308 e5");
	CHECK(to_text(basis("einf") * most, true) == "1.7976931348623157e+308 einf");
}

TEST_CASE("LaTeX") {
	CHECK(to_latex(Multivector()) == "0");
	CHECK(to_latex(Multivector::scalar(1.0) + basis("e12") * 2.0 - basis("e3") * 1.5e-7) == "1 - 1.5 \\times 10^{-7} \\mathbf{e}_{3} + 2 \\mathbf{e}_{12}");
	CHECK(to_latex(basis("e1") * 1e100) == "1 \\times 10^{100} \\mathbf{e}_{1}");
	CHECK(to_latex(-basis("I")) == "-\\mathbf{e}_{12345}");
	CHECK(to_latex(-basis("I"), true) == "-\\mathbf{e}_{123} \\wedge \\mathbf{e}_{\\infty} \\wedge \\mathbf{e}_{o}");
	CHECK(to_latex(basis("eo") + basis("einf") * 0.5, true) == "0.5 \\mathbf{e}_{\\infty} + \\mathbf{e}_{o}");
}

TEST_CASE("null coefficients are those of the null basis, and convert back") {
	Random random(4);
	for (int repeat = 0; repeat < 1000; ++repeat) {
		const Multivector x = random.multivector();
		const Multivector::Coefficients coefficients = to_null_coefficients(x);
		CHECK(from_null_coefficients(coefficients).is_equal_approx(x, 1e-14));
		// The sum that they stand for, blade by blade.
		Multivector sum;
		for (int index = 0; index < BLADE_COUNT; ++index) {
			const unsigned bitmap = BLADE_BITMAPS[size_t(index)];
			Multivector blade = Multivector::basis_blade(BLADE_INDICES[bitmap & 7u]);
			blade = (bitmap & 8u) != 0 ? blade.outer_product(basis("einf")) : blade;
			blade = (bitmap & 16u) != 0 ? blade.outer_product(basis("eo")) : blade;
			sum += blade * coefficients[size_t(index)];
		}
		CHECK(sum.is_equal_approx(x, 1e-14));
	}
}
