#pragma once

#include <godot_cpp/variant/packed_byte_array.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace ga_godot {

[[nodiscard]] inline godot::PackedByteArray to_packed(const uint8_t *bytes, size_t size) {
	godot::PackedByteArray packed;
	packed.resize(int64_t(size));
	if (size > 0) {
		std::memcpy(packed.ptrw(), bytes, size);
	}
	return packed;
}

} // namespace ga_godot
