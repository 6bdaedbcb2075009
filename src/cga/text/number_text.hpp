#pragma once

#include <optional>
#include <string>
#include <string_view>

// Decimal numbers, independent of the locale.

namespace cga {

// Appends the shortest decimal that reads back as the same double: "0.1", "-2", "100000", "1e+20", "1.5e-07". An
// exponent always has a sign, which distinguishes it from the name of a blade. Precondition: the value is finite.
void append_number(std::string &text, double value);

// The double closest to a decimal number. Precondition: an optional minus, digits with at most one point, an optional
// exponent. Zero on underflow, empty on overflow.
[[nodiscard]] std::optional<double> read_number(std::string_view decimal);

namespace detail {

// The same with streams, for standard libraries without <charconv> for doubles.
void append_number_by_stream(std::string &text, double value);
[[nodiscard]] std::optional<double> read_number_by_stream(std::string_view decimal);

} // namespace detail

} // namespace cga
