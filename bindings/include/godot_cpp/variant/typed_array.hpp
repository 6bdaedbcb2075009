#pragma once

#include <godot_cpp/variant/variant.hpp>

namespace godot {

namespace internal {

template <typename T, typename>
struct Arg;

} // namespace internal

// An Array whose elements are all T: a class, without the star, or a built-in type.
template <typename T>
class TypedArray : public Array {
	void set_type();

public:
	TypedArray() { set_type(); }

	// Shares the elements where p_array has the same type, and copies and converts them where it has not. The engine
	// reports what it cannot convert, and the array stays empty. A script's call may hand over either.
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

	TypedArray(std::initializer_list<Variant> p_elements) :
			TypedArray(Array(p_elements)) {}
};

} // namespace godot
