#pragma once

#include "cga/text/text_error.hpp"
#include "playground/expression/expression.hpp"

#include <cstddef>
#include <string_view>

// The expression language of the playground and of Multivector.evaluate; docs/guides/expressions.md is its guide for
// users. In the grammar each level binds tighter than the one above, and binary operators associate to the left:
//
//   sum        product (('+' | '-') product)*
//   product    inner (('*' | '/') inner)*
//   inner      outer (('|' | '<<' | '>>' | '&') outer)*
//   outer      prefix ('^' prefix)*
//   prefix     ('-' | '+' | '~' | '!')* term
//   term       number (name | call | group)?        implicit product: 2 e12
//            | name | call | group | list
//   call       name '(' (sum (',' sum)*)? ')'
//   group      '(' sum ')'
//   list       '[' 32 JSON numbers ']'              the coefficients

namespace playground {

inline constexpr size_t MAX_TEXT_LENGTH = 16384; // bytes
inline constexpr size_t MAX_DEPTH = 256; // pending operators and open parentheses

// An error gives the column and what was expected there. Unknown functions and wrong argument counts are errors here;
// unknown variables only when the expression is evaluated.
[[nodiscard]] cga::TextResult<Expression> parse(std::string_view text);

} // namespace playground
