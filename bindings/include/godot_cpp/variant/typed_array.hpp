#pragma once

#include <godot_cpp/variant/variant.hpp>

namespace godot {

namespace internal {

template <typename T>
struct Arg;

} // namespace internal

// An Array with elements of type T: a class (without the pointer) or a built-in type.
template <typename T>
class TypedArray : public Array {
	void set_type();

public:
	TypedArray() { set_type(); }

	// Shares the elements if p_array has the same type; otherwise copies and converts them. If the engine cannot convert
	// an element, it prints an error and the array stays empty. Calls from scripts can pass both.
	TypedArray(const Array &p_array) {
		set_type();
		if (is_same_typed(p_array)) {
			Array::operator=(p_array);
		} else {
			assign(p_array);
		}
	}

	TypedArray(const Variant &p_variant) :
			TypedArray(Array(p_variant)) {}
};

} // namespace godot
