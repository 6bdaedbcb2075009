#pragma once

#include "cga/algebra/algebra_error.hpp"
#include "cga/algebra/multivector.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>

// What the C interfaces of the oracles share: arrays hold `count` elements one after the other, a multivector is 32
// doubles. Where a function has no result its row is filled with NaN, and `reasons` (one for each row) says why.

#define ORACLE extern "C" __attribute__((visibility("default")))

namespace oracle {

using cga::BLADE_COUNT;
using cga::Multivector;

inline Multivector load_multivector(const double *numbers) {
	Multivector result;
	for (int index = 0; index < BLADE_COUNT; ++index) {
		result[index] = numbers[index];
	}
	return result;
}

inline void store_multivector(const Multivector &multivector, double *numbers) {
	std::copy(multivector.coefficients().begin(), multivector.coefficients().end(), numbers);
}

inline void store_result(const cga::MultivectorResult &result, double *numbers, const char **reason) {
	if (result) {
		store_multivector(*result, numbers);
		*reason = nullptr;
	} else {
		std::fill_n(numbers, BLADE_COUNT, std::numeric_limits<double>::quiet_NaN());
		*reason = cga::describe(result.error());
	}
}

// The entry of a table with this name; null if there is none.
template <class Entry, size_t N>
const Entry *find_entry(const Entry (&entries)[N], const char *name) {
	const Entry *found = std::find_if(entries, entries + N, [name](const Entry &entry) { return std::strcmp(entry.name, name) == 0; });
	return found == entries + N ? nullptr : found;
}

} // namespace oracle
