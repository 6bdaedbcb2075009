// Handles of any entry and drags to any ray: values are finite, and the document accepts them or refuses them with a reason.

#include "valid_document.hpp"

#include "playground/handles/drag.hpp"
#include "playground/handles/handles.hpp"

#include <cmath>

namespace {

using fuzz::Input;
using fuzz::require;
using playground::handles::Vector;

// Numbers in the place of each '#'.
constexpr const char *OBJECTS[] = {
	"point(#, #, #)",
	"point(1, #, 2)",
	"point(r, #, r)",
	"sphere(point(#, #, #), #)",
	"sphere(a, #)",
	"!sphere(vector(#, #, #), #)",
	"circle(vector(#, #, #), vector(#, #, #), #)",
	"imaginary_circle(e1, e2, #)",
	"point_pair(vector(#, #, #), point(#, #, #))",
	"plane(#, #, #, #)",
	"plane(e2, #)",
	"line(vector(#, #, #), vector(#, #, #))",
	"tangent(vector(#, #, #), e1)",
	"translator(vector(#, #, #))",
	"rotor(vector(#, #, #), deg(#))",
	"rotor(#, #, #, #)",
	"dilator(#)",
	"motor(vector(#, #, #), rotor(e3, deg(#)), #)",
	"~motor(e1, rotor(e3, deg(#)), 1)",
	"-(sphere(e1, #))",
	"# + # e12",
	"# e1 + # e2 + # einf + # eo",
	"#",
	"vector(#, #, #)",
	"direction(vector(#, #, #))",
	"flat_point(vector(#, #, #))",
	"circle(point(#, #, #), a, vector(#, #, #))",
	"sphere(a, e1, e2, point(#, #, #))",
	"[#,#,#,#,#,#,#,#,#,#,#,#,#,#,#,#,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]",
};

std::string object_from(Input &input) {
	const uint8_t choice = input.byte();
	if (choice >= 250) {
		return input.text();
	}
	std::string text;
	for (const char *c = OBJECTS[choice % std::size(OBJECTS)]; *c != '\0'; ++c) {
		if (*c != '#') {
			text += *c;
			continue;
		}
		char number[40];
		std::snprintf(number, sizeof(number), "%.17g", input.finite_number());
		text += number;
	}
	return text;
}

Vector vector_from(Input &input) {
	return { input.number(), input.number(), input.number() };
}

bool is_finite(const Vector &vector) {
	return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

void check(const playground::handles::Handle &handle) {
	require(!handle.key.empty(), "a handle has no key");
	require(is_finite(handle.constraint.position) && is_finite(handle.constraint.center) && is_finite(handle.constraint.axis), "a handle is not finite", handle.key);
	require(is_finite(handle.stem) && is_finite(handle.grab), "the stem of a handle is not finite", handle.key);
}

} // namespace

void fuzz::run(Input input) {
	playground::Document document;
	require(document.add("a", "point(1, 2, 3)") && document.add("r", "2") && document.add("x", object_from(input)), "a valid entry is rejected");
	if (input.flag()) {
		require(document.set_attribute("x", "ipns", true).has_value(), "a valid attribute is refused");
	}
	for (int drags = 0; !input.is_empty() && drags < 3; ++drags) {
		const std::vector<playground::handles::Handle> handles = playground::handles::handles_of(document, "x");
		std::for_each(handles.begin(), handles.end(), check);
		if (handles.empty()) {
			return;
		}
		const playground::handles::Handle &handle = handles[input.byte() % handles.size()];
		const playground::handles::ViewRay ray = { vector_from(input), vector_from(input), vector_from(input) };
		const playground::handles::Steps steps = { input.flag() ? std::fabs(input.finite_number()) : 0.0, input.flag() ? std::fabs(input.finite_number()) : 0.0 };
		const auto drag = playground::handles::drag(document, "x", handle, ray, steps);
		if (!drag) {
			continue;
		}
		require(playground::is_finite(drag->value), "a dragged value is not finite", drag->parameter);
		const playground::ChangeResult changed = document.set_parameter("x", drag->parameter, drag->value);
		require(changed || !changed.error().message.empty(), "an error has no message");
		require_valid(document, document.find("x")->text);
	}
}
