#include "allocation_counter.hpp"

#include <cstdlib>
#include <new>

namespace {

uint64_t count = 0; // the program has one thread

void *allocate(size_t size) {
	++count;
	if (void *memory = std::malloc(size > 0 ? size : 1)) {
		return memory;
	}
	throw std::bad_alloc();
}

} // namespace

uint64_t bench::allocation_count() {
	return count;
}

// The array forms and those that do not throw call these.
void *operator new(size_t size) {
	return allocate(size);
}

void operator delete(void *memory) noexcept {
	std::free(memory);
}

void operator delete(void *memory, size_t) noexcept {
	std::free(memory);
}
