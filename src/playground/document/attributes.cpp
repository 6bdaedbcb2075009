#include "playground/document/attributes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace playground {

namespace {

constexpr size_t MAX_KEY_LENGTH = 64;
constexpr const char *TYPE_NAMES[] = { "nothing", "a bool", "a number", "a string" };

bool is_key_character(char character) {
	return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') || (character >= '0' && character <= '9') || std::string_view("_-./").find(character) != std::string_view::npos;
}

bool is_color(std::string_view text) {
	const bool has_length = text.empty() || text.size() == 7 || text.size() == 9;
	return has_length && (text.empty() || text[0] == '#') && (text.empty() || text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string_view::npos);
}

} // namespace

AttributeValue default_attribute(std::string_view key) {
	if (key == "visible" || key == "label") {
		return true;
	}
	if (key == "ipns") {
		return false;
	}
	if (key == "color" || key == "note") {
		return std::string();
	}
	return {};
}

cga::Result<void, Error> check_attribute(std::string_view key, const AttributeValue &value) {
	if (key.empty() || key.size() > MAX_KEY_LENGTH || !std::all_of(key.begin(), key.end(), is_key_character)) {
		return Error("the key of an attribute must consist of 1 to 64 letters, digits, '_', '-', '.' or '/'");
	}
	const AttributeValue standard = default_attribute(key);
	if (standard.index() != 0 && value.index() != 0 && standard.index() != value.index()) {
		return Error("the attribute '" + std::string(key) + "' must be " + TYPE_NAMES[standard.index()] + ", not " + TYPE_NAMES[value.index()]);
	}
	const std::string *text = std::get_if<std::string>(&value);
	if (key == "color" && text && !is_color(*text)) {
		return Error("the attribute 'color' must have the form #rrggbb or #rrggbbaa");
	}
	const double *number = std::get_if<double>(&value);
	if (number && !std::isfinite(*number)) {
		return Error("the attribute '" + std::string(key) + "' must be finite");
	}
	return {};
}

AttributeValue get_attribute(const Attributes &attributes, std::string_view key) {
	const auto found = attributes.find(key);
	return found == attributes.end() ? default_attribute(key) : found->second;
}

bool is_default(std::string_view key, const AttributeValue &value) {
	return value.index() == 0 || value == default_attribute(key);
}

bool set_attribute(Attributes &attributes, std::string_view key, AttributeValue value) {
	const auto place = attributes.lower_bound(key);
	const bool is_stored = place != attributes.end() && place->first == key;
	if (is_default(key, value)) {
		if (is_stored) {
			attributes.erase(place);
		}
		return is_stored;
	}
	if (!is_stored) {
		attributes.emplace_hint(place, key, std::move(value));
		return true;
	}
	if (place->second == value) {
		return false;
	}
	place->second = std::move(value);
	return true;
}

bool is_set(const Attributes &attributes, std::string_view key) {
	const AttributeValue value = get_attribute(attributes, key);
	const bool *boolean = std::get_if<bool>(&value);
	return boolean && *boolean;
}

} // namespace playground
