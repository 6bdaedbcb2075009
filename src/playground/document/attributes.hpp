#pragma once

#include "playground/expression/error.hpp"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <variant>

// Properties of an entry besides its expression: display, notes, settings of tools. Saved with the document.

namespace playground {

// `monostate` is the absence of a value.
using AttributeValue = std::variant<std::monostate, bool, double, std::string>;

using Attributes = std::map<std::string, AttributeValue, std::less<>>;

// The known attributes. A value equal to the default is not saved.
//
//   visible   bool     true    the entry is drawn
//   label     bool     true    its name is drawn beside it
//   ipns      bool     false   the value represents a dual (IPNS) object
//   color     string   ""      "#rrggbb" or "#rrggbbaa"; empty: the default color of the object's kind
//   note      string   ""      free text
//
// Users of the document may add other keys ("interpolation/mode"), with values of any type.
[[nodiscard]] AttributeValue default_attribute(std::string_view key);

// Whether an attribute may have this value. Keys consist of 1 to 64 letters, digits, '_', '-', '.' and '/'; numbers are
// finite. `monostate` is always valid: it resets a known attribute to its default and removes any other.
cga::Result<void, Error> check_attribute(std::string_view key, const AttributeValue &value);

// The value, or the default.
[[nodiscard]] AttributeValue get_attribute(const Attributes &attributes, std::string_view key);
// Whether the value is absent or that of default_attribute().
[[nodiscard]] bool is_default(std::string_view key, const AttributeValue &value);
// Precondition: check_attribute(key, value). Returns whether the value changed.
bool set_attribute(Attributes &attributes, std::string_view key, AttributeValue value);

// Whether an attribute is the bool true.
[[nodiscard]] bool is_set(const Attributes &attributes, std::string_view key);

} // namespace playground
