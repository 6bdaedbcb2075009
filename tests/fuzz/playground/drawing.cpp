// The drawing of any multivector, and picking: positions and distances are finite.

#include "../cga/multivector.hpp"

#include "cga/object/classify.hpp"
#include "playground/drawing/figure.hpp"
#include "playground/drawing/pick.hpp"

#include <cmath>

namespace {

using fuzz::require;
using playground::drawing::Vector;

bool is_finite(const Vector &vector) {
	return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

void check(const playground::drawing::Figure &figure) {
	for (const playground::drawing::Part &part : figure.parts) {
		const playground::drawing::Placement &placement = part.placement;
		require(is_finite(placement.x) && is_finite(placement.y) && is_finite(placement.z) && is_finite(placement.origin), "a placement is not finite");
		require(std::isfinite(part.radius), "a radius is not finite");
		const playground::drawing::Box box = playground::drawing::bounds_of(part, figure.custom);
		require(is_finite(box.min) && is_finite(box.max), "a box is not finite");
		require(box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z, "a box is inverted");
	}
	for (const playground::drawing::StrokeVertex &vertex : figure.custom.vertices) {
		require(is_finite(Vector(vertex.position)) && is_finite(Vector(vertex.tangent)), "a vertex is not finite");
	}
	for (const int32_t index : figure.custom.indices) {
		require(index >= 0 && size_t(index) < figure.custom.vertices.size(), "an index is out of range");
	}
	require(!figure.label_position || is_finite(*figure.label_position), "the position of a label is not finite");
}

} // namespace

void fuzz::run(Input input) {
	const cga::Multivector x = multivector_from(input);
	const playground::drawing::Figure figure = playground::drawing::figure_of(x, input.flag());
	check(figure);
	playground::drawing::PickRay ray;
	ray.origin = { input.finite_number(), input.finite_number(), input.finite_number() };
	const Vector direction(input.between(-1.0, 1.0), input.between(-1.0, 1.0), input.between(-1.0, 1.0));
	ray.direction = glm::length(direction) > 1e-3 ? glm::normalize(direction) : Vector(0.0, 0.0, -1.0);
	ray.pixel_at_origin = input.between(0.0, 0.1);
	ray.pixel_per_meter = input.between(1e-6, 0.1);
	if (const auto hit = playground::drawing::pick(figure, ray)) {
		require(!std::isnan(hit->pixels) && hit->pixels >= 0.0 && !std::isnan(hit->depth), "a hit has no distance");
	}
}
