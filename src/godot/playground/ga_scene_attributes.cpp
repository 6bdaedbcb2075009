#include "godot/algebra/conversions.hpp"
#include "godot/playground/ga_scene.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/color.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

// Attributes of entries and of the scene.

namespace ga_godot {

using godot::Color;
using godot::Dictionary;
using godot::Error;
using godot::String;
using godot::Variant;
using godot::vformat;
using playground::AttributeValue;

static constexpr const char *WRONG_ATTRIBUTE_TYPE = "GAScene.%s: the attribute \"%s\" must be a bool, a number, a string, a Color, or null to reset it, not %s.";

// "#rrggbb", or "#rrggbbaa" unless opaque. Components are clamped to 0..1.
static std::string hexadecimal(const Color &color) {
	constexpr char DIGITS[] = "0123456789abcdef";
	const float components[] = { color.r, color.g, color.b, color.a };
	std::string text = "#";
	for (const float component : components) {
		// NaN fails the comparison and becomes 0.
		const int byte = component > 0.0f ? int(std::lround(std::min(component, 1.0f) * 255.0f)) : 0;
		text += DIGITS[byte >> 4];
		text += DIGITS[byte & 15];
	}
	return text.substr(0, text.compare(7, 2, "ff") == 0 ? 7 : 9);
}

// Empty for types that cannot be an attribute.
static std::optional<AttributeValue> to_attribute(const Variant &value) {
	switch (value.get_type()) {
		case Variant::NIL:
			return AttributeValue();
		case Variant::BOOL:
			return AttributeValue(bool(value));
		case Variant::INT:
		case Variant::FLOAT:
			return AttributeValue(double(value));
		case Variant::STRING:
		case Variant::STRING_NAME: {
			const String text = value;
			return AttributeValue(to_utf8(text));
		}
		case Variant::COLOR:
			return AttributeValue(hexadecimal(value));
		default:
			return std::nullopt;
	}
}

static Variant to_variant(const AttributeValue &attribute) {
	if (const bool *boolean = std::get_if<bool>(&attribute)) {
		return *boolean;
	}
	if (const double *number = std::get_if<double>(&attribute)) {
		return *number;
	}
	if (const std::string *text = std::get_if<std::string>(&attribute)) {
		return to_godot(*text);
	}
	return Variant();
}

static Dictionary to_dictionary(const playground::Attributes &attributes) {
	Dictionary dictionary;
	for (const auto &[key, value] : attributes) {
		dictionary[to_godot(key)] = to_variant(value);
	}
	return dictionary;
}

Error GAScene::set_entry_attribute(const String &name, const String &key, const Variant &value) {
	const std::optional<AttributeValue> attribute = to_attribute(value);
	ERR_FAIL_COND_V_MSG(!attribute, godot::ERR_INVALID_PARAMETER, vformat(WRONG_ATTRIBUTE_TYPE, "set_entry_attribute", to_godot(cga::shortened(to_utf8(key))), Variant::get_type_name(value.get_type())));
	return finish(_document.set_attribute(to_utf8(name), to_utf8(key), *attribute), "set_entry_attribute");
}

Variant GAScene::get_entry_attribute(const String &name, const String &key) const {
	const playground::Entry *entry = find(name, "get_entry_attribute");
	return entry ? to_variant(playground::get_attribute(entry->attributes, to_utf8(key))) : Variant();
}

Dictionary GAScene::get_entry_attributes(const String &name) const {
	const playground::Entry *entry = find(name, "get_entry_attributes");
	return entry ? to_dictionary(entry->attributes) : Dictionary();
}

Error GAScene::set_scene_attribute(const String &key, const Variant &value) {
	const std::optional<AttributeValue> attribute = to_attribute(value);
	ERR_FAIL_COND_V_MSG(!attribute, godot::ERR_INVALID_PARAMETER, vformat(WRONG_ATTRIBUTE_TYPE, "set_scene_attribute", to_godot(cga::shortened(to_utf8(key))), Variant::get_type_name(value.get_type())));
	return finish(_document.set_document_attribute(to_utf8(key), *attribute), "set_scene_attribute");
}

Variant GAScene::get_scene_attribute(const String &key) const {
	return to_variant(playground::get_attribute(_document.attributes(), to_utf8(key)));
}

Dictionary GAScene::get_scene_attributes() const {
	return to_dictionary(_document.attributes());
}

} // namespace ga_godot
