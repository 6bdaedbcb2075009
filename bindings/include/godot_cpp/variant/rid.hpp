#pragma once

#include <cstdint>

namespace godot {

// A resource of one of the engine's servers. Nobody counts who holds it: free it with its server.
struct RID {
	RID() = default;

	bool is_valid() const { return id != 0; }
	int64_t get_id() const { return static_cast<int64_t>(id); }

	bool operator==(const RID &p_other) const { return id == p_other.id; }
	bool operator!=(const RID &p_other) const { return id != p_other.id; }
	bool operator<(const RID &p_other) const { return id < p_other.id; }

private:
	uint64_t id = 0;
};

} // namespace godot
