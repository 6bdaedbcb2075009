#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <variant>

// What an entry has beside its expression: how it is shown, notes, settings of tools. Kept when it is saved.

namespace playground {

// `monostate`: none.
using AttributeValue = std::variant<std::monostate, bool, double, std::string>;

using Attributes = std::map<std::string, AttributeValue, std::less<>>;

// These have a type and a default, which is not saved:
//
//   visible   bool     true    drawn
//   label     bool     true    its name drawn beside it
//   ipns      bool     false   the value is read as a dual object
//   color     string   ""      "#rrggbb" or "#rrggbbaa"; empty: the colour of its kind
//   note      string   ""      free text
//
// All other keys are open to whoever uses the document ("interpolation/mode"), with any value.
[[nodiscard]] AttributeValue default_attribute(std::string_view key);

// Why an attribute cannot have this value, as a sentence; empty if it can. Keys have letters, digits, '_', '-', '.' and '/',
// at most 64; numbers are finite. None is always possible: it takes an open attribute away and gives the others their default.
[[nodiscard]] std::string attribute_error(std::string_view key, const AttributeValue &value);

// The value, or else the default.
[[nodiscard]] AttributeValue get_attribute(const Attributes &attributes, std::string_view key);
// For values without attribute_error. Whether it differs from what it was.
bool set_attribute(Attributes &attributes, std::string_view key, const AttributeValue &value);

// Whether a known attribute of type bool is true.
[[nodiscard]] bool is_set(const Attributes &attributes, std::string_view key);

} // namespace playground
