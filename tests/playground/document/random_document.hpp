#pragma once

#include "playground/document/document.hpp"

#include <random>
#include <string>

// Random changes of a document with few names, so that errors, cycles and name collisions are frequent.

namespace playground_test {

class RandomDocument {
public:
	explicit RandomDocument(unsigned seed) :
			_engine(seed) {}

	size_t below(size_t count) { return _engine() % count; }

	template <size_t COUNT>
	std::string one_of(const char *const (&texts)[COUNT]) { return texts[below(COUNT)]; }

	std::string name() { return one_of({ "a", "b", "c", "d", "e", "f", "g", "h", "point", "größe" }); }

	std::string number() { return one_of({ "0", "1", "2", "-1", "0.5", "3", "1e+200" }); }

	// Mostly valid.
	std::string expression() {
		switch (below(12)) {
			case 0:
				return number();
			case 1:
				return "point(" + number() + ", " + number() + ", " + number() + ")";
			case 2:
				return "sphere(e1, " + number() + ")";
			case 3:
				return name() + " + ";
			case 4:
				return "1 / " + name();
			case 5:
				return "floor(norm(" + name() + "))";
			case 6:
				return "join(" + name() + ", " + name() + ")";
			case 7:
				return "  " + name() + "*(" + name() + " -2 " + name() + ")";
			default:
				return name() + one_of({ " + ", " * ", " ^ ", " - " }) + (below(2) == 0 ? name() : number());
		}
	}

	playground::ChangeResult change(playground::Document &document) {
		switch (below(10)) {
			case 0:
			case 1:
			case 2:
				return document.add(name(), expression(), below(12));
			case 3:
				return document.rename(name(), name());
			case 4:
				return document.remove(name());
			case 5:
				return document.move(name(), below(10));
			case 6:
				return document.set_parameter(name(), one_of({ "value", "radius" }), double(below(5)) - 1.0);
			case 7:
				return document.set_attribute(name(), one_of({ "visible", "ipns", "label" }), below(2) == 0);
			default:
				return document.set_expression(name(), expression());
		}
	}

private:
	std::mt19937_64 _engine;
};

} // namespace playground_test
