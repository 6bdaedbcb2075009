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

// Values by name; numbers are Multivector::scalar. check_name() in names.hpp accepts each name.
using Variables = std::map<std::string, cga::Multivector, std::less<>>;

// The value of an expression, always finite. An error gives the column of the unknown variable, of the function or
// operator without a result, or of the variable that is not finite.
[[nodiscard]] cga::TextResult<cga::Multivector> evaluate(const Expression &expression, const Variables &variables);

// As above, with values in the order of the expression's variables(), none of them null.
[[nodiscard]] cga::TextResult<cga::Multivector> evaluate(const Expression &expression, const std::vector<const cga::Multivector *> &values);

// As above, from the text. A variable whose name check_name() refuses is an error at column 1.
[[nodiscard]] cga::TextResult<cga::Multivector> evaluate(std::string_view text, const Variables &variables = {});

} // namespace playground
