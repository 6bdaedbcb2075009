#include "allocation_counter.hpp"

#include <malloc.h>

#include <cstdlib>
#include <new>

namespace {

uint64_t count = 0;
size_t live = 0;

} // namespace

namespace harness {

uint64_t allocation_count() {
	return count;
}

size_t live_bytes() {
	return live;
}

} // namespace harness

// The standard library's array and nothrow forms call these.
void *operator new(size_t size) {
	void *memory = std::malloc(size == 0 ? 1 : size);
	if (memory == nullptr) {
		throw std::bad_alloc();
	}
	++count;
	live += malloc_usable_size(memory);
	return memory;
}

void operator delete(void *memory) noexcept {
	live -= memory != nullptr ? malloc_usable_size(memory) : 0;
	std::free(memory);
}

void operator delete(void *memory, size_t) noexcept {
	operator delete(memory);
}
