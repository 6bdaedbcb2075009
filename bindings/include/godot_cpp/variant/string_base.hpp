#pragma once

#include <godot_cpp/variant/opaque.hpp>

#include <string>

namespace godot {

namespace internal {
class StringBase;
}

class String;
class StringName;
class Variant;

// Zero-terminated text; get_data() is valid while this object lives.
class CharString {
	std::string _text;

	friend class internal::StringBase;

public:
	const char *get_data() const { return _text.c_str(); }
	int64_t length() const { return static_cast<int64_t>(_text.size()); }
};

namespace internal {

// Members of String that are not methods of the engine.
class StringBase : public Opaque<GDEXTENSION_VARIANT_TYPE_STRING, 8> {
public:
	using Opaque::Opaque;
	StringBase() = default;

	// Latin-1, as in godot-cpp; use String::utf8 for other text.
	StringBase(const char *p_latin1);

	static String utf8(const char *p_utf8, int64_t p_length = -1);
	CharString utf8() const;

	String &operator+=(const String &p_other);
};

// Members of StringName that are not methods of the engine.
class StringNameBase : public Opaque<GDEXTENSION_VARIANT_TYPE_STRING_NAME, 8> {
public:
	using Opaque::Opaque;
	StringNameBase() = default;

	// Set p_static for names that are never destroyed and whose text outlives the library.
	StringNameBase(const char *p_latin1, bool p_static = false);

	// Equal names have the same handle.
	bool operator==(const StringNameBase &p_other) const { return is_same_handle(p_other); }
	bool operator!=(const StringNameBase &p_other) const { return !is_same_handle(p_other); }
};

} // namespace internal

} // namespace godot
