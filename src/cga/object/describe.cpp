#include "cga/object/classify.hpp"

#include "cga/text/readable.hpp"

namespace cga {

namespace {

constexpr const char *NAMES[] = { "scalar", "point", "point_pair", "circle", "sphere", "flat_point", "line", "plane", "direction", "tangent", "rotor", "translator", "dilator", "motor", "none" };

} // namespace

const char *name_of(Kind kind) {
	return NAMES[size_t(kind)];
}

std::string describe(const Classification &found) {
	if (found.kind == Kind::NONE) {
		return found.residual > 0.0 ? "not a blade (residual " + readable(found.residual) + ")" : "no object";
	}
	std::string text = name_of(found.kind);
	for (char &letter : text) {
		letter = letter == '_' ? ' ' : letter;
	}
	text = (found.ipns ? "dual " : "") + std::string(found.imaginary ? "imaginary " : "") + text;
	if (found.radius) {
		text += ", radius " + readable(*found.radius);
	}
	if (found.center) {
		text += (found.radius ? ", center " : ", at ") + readable(*found.center, found.radius.value_or(0.0));
	}
	if (found.distance) {
		text += ", distance " + readable(*found.distance);
	}
	if (found.normal) {
		text += ", normal " + readable(*found.normal);
	}
	if (found.direction) {
		text += ", direction " + readable(*found.direction);
	}
	return text;
}

} // namespace cga
