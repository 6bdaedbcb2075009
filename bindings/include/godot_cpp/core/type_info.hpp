#pragma once

#include <cstdint>

namespace godot {

// A combination of flags of an enum that the engine declares as a bit field.
template <typename T>
class BitField {
	int64_t _value = 0;

public:
	constexpr BitField() = default;
	constexpr BitField(int64_t p_value) :
			_value(p_value) {}
	constexpr BitField(T p_flag) :
			_value(static_cast<int64_t>(p_flag)) {}

	constexpr operator int64_t() const { return _value; }
};

} // namespace godot
