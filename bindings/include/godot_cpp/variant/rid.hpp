#pragma once

#include <cstdint>

namespace godot {

// A handle of a resource in one of the engine's servers. Not reference-counted: the server's free_rid() frees it.
struct RID {
	RID() = default;

	bool is_valid() const { return _id != 0; }
	int64_t get_id() const { return static_cast<int64_t>(_id); }

private:
	uint64_t _id = 0;
};

} // namespace godot
