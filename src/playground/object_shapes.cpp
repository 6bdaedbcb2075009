#include "playground/object_shapes.hpp"

#include "cga/algebra/null_basis.hpp"
#include "cga/motor/versor.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

namespace playground {

namespace {

using cga::Failure;
using cga::Multivector;

// Below this fraction of the sizes that it is made of, a difference is rounding.
constexpr double ROUNDING = 1e-12;

constexpr Failure COINCIDENT{ "two of the points coincide; give different ones" };
constexpr Failure NO_NORMAL{ "the direction has length zero; give another" };
constexpr Failure NO_RADIUS{ "the radius must be above 0" };

double size(const Location &vector) {
	return std::max({ std::abs(vector.x), std::abs(vector.y), std::abs(vector.z) });
}

// Empty for zero.
std::optional<Location> unit(const Location &vector) {
	const double largest = size(vector);
	return largest > 0.0 ? std::optional<Location>(glm::normalize(vector / largest)) : std::nullopt;
}

bool any_coincide(std::initializer_list<Location> points) {
	for (const Location *left = points.begin(); left != points.end(); ++left) {
		for (const Location *right = left + 1; right != points.end(); ++right) {
			if (size(*left - *right) <= ROUNDING * std::max(size(*left), size(*right))) {
				return true;
			}
		}
	}
	return false;
}

Multivector wedge(std::initializer_list<Location> points) {
	Multivector product = Multivector::scalar(1.0);
	for (const Location &point : points) {
		product = product.outer_product(cga::point(point));
	}
	return product;
}

// The outer product of points as seen from the first of them and in their own size, where it is zero only if they
// depend on each other.
Multivector local_wedge(std::initializer_list<Location> points) {
	double extent = 0.0;
	for (const Location &point : points) {
		extent = std::max(extent, size(point - *points.begin()));
	}
	Multivector product = Multivector::scalar(1.0);
	for (const Location &point : points) {
		product = product.outer_product(cga::point((point - *points.begin()) / extent));
	}
	return product;
}

Multivector dual_sphere(const Location &center, double radius) {
	return cga::point(center) - cga::e_infinity() * (0.5 * radius * radius);
}

} // namespace

Shape flat_point(const Location &position) {
	return cga::point(position).outer_product(cga::e_infinity());
}

Shape point_pair(const Location &a, const Location &b) {
	if (any_coincide({ a, b })) {
		return COINCIDENT;
	}
	return wedge({ a, b });
}

Shape line(const Location &point, const Location &direction) {
	const std::optional<Location> along = unit(direction);
	if (!along) {
		return NO_NORMAL;
	}
	return cga::point(point).outer_product(cga::euclidean(*along)).outer_product(cga::e_infinity());
}

Shape line_through(const Location &a, const Location &b) {
	if (any_coincide({ a, b })) {
		return COINCIDENT;
	}
	return wedge({ a, b }).outer_product(cga::e_infinity());
}

Shape circle_through(const Location &a, const Location &b, const Location &c) {
	if (any_coincide({ a, b, c })) {
		return COINCIDENT;
	}
	return wedge({ a, b, c });
}

Shape circle(const Location &center, const Location &normal, double radius) {
	const std::optional<Location> across = unit(normal);
	if (!across) {
		return NO_NORMAL;
	}
	if (!(radius > 0.0)) {
		return NO_RADIUS;
	}
	const Multivector dual_plane = cga::euclidean(*across) + cga::e_infinity() * glm::dot(*across, center);
	return -dual_sphere(center, radius).outer_product(dual_plane).undual();
}

Shape plane_through(const Location &a, const Location &b, const Location &c) {
	if (any_coincide({ a, b, c })) {
		return COINCIDENT;
	}
	if (local_wedge({ a, b, c }).outer_product(cga::e_infinity()).max_abs() <= ROUNDING) {
		return Failure{ "the three points are on a line; give one beside it" };
	}
	return wedge({ a, b, c }).outer_product(cga::e_infinity());
}

Shape plane(const Location &normal, double distance) {
	const std::optional<Location> across = unit(normal);
	if (!across) {
		return NO_NORMAL;
	}
	return -(cga::euclidean(*across) + cga::e_infinity() * distance).undual();
}

Shape sphere_through(const Location &a, const Location &b, const Location &c, const Location &d) {
	if (any_coincide({ a, b, c, d })) {
		return COINCIDENT;
	}
	if (local_wedge({ a, b, c, d }).max_abs() <= ROUNDING) {
		return Failure{ "the four points are on a circle or a line; give one beside it" };
	}
	return wedge({ a, b, c, d });
}

Shape sphere(const Location &center, double radius) {
	if (!(radius > 0.0)) {
		return NO_RADIUS;
	}
	return -dual_sphere(center, radius).undual();
}

} // namespace playground
