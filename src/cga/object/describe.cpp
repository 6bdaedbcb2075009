#include "cga/object/classify.hpp"

#include <cstdio>

namespace cga {

namespace {

constexpr const char *NAMES[] = { "scalar", "point", "point_pair", "circle", "sphere", "flat_point", "line", "plane", "direction", "tangent", "rotor", "translator", "dilator", "motor", "none" };

// Six digits: for people to read.
std::string number(double value) {
	char text[32];
	std::snprintf(text, sizeof(text), "%.6g", value == 0.0 ? 0.0 : value);
	return text;
}

std::string vector(const Vector3<double> &v) {
	return "(" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ")";
}

} // namespace

const char *name_of(Kind kind) {
	return NAMES[size_t(kind)];
}

std::string describe(const Classification &found) {
	if (found.kind == Kind::none) {
		return found.residual > 0.0 ? "not a blade (residual " + number(found.residual) + ")" : "no object";
	}
	std::string text = name_of(found.kind);
	for (char &letter : text) {
		letter = letter == '_' ? ' ' : letter;
	}
	text = (found.ipns ? "dual " : "") + std::string(found.imaginary ? "imaginary " : "") + text;
	if (found.radius) {
		text += ", radius " + number(*found.radius);
	}
	if (found.center) {
		text += found.radius ? ", centre " + vector(*found.center) : ", at " + vector(*found.center);
	}
	if (found.distance) {
		text += ", distance " + number(*found.distance);
	}
	if (found.normal) {
		text += ", normal " + vector(*found.normal);
	}
	if (found.direction) {
		text += ", direction " + vector(*found.direction);
	}
	return text;
}

} // namespace cga
