#pragma once

#include "cga/text/text_error.hpp"
#include "playground/expression/expression.hpp"

#include <cstddef>
#include <string_view>

// The expression language of the playground and of Multivector.evaluate. docs/guides/expressions.md describes it for
// users; the grammar, with every level binding tighter than the one before it, binary operators from left to right:
//
//   sum        product (('+' | '-') product)*
//   product    inner (('*' | '/') inner)*
//   inner      outer (('|' | '<<' | '>>' | '&') outer)*
//   outer      prefix ('^' prefix)*
//   prefix     ('-' | '+' | '~' | '!')* term
//   term       number (name | call | group)?        a number before what it multiplies: 2 e12
//            | name | call | group | list
//   call       name '(' (sum (',' sum)*)? ')'
//   group      '(' sum ')'
//   list       '[' 32 numbers as JSON has them ']'      the coefficients

namespace playground {

inline constexpr size_t MAX_TEXT_LENGTH = 16384; // bytes
inline constexpr size_t MAX_DEPTH = 256; // operators and brackets that wait for their end

// An error names the column and what was expected there: unknown functions, wrong numbers of arguments and all that is
// no expression. Whether a variable exists is known when it is evaluated.
[[nodiscard]] cga::TextResult<Expression> parse(std::string_view text);

} // namespace playground
