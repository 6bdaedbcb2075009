#include "godot/algebra/multivector.hpp"

#include "cga/object/classify.hpp"
#include "godot/algebra/conversions.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>
#include <optional>

// What an element is geometrically, as scripts see it.

namespace ga_godot {

using godot::Dictionary;
using godot::TypedArray;
using godot::Vector3;

// Coefficients hundreds of orders of magnitude apart leave the range of doubles on the way to a centre.
static bool is_in_range(const cga::Classification &p_found) {
	const auto is_vector_in_range = [](const std::optional<cga::Vector3<double>> &p_vector) {
		return !p_vector || (std::isfinite(p_vector->x) && std::isfinite(p_vector->y) && std::isfinite(p_vector->z));
	};
	return is_vector_in_range(p_found.center) && is_vector_in_range(p_found.normal) && is_vector_in_range(p_found.direction) && std::isfinite(p_found.radius.value_or(0.0)) && std::isfinite(p_found.distance.value_or(0.0));
}

Dictionary Multivector::classify(bool p_ipns) const {
	cga::Classification found = cga::classify(_value, p_ipns);
	if (!is_in_range(found)) {
		ERR_PRINT("Multivector.classify: the coefficients are too far apart in size to tell what this is; leave out those that are rounding.");
		found = cga::Classification();
		found.ipns = p_ipns;
	}
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
