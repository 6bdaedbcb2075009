#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/text/text_error.hpp"

#include <string>
#include <string_view>

// Multivectors as JSON in the format of ganja.js: 32 numbers.
//
// Order: index 0..31 as in blade.hpp, the order of ganja.js's Algebra(4,1). There, too, e1 .. e4 square to +1 and e5 to
// -1, so that a multivector has the same 32 numbers and all products agree.
//
// The *dual* differs: ganja.js (!x, x.Dual) and GA-Unity multiply by I, this library by I^-1 = -I. An object dualized
// there reads as -dual(X): the same object with the opposite orientation. Where orientation or weight matters, multiply
// it by -1 after reading, and before writing.

namespace cga {

// "[0,1.5,0,...]": 32 numbers, each the shortest that reads back as itself, so that from_json returns the same bits.
[[nodiscard]] std::string to_json(const Multivector &x);

// Reads one of
// - an array of 32 numbers;
// - an object with the single key "coefficients" and such an array;
// - an object with the keys "0".."31" in any order, each with a number: JSON.stringify writes a ganja.js element, which
//   is a typed array, like this.
// White space is allowed as in JSON. Anything else is an error. Numbers follow JSON: no NaN, no hexadecimal, no leading
// plus. Overflow of double is an error; underflow gives zero. At most 65,536 bytes.
[[nodiscard]] TextResult<Multivector> from_json(std::string_view text);

} // namespace cga
