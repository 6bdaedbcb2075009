// Functions of one and of two multivectors behind a C interface, by name. Each returns false for an unknown name.

#include "elements.hpp"

#include "cga/algebra/is_blade.hpp"
#include "cga/versor/exponential.hpp"
#include "cga/versor/inverse.hpp"
#include "cga/versor/is_versor.hpp"
#include "cga/versor/logarithm.hpp"
#include "cga/versor/normalized.hpp"
#include "cga/versor/power.hpp"

using namespace cga;
using namespace oracle;

namespace {

struct Unary {
	const char *name;
	MultivectorResult (*function)(const Multivector &);
};

struct Binary {
	const char *name;
	MultivectorResult (*function)(const Multivector &, const Multivector &);
};

MultivectorResult truth(bool value) {
	return Multivector::scalar(value ? 1.0 : 0.0);
}

constexpr Unary UNARY[] = {
	{ "reverse", [](const Multivector &x) -> MultivectorResult { return x.reverse(); } },
	{ "grade involution", [](const Multivector &x) -> MultivectorResult { return x.grade_involution(); } },
	{ "clifford conjugate", [](const Multivector &x) -> MultivectorResult { return x.clifford_conjugate(); } },
	{ "dual", [](const Multivector &x) -> MultivectorResult { return x.dual(); } },
	{ "undual", [](const Multivector &x) -> MultivectorResult { return x.undual(); } },
	{ "norm squared", [](const Multivector &x) -> MultivectorResult { return Multivector::scalar(x.norm_squared()); } },
	{ "norm", [](const Multivector &x) -> MultivectorResult { return Multivector::scalar(x.norm()); } },
	{ "inverse", [](const Multivector &x) { return inverse(x); } },
	{ "normalized", [](const Multivector &x) { return normalized(x); } },
	{ "exp", [](const Multivector &x) { return exp(x); } },
	{ "log", [](const Multivector &x) { return log(x); } },
	{ "sqrt", [](const Multivector &x) { return sqrt(x); } },
	{ "is blade", [](const Multivector &x) { return truth(is_blade(x)); } },
	{ "is versor", [](const Multivector &x) { return truth(is_versor(x)); } },
	{ "is motor", [](const Multivector &x) { return truth(is_motor(x)); } },
};

constexpr Binary BINARY[] = {
	{ "geometric product", [](const Multivector &a, const Multivector &b) -> MultivectorResult { return a.geometric_product(b); } },
	{ "outer product", [](const Multivector &a, const Multivector &b) -> MultivectorResult { return a.outer_product(b); } },
	{ "inner product", [](const Multivector &a, const Multivector &b) -> MultivectorResult { return a.inner_product(b); } },
	{ "left contraction", [](const Multivector &a, const Multivector &b) -> MultivectorResult { return a.left_contraction(b); } },
	{ "right contraction", [](const Multivector &a, const Multivector &b) -> MultivectorResult { return a.right_contraction(b); } },
	{ "scalar product", [](const Multivector &a, const Multivector &b) -> MultivectorResult { return Multivector::scalar(a.scalar_product(b)); } },
	{ "regressive product", [](const Multivector &a, const Multivector &b) -> MultivectorResult { return a.regressive_product(b); } },
	{ "commutator product", [](const Multivector &a, const Multivector &b) -> MultivectorResult { return a.commutator_product(b); } },
	{ "sandwich", [](const Multivector &versor, const Multivector &x) -> MultivectorResult {
		 const std::optional<Multivector> image = versor.sandwich(x);
		 return image ? MultivectorResult(*image) : MultivectorResult(AlgebraError::NOT_A_VERSOR);
	 } },
	// The second is the exponent, a number.
	{ "power", [](const Multivector &versor, const Multivector &exponent) { return power(versor, exponent[0]); } },
};

} // namespace

ORACLE bool oracle_unary(const char *name, const double *operands, double *result, const char **reasons, size_t count) {
	const Unary *entry = find_entry(UNARY, name);
	for (size_t i = 0; entry && i < count; ++i) {
		store_result(entry->function(load_multivector(operands + i * BLADE_COUNT)), result + i * BLADE_COUNT, reasons + i);
	}
	return entry;
}

ORACLE bool oracle_binary(const char *name, const double *left, const double *right, double *result, const char **reasons, size_t count) {
	const Binary *entry = find_entry(BINARY, name);
	for (size_t i = 0; entry && i < count; ++i) {
		const Multivector a = load_multivector(left + i * BLADE_COUNT);
		const Multivector b = load_multivector(right + i * BLADE_COUNT);
		store_result(entry->function(a, b), result + i * BLADE_COUNT, reasons + i);
	}
	return entry;
}
