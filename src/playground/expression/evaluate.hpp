#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/text/text_error.hpp"
#include "playground/expression/expression.hpp"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace playground {

// What names stand for; plain numbers as Multivector::scalar. Names are as names.hpp's name_error allows them.
using Variables = std::map<std::string, cga::Multivector, std::less<>>;

// The value of an expression: always finite. An error names the column of the unknown variable, of the function or
// operator that has no result, or of the variable that is not finite.
[[nodiscard]] cga::TextResult<cga::Multivector> evaluate(const Expression &expression, const Variables &variables);

// The same with values in the order of the expression's variables(), none of them null.
[[nodiscard]] cga::TextResult<cga::Multivector> evaluate(const Expression &expression, const std::vector<const cga::Multivector *> &values);

// The same from its text. A variable with a name that an expression cannot refer to is an error at column 1.
[[nodiscard]] cga::TextResult<cga::Multivector> evaluate(std::string_view text, const Variables &variables = {});

} // namespace playground
