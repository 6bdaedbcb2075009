#pragma once

#include <cmath>
#include <complex>
#include <type_traits>

// phi(z) = (exp(z) - 1) / z, the function behind exp, log and power of similarities; stable for all
// z = sigma + i theta with |theta| < 2 pi.

namespace cga {

// phi of a complex number: phi = N conj(z) / |z|^2 with
//   Re N = expm1(sigma) cos(theta) - 2 sin(theta/2)^2
//   Im N = exp(sigma) sin(theta)
// and 1 + z/2 where z^2/6 is below rounding.
template <class T>
[[nodiscard]] std::complex<T> phi(const std::complex<T> &z) noexcept {
	constexpr T SMALL = std::is_same_v<T, float> ? T(1e-12) : T(1e-16);
	const T sigma = z.real();
	const T theta = z.imag();
	const T squared = sigma * sigma + theta * theta;
	if (squared < SMALL) {
		return { T(1) + sigma / T(2), theta / T(2) };
	}
	const T half_sine = std::sin(theta / T(2));
	const T real = std::expm1(sigma) * std::cos(theta) - T(2) * half_sine * half_sine;
	const T imaginary = std::exp(sigma) * std::sin(theta);
	return { (real * sigma + imaginary * theta) / squared, (imaginary * sigma - real * theta) / squared };
}

// phi of a real number.
template <class T>
[[nodiscard]] T phi(T sigma) noexcept {
	return sigma == T(0) ? T(1) : std::expm1(sigma) / sigma;
}

// (exp(alpha z) - 1) / (exp(z) - 1) = alpha phi(alpha z) / phi(z); alpha where z = 0.
template <class Number, class T>
[[nodiscard]] Number power_ratio(const Number &z, T alpha) noexcept {
	return alpha * phi(alpha * z) / phi(z);
}

} // namespace cga
