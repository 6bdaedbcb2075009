#include "cga/algebra/multivector.hpp"
#include "playground/document/document.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>

using namespace playground;

namespace {

// The C++ code that the screenshot test copies from the dock (tests/screenshots/dock_probe/chapters/copying.gd).
namespace copied {
#include "../../screenshots/dock_probe/copied.inc"
} // namespace copied

} // namespace

TEST_CASE("entries copied as C++ code compile and have the values of the document") {
	Document document;
	REQUIRE(document.add("A", "point(1, 2, 3)"));
	REQUIRE(document.add("for", "sphere(A, 2)"));
	REQUIRE(document.add("p", "plane(e2, 1.5)"));
	REQUIRE(document.add("c_1", "meet(for, p)"));
	REQUIRE(document.add("m", "motor(2 e1, rotor(e3, deg(90)), 1)"));
	const std::pair<const char *, cga::Multivector> variables[] = {
		{ "A", copied::A },
		{ "for", copied::for_ },
		{ "c_1", copied::c_1 },
		{ "m", copied::m },
	};
	for (const auto &each : variables) {
		const std::string &name = each.first;
		CAPTURE(name);
		REQUIRE(document.find(name)->value);
		CHECK(each.second.coefficients() == document.find(name)->value->coefficients());
	}
}
