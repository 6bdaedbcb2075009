// Constructors, classify and incidence behind a C interface, by name. Each returns false for an unknown name.

#include "elements.hpp"

#include "cga/object/classify.hpp"
#include "cga/object/construct.hpp"
#include "cga/object/incidence.hpp"

using namespace cga;
using namespace oracle;

namespace {

using Vector = Vector3<double>;

// Takes vectors and numbers from an array, one after the other.
class Reader {
public:
	explicit Reader(const double *numbers) :
			_numbers(numbers) {}

	double number() { return *_numbers++; }
	Vector vector() {
		const double x = number(), y = number(), z = number();
		return { x, y, z };
	}

private:
	const double *_numbers;
};

struct Constructor {
	const char *name;
	int numbers;
	MultivectorResult (*function)(Reader &);
};

struct Incidence {
	const char *name;
	MultivectorResult (*function)(const Multivector &, const Multivector &);
};

// Arguments are read into names first: a call evaluates its arguments in any order.
constexpr Constructor CONSTRUCTORS[] = {
	{ "point", 3, [](Reader &in) -> MultivectorResult { return point(in.vector()); } },
	{ "flat_point", 3, [](Reader &in) -> MultivectorResult { return flat_point(in.vector()); } },
	{ "point_pair", 6, [](Reader &in) -> MultivectorResult {
		 const Vector a = in.vector(), b = in.vector();
		 return point_pair(a, b);
	 } },
	{ "line", 6, [](Reader &in) -> MultivectorResult {
		 const Vector position = in.vector(), direction = in.vector();
		 return line(position, direction);
	 } },
	{ "line_through", 6, [](Reader &in) -> MultivectorResult {
		 const Vector a = in.vector(), b = in.vector();
		 return line_through(a, b);
	 } },
	{ "circle", 7, [](Reader &in) -> MultivectorResult {
		 const Vector center = in.vector(), normal = in.vector();
		 return circle(center, normal, in.number());
	 } },
	{ "circle_through", 9, [](Reader &in) -> MultivectorResult {
		 const Vector a = in.vector(), b = in.vector(), c = in.vector();
		 return circle_through(a, b, c);
	 } },
	{ "plane", 4, [](Reader &in) -> MultivectorResult {
		 const Vector normal = in.vector();
		 return plane(normal, in.number());
	 } },
	{ "plane_through", 9, [](Reader &in) -> MultivectorResult {
		 const Vector a = in.vector(), b = in.vector(), c = in.vector();
		 return plane_through(a, b, c);
	 } },
	{ "sphere", 4, [](Reader &in) -> MultivectorResult {
		 const Vector center = in.vector();
		 return sphere(center, in.number());
	 } },
	{ "sphere_through", 12, [](Reader &in) -> MultivectorResult {
		 const Vector a = in.vector(), b = in.vector(), c = in.vector(), d = in.vector();
		 return sphere_through(a, b, c, d);
	 } },
};

constexpr Incidence INCIDENCE[] = {
	{ "meet", [](const Multivector &a, const Multivector &b) { return meet(a, b); } },
	{ "join", [](const Multivector &a, const Multivector &b) { return join(a, b); } },
	{ "project_onto", [](const Multivector &x, const Multivector &onto) { return project_onto(x, onto); } },
	{ "reject_from", [](const Multivector &x, const Multivector &from) { return reject_from(x, from); } },
	{ "reflect_in", [](const Multivector &x, const Multivector &mirror) { return reflect_in(x, mirror); } },
};

// A classification as numbers, NaN for what does not apply: kind, ipns, imaginary, residual, radius, distance, center,
// normal, direction, the two points.
constexpr size_t CLASS_NUMBERS = 21;

void store_vector(const std::optional<Vector> &vector, double *numbers) {
	if (vector) {
		numbers[0] = vector->x;
		numbers[1] = vector->y;
		numbers[2] = vector->z;
	}
}

void store_classification(const Classification &found, double *numbers) {
	const double missing = std::numeric_limits<double>::quiet_NaN();
	std::fill_n(numbers, CLASS_NUMBERS, missing);
	numbers[0] = double(int(found.kind));
	numbers[1] = found.ipns;
	numbers[2] = found.imaginary;
	numbers[3] = found.residual;
	numbers[4] = found.radius.value_or(missing);
	numbers[5] = found.distance.value_or(missing);
	store_vector(found.center, numbers + 6);
	store_vector(found.normal, numbers + 9);
	store_vector(found.direction, numbers + 12);
	if (found.points) {
		store_vector((*found.points)[0], numbers + 15);
		store_vector((*found.points)[1], numbers + 18);
	}
}

} // namespace

ORACLE bool oracle_construct(const char *name, const double *numbers, double *result, const char **reasons, size_t count) {
	const Constructor *entry = find_entry(CONSTRUCTORS, name);
	for (size_t i = 0; entry && i < count; ++i) {
		Reader reader(numbers + i * size_t(entry->numbers));
		store_result(entry->function(reader), result + i * BLADE_COUNT, reasons + i);
	}
	return entry;
}

ORACLE bool oracle_incidence(const char *name, const double *left, const double *right, double *result, const char **reasons, size_t count) {
	const Incidence *entry = find_entry(INCIDENCE, name);
	for (size_t i = 0; entry && i < count; ++i) {
		const Multivector a = load_multivector(left + i * BLADE_COUNT);
		const Multivector b = load_multivector(right + i * BLADE_COUNT);
		store_result(entry->function(a, b), result + i * BLADE_COUNT, reasons + i);
	}
	return entry;
}

ORACLE void oracle_classify(int ipns, const double *elements, double *classes, size_t count) {
	for (size_t i = 0; i < count; ++i) {
		store_classification(classify(load_multivector(elements + i * BLADE_COUNT), ipns != 0), classes + i * CLASS_NUMBERS);
	}
}
