#include "playground/handles/drag.hpp"
#include "playground/handles/handles.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace playground;
using namespace playground::handles;

namespace {

constexpr const char *TEXTS[] = {
	"point(1, 2, 3)",
	"flat_point(e1)",
	"pair(e1, e2)",
	"line(e1, 2 e2)",
	"line_through(e1, point(0, 1, 2))",
	"circle(e1, e2, 2)",
	"circle(e1, point(0, 2, 0), e3)",
	"plane(e3, 1)",
	"plane(1, 2, 3, -4)",
	"plane_through(e1, e2, e3)",
	"!sphere(e1, 2)",
	"sphere(1, 2, 3, 4)",
	"sphere_through(e1, e2, e3, 0)",
	"imaginary_circle(e1, e2, 2)",
	"imaginary_point_pair(0, e2, 2)",
	"tangent_along(e1, e2)",
	"tangent_across(e1, e2)",
	"direction(e1)",
	"direction_across(e1)",
	"vector(1, 2, 3)",
	"translator(1, 2, 3)",
	"rotor(e3, deg(90))",
	"rotor(0, 0, 0.6, 0.8)",
	"dilator(2)",
	"motor(e1, rotor(e3, deg(90)), 2)",
	"motor(e1, 1)",
	"e1 + 0.5 einf + eo",
	"-(2 e1 ^ einf)",
};

class Random {
public:
	double number() {
		switch (_engine() % 8) {
			case 0:
				return 0.0;
			case 1:
				return std::pow(10.0, _any(_engine) * 60.0) * (_engine() % 2 == 0 ? 1.0 : -1.0);
			case 2: {
				constexpr double EXTREMES[] = { 1e308, -1e308, 5e-324, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() };
				return _engine() % 4 == 0 ? EXTREMES[_engine() % 5] : 1.0;
			}
			default:
				return _any(_engine) * 5.0;
		}
	}
	Vector vector() { return { number(), number(), number() }; }
	size_t below(size_t count) { return _engine() % count; }

private:
	std::mt19937 _engine{ 11 };
	std::uniform_real_distribution<double> _any{ -1.0, 1.0 };
};

} // namespace

TEST_CASE("for random rays, a dragged object has a finite value, and its handles finite positions") {
	Random random;
	int done = 0, refused = 0;
	for (const char *text : TEXTS) {
		Document document;
		REQUIRE(document.add("x", text));
		REQUIRE_MESSAGE(document.find("x")->value, std::string(text));
		for (int i = 0; i < 1500; ++i) {
			const std::vector<Handle> handles = handles_of(document, "x", random.vector());
			// It was dragged beyond MAX_DISTANCE.
			if (handles.empty()) {
				REQUIRE(document.set_expression("x", text));
				continue;
			}
			for (const Handle &handle : handles) {
				const Vector sum = handle.constraint.position + handle.stem + handle.constraint.axis;
				REQUIRE_MESSAGE(std::isfinite(sum.x + sum.y + sum.z), document.find("x")->text);
			}
			Handle start = handles[random.below(handles.size())];
			start.grab = random.below(3) == 0 ? random.vector() : Vector(0.0);
			const std::optional<Drag> result = drag(document, "x", start, { random.vector(), random.vector(), random.vector() }, { std::abs(random.number()), std::abs(random.number()) });
			const std::string before = document.find("x")->text;
			if (!result || !document.set_parameter("x", result->parameter, result->value)) {
				++refused;
				REQUIRE(document.find("x")->text == before);
				continue;
			}
			++done;
			REQUIRE_MESSAGE(document.find("x")->value, before, " became ", document.find("x")->text);
			REQUIRE(document.find("x")->value->is_finite());
		}
	}
	MESSAGE(done, " drags, ", refused, " refused");
	CHECK(done > 5000);
}
