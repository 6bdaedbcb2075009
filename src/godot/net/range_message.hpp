#pragma once

#include "net/stream/setting_range.hpp"
#include "net/stream/steady_clock.hpp"

#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cstdio>

namespace ga_godot {

/// A number as people write it, for example 1e-06 or 0.005.
inline godot::String short_number(double value) {
	char text[32];
	std::snprintf(text, sizeof(text), "%.9g", value);
	return godot::String(text);
}

/// The error for a value of a property that is out of range. `subject` is the class.
inline godot::String range_message(const godot::String &subject, const char *property, double value, const net::SettingRange &range, const char *unit) {
	return godot::vformat("%s: %s is %s, but must be %s to %s %s.", subject, property, short_number(value), short_number(range.min), short_number(range.max), unit);
}

/// The error for a time for which net::is_valid_time() is false. `method` is the method that got it.
inline godot::String time_message(const char *method, double time) {
	return godot::vformat("%s: the time is %s, but must be -1e12 to 1e12 seconds.", method, short_number(time));
}

} // namespace ga_godot
