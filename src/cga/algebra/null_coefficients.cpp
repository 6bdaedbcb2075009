#include "cga/algebra/null_coefficients.hpp"

namespace cga {

namespace {

constexpr unsigned E4 = 0b01000;
constexpr unsigned E5 = 0b10000;

// `exchange` of each pair of coefficients whose blades differ in e4 and e5 only; all others stay.
template <class Exchange>
void for_each_pair(Multivector::Coefficients &coefficients, Exchange exchange) {
	for (unsigned euclidean = 0; euclidean < E4; ++euclidean) {
		exchange(coefficients[BLADE_INDICES[euclidean | E4]], coefficients[BLADE_INDICES[euclidean | E5]]);
	}
}

} // namespace

Multivector::Coefficients to_null_coefficients(const Multivector &x) {
	Multivector::Coefficients coefficients = x.coefficients();
	for_each_pair(coefficients, [](double &fourth, double &fifth) {
		const double infinity = 0.5 * fourth + 0.5 * fifth;
		fifth = fifth - fourth;
		fourth = infinity;
	});
	return coefficients;
}

// c_inf e_inf + c_o e_o = (c_inf - c_o/2) e4 + (c_inf + c_o/2) e5
Multivector from_null_coefficients(const Multivector::Coefficients &coefficients) {
	Multivector::Coefficients result = coefficients;
	for_each_pair(result, [](double &infinity, double &origin) {
		const double fourth = infinity - 0.5 * origin;
		origin = infinity + 0.5 * origin;
		infinity = fourth;
	});
	return Multivector(result);
}

} // namespace cga
