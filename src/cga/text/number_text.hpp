#pragma once

#include <optional>
#include <string>
#include <string_view>

// Numbers in decimal, the same whatever the process's locale says about decimal points.

namespace cga {

// Appends the shortest decimal that reads back as the same double: "0.1", "-2", "100000", "1e+20", "1.5e-07". An
// exponent always has a sign, which tells it from a blade's name. Finite values by contract.
void append_number(std::string &text, double value);

// The double closest to a decimal number: digits with at most one point, an exponent, a minus (the caller has seen to
// that). Smaller than any double is zero; empty if it is larger than any.
[[nodiscard]] std::optional<double> read_number(std::string_view decimal);

namespace detail {

// The same two by way of streams, for standard libraries without <charconv> for doubles (GCC 9 and 10).
void append_number_by_stream(std::string &text, double value);
[[nodiscard]] std::optional<double> read_number_by_stream(std::string_view decimal);

} // namespace detail

} // namespace cga
