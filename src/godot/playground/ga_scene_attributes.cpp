#include "godot/algebra/conversions.hpp"
#include "godot/playground/ga_scene.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/color.hpp>

#include <algorithm>
#include <string>

// What entries and scenes have beside expressions.

namespace ga_godot {

using godot::Color;
using godot::Dictionary;
using godot::Error;
using godot::String;
using godot::Variant;
using godot::vformat;
using playground::AttributeValue;

static constexpr const char *NO_ATTRIBUTE = "GAScene.%s: the attribute \"%s\" must be a bool, a number, a string, a Color, or null for none, not %s.";

// "#rrggbb", and the alpha where it is not opaque; components outside of 0..1 are taken to its ends.
static std::string hexadecimal(const Color &p_color) {
	constexpr char DIGITS[] = "0123456789abcdef";
	const float components[] = { p_color.r, p_color.g, p_color.b, p_color.a };
	std::string text = "#";
	for (const float component : components) {
		// Written so that NaN is 0.
		const int byte = component > 0.0f ? int(std::min(component, 1.0f) * 255.0f + 0.5f) : 0;
		text += DIGITS[byte >> 4];
		text += DIGITS[byte & 15];
	}
	return text.substr(0, text.compare(7, 2, "ff") == 0 ? 7 : 9);
}

// False if a value of this type cannot be kept.
static bool to_attribute(const Variant &p_value, AttributeValue &r_attribute) {
	switch (p_value.get_type()) {
		case Variant::NIL:
			r_attribute = AttributeValue();
			return true;
		case Variant::BOOL:
			r_attribute = bool(p_value);
			return true;
		case Variant::INT:
		case Variant::FLOAT:
			r_attribute = double(p_value);
			return true;
		case Variant::STRING:
		case Variant::STRING_NAME: {
			const String text = p_value;
			r_attribute = to_utf8(text);
			return true;
		}
		case Variant::COLOR:
			r_attribute = hexadecimal(p_value);
			return true;
		default:
			return false;
	}
}

static Variant to_variant(const AttributeValue &p_attribute) {
	if (const bool *boolean = std::get_if<bool>(&p_attribute)) {
		return *boolean;
	}
	if (const double *number = std::get_if<double>(&p_attribute)) {
		return *number;
	}
	if (const std::string *text = std::get_if<std::string>(&p_attribute)) {
		return to_godot(*text);
	}
	return Variant();
}

static Dictionary to_dictionary(const playground::Attributes &p_attributes) {
	Dictionary dictionary;
	for (const auto &[key, value] : p_attributes) {
		dictionary[to_godot(key)] = to_variant(value);
	}
	return dictionary;
}

Error GAScene::set_entry_attribute(const String &p_name, const String &p_key, const Variant &p_value) {
	AttributeValue value;
	ERR_FAIL_COND_V_MSG(!to_attribute(p_value, value), godot::ERR_INVALID_PARAMETER, vformat(NO_ATTRIBUTE, "set_entry_attribute", p_key, Variant::get_type_name(p_value.get_type())));
	return finish(_document.set_attribute(to_utf8(p_name), to_utf8(p_key), value), "set_entry_attribute");
}

Variant GAScene::get_entry_attribute(const String &p_name, const String &p_key) const {
	const playground::Entry *entry = find(p_name, "get_entry_attribute");
	return entry ? to_variant(playground::get_attribute(entry->attributes, to_utf8(p_key))) : Variant();
}

Dictionary GAScene::get_entry_attributes(const String &p_name) const {
	const playground::Entry *entry = find(p_name, "get_entry_attributes");
	return entry ? to_dictionary(entry->attributes) : Dictionary();
}

Error GAScene::set_scene_attribute(const String &p_key, const Variant &p_value) {
	AttributeValue value;
	ERR_FAIL_COND_V_MSG(!to_attribute(p_value, value), godot::ERR_INVALID_PARAMETER, vformat(NO_ATTRIBUTE, "set_scene_attribute", p_key, Variant::get_type_name(p_value.get_type())));
	return finish(_document.set_document_attribute(to_utf8(p_key), value), "set_scene_attribute");
}

Variant GAScene::get_scene_attribute(const String &p_key) const {
	return to_variant(playground::get_attribute(_document.attributes(), to_utf8(p_key)));
}

Dictionary GAScene::get_scene_attributes() const {
	return to_dictionary(_document.attributes());
}

} // namespace ga_godot
