#pragma once

#include "cga/platform/compiler.hpp"

#include <cstdint>
#include <cstring>

// Elementary functions of one float without branches or calls, so that loops over lanes vectorize. Taylor polynomials on a
// reduced range; their remainders are below the rounding of float.

namespace cga::float_math {

namespace {

CGA_ALWAYS_INLINE float min(float left, float right) noexcept {
	return left < right ? left : right;
}

CGA_ALWAYS_INLINE float max(float left, float right) noexcept {
	return left > right ? left : right;
}

// The nearest integer of |x| < 2^22: adding 1.5 * 2^23 leaves no bits for the fraction.
CGA_ALWAYS_INLINE float round_to_integer(float x) noexcept {
	constexpr float NO_FRACTION = 12582912.0f;
	return (x + NO_FRACTION) - NO_FRACTION;
}

// 2^k, -126 <= k <= 127.
CGA_ALWAYS_INLINE float power_of_two(int32_t k) noexcept {
	const int32_t bits = (k + 127) * (1 << 23);
	float result;
	std::memcpy(&result, &bits, sizeof(result));
	return result;
}

struct Exponential {
	float value; // exp(x)
	float minus_one; // exp(x) - 1, with the relative precision of x near zero
};

// x is clamped to -87..87.
// x = k ln 2 + r, |r| <= ln(2)/2, exp(x) - 1 = 2^k (exp(r) - 1) + (2^k - 1); the remainder r^8/8! is below 6e-9.
CGA_ALWAYS_INLINE Exponential exponential(float x) noexcept {
	constexpr float LIMIT = 87.0f;
	constexpr float INVERSE_LN2 = 1.44269504f;
	constexpr float LN2_HIGH = 0.693359375f; // 9 bits, so that k LN2_HIGH is exact
	constexpr float LN2_LOW = -2.12194442e-4f;
	const float clamped = max(-LIMIT, min(LIMIT, x));
	const float k = round_to_integer(clamped * INVERSE_LN2);
	const float r = (clamped - k * LN2_HIGH) - k * LN2_LOW;
	const float tail = ((((r * (1.0f / 5040.0f) + 1.0f / 720.0f) * r + 1.0f / 120.0f) * r + 1.0f / 24.0f) * r + 1.0f / 6.0f) * r + 0.5f;
	const float reduced = r + r * r * tail;
	const float scale = power_of_two(int32_t(k));
	return { scale + scale * reduced, scale * reduced + (scale - 1.0f) };
}

struct SinCos {
	float sine;
	float cosine;
};

// Sine and cosine of |x| < 2e4. x = k pi/2 + r, |r| <= pi/4; remainders r^11/11! and r^10/10!, below 3e-8.
CGA_ALWAYS_INLINE SinCos sin_cos(float x) noexcept {
	constexpr float INVERSE_HALF_PI = 0.636619772f;
	constexpr float HALF_PI_HIGH = 1.5703125f; // 8 bits, so that k HALF_PI_HIGH is exact
	constexpr float HALF_PI_MIDDLE = 4.83751297e-4f; // 12 bits
	constexpr float HALF_PI_LOW = 7.54979013e-8f;
	const float k = round_to_integer(x * INVERSE_HALF_PI);
	const float r = ((x - k * HALF_PI_HIGH) - k * HALF_PI_MIDDLE) - k * HALF_PI_LOW;
	const float r2 = r * r;
	const float sine = r + r * r2 * (((r2 * (1.0f / 362880.0f) - 1.0f / 5040.0f) * r2 + 1.0f / 120.0f) * r2 - 1.0f / 6.0f);
	const float cosine = 1.0f + r2 * (((r2 * (1.0f / 40320.0f) - 1.0f / 720.0f) * r2 + 1.0f / 24.0f) * r2 - 0.5f);
	// The quadrant decides whether to swap sine and cosine, and their signs.
	const int32_t quadrant = int32_t(k);
	const bool swaps = (quadrant & 1) != 0;
	const float plain_sine = swaps ? cosine : sine;
	const float plain_cosine = swaps ? sine : cosine;
	return { (quadrant & 2) != 0 ? -plain_sine : plain_sine, ((quadrant + 1) & 2) != 0 ? -plain_cosine : plain_cosine };
}

} // namespace

} // namespace cga::float_math
