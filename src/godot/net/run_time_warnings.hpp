#pragma once

#include "godot/algebra/conversions.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cstddef>
#include <string>
#include <unordered_set>

namespace ga_godot {

/// Faults that show only while a game runs. Each is printed once, and no more than MAX_WARNINGS, as other peers cause some.
class RunTimeWarnings {
public:
	static constexpr size_t MAX_WARNINGS = 100;

	/// Prints a warning, and keeps it for get_setup_warnings().
	void warn(const std::string &key, const godot::String &text) {
		if (is_first(key)) {
			_texts.push_back(text);
			WARN_PRINT(godot::vformat("MotorSynchronizer: %s", text));
		}
	}
	/// True for the first call with a key, and false once there are MAX_WARNINGS.
	bool is_first(const std::string &key) { return _keys.size() < MAX_WARNINGS && _keys.insert(key).second; }
	[[nodiscard]] const godot::PackedStringArray &texts() const { return _texts; }

private:
	godot::PackedStringArray _texts;
	std::unordered_set<std::string> _keys;
};

} // namespace ga_godot
