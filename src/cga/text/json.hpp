#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/text/text_error.hpp"

#include <string>
#include <string_view>

// Multivectors in ganja.js's form: 32 numbers.
//
// Order: index 0..31 as in blade.hpp, which is the order of ganja.js's Algebra(4,1). Its e1 .. e4 square to +1 and its
// e5 to -1, as here, so that an element has the same 32 numbers there and here: nothing is turned, and products agree.
//
// What differs is the *dual*: ganja.js (!x, x.Dual) and GA-Unity multiply by I, this library by I^-1 = -I. So the
// numbers of an object that was dualised there are those of -dual(X) here: the same object, of opposite orientation.
// Where orientation or weight matters, multiply such an element by -1 after reading it, and before writing it for them.

namespace cga {

// "[0,1.5,0,...]": 32 numbers, each the shortest that reads back as itself, so that from_json gives the same bits.
[[nodiscard]] std::string to_json(const Multivector &x);

// Reads, with any white space that JSON allows and nothing after it:
// - an array of 32 numbers;
// - an object with the one key "coefficients" and such an array;
// - an object with keys "0".."31", each once and in any order, and numbers: what JSON.stringify makes of a ganja.js
//   element, which is a typed array.
// Anything else is an error that says where and what was expected. Numbers are JSON's: no nan, no hexadecimal, no
// leading plus. One too large for a double is an error; one too small is zero. Texts above 65,536 bytes are refused.
[[nodiscard]] TextResult<Multivector> from_json(std::string_view text);

} // namespace cga
