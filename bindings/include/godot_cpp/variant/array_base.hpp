#pragma once

#include <godot_cpp/variant/opaque.hpp>

#include <initializer_list>

namespace godot {

class StringName;
class Variant;

namespace internal {

// Members of Array that are not methods of the engine. Copies share their elements, as in scripts.
class ArrayBase : public Opaque<GDEXTENSION_VARIANT_TYPE_ARRAY, 8> {
public:
	using Opaque::Opaque;
	ArrayBase() = default;
	ArrayBase(std::initializer_list<Variant> p_elements);

	const Variant &operator[](int64_t p_index) const;
	Variant &operator[](int64_t p_index);

	const Variant *begin() const;
	const Variant *end() const;

	// Sets the element type of an empty array.
	void set_typed(uint32_t p_type, const StringName &p_class_name, const Variant &p_script);
};

// Members of Dictionary that are not methods of the engine. Copies share their entries, as in scripts.
class DictionaryBase : public Opaque<GDEXTENSION_VARIANT_TYPE_DICTIONARY, 8> {
public:
	using Opaque::Opaque;
	DictionaryBase() = default;

	const Variant &operator[](const Variant &p_key) const;
	Variant &operator[](const Variant &p_key);
};

} // namespace internal

} // namespace godot
