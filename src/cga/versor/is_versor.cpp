#include "cga/versor/is_versor.hpp"

#include "cga/motor/motor_multivector.hpp"

namespace cga {

bool is_versor(const Multivector &x, double tolerance) {
	const bool of_one_parity = x.is_even(tolerance) || x.is_odd(tolerance);
	// Motors with a large translation have large coefficients that cancel: only the minimal form separates them from null ones.
	return (of_one_parity && x.inverse_of_versor(tolerance)) || is_motor(x, tolerance);
}

bool is_motor(const Multivector &x, double tolerance) {
	return to_motor(x, tolerance).has_value();
}

} // namespace cga
