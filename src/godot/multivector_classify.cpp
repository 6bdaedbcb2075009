#include "godot/multivector.hpp"

#include "cga/object/classify.hpp"
#include "godot/conversions.hpp"

#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/variant.hpp>

// What an element is geometrically, as scripts see it.

namespace ga_godot {

using godot::Dictionary;
using godot::TypedArray;
using godot::Vector3;

Dictionary Multivector::classify(bool p_ipns) const {
	const cga::Classification found = cga::classify(_value, p_ipns);
	Dictionary result;
	result["kind"] = cga::name_of(found.kind);
	result["ipns"] = found.ipns;
	result["imaginary"] = found.imaginary;
	if (found.center) {
		result["center"] = to_godot(*found.center);
	}
	if (found.radius) {
		result["radius"] = *found.radius;
	}
	if (found.normal) {
		result["normal"] = to_godot(*found.normal);
	}
	if (found.direction) {
		result["direction"] = to_godot(*found.direction);
	}
	if (found.distance) {
		result["distance"] = *found.distance;
	}
	if (found.points) {
		TypedArray<Vector3> points;
		for (const cga::Vector3<double> &point : *found.points) {
			points.push_back(to_godot(point));
		}
		result["points"] = points;
	}
	result["residual"] = found.residual;
	return result;
}

} // namespace ga_godot
