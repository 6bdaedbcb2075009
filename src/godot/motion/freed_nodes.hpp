#pragma once

#include <atomic>
#include <cstdint>

namespace ga_godot {

/// Counts the freed ones among nodes, so that a loop over thousands of nodes notices cheaply when a callback frees one of them.
class FreedNodes {
public:
	/// Includes a node, by its instance id, in the count. Further calls do nothing.
	static void watch(uint64_t id);
	/// The number of watched nodes that were freed.
	[[nodiscard]] static uint64_t count() { return freed_count.load(std::memory_order_relaxed); }

private:
	static void *begin(void *token, void *object);
	static void end(void *token, void *object, void *binding);

	static inline std::atomic<uint64_t> freed_count = 0;
};

} // namespace ga_godot
