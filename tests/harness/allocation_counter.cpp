#include "allocation_counter.hpp"

#include <malloc.h>

#include <cstdlib>
#include <new>

namespace {

uint64_t count = 0;
size_t live = 0;

void *allocate(size_t size) noexcept {
	void *memory = std::malloc(size == 0 ? 1 : size);
	if (memory != nullptr) {
		++count;
		live += malloc_usable_size(memory);
	}
	return memory;
}

} // namespace

namespace harness {

uint64_t allocation_count() {
	return count;
}

size_t live_bytes() {
	return live;
}

} // namespace harness

// All forms but the aligned ones. The standard library's array and nothrow forms would call these, the address sanitizer's not.
void *operator new(size_t size) {
	void *memory = allocate(size);
	if (memory == nullptr) {
		throw std::bad_alloc();
	}
	return memory;
}

void *operator new(size_t size, const std::nothrow_t &) noexcept {
	return allocate(size);
}

void *operator new[](size_t size) {
	return operator new(size);
}

void *operator new[](size_t size, const std::nothrow_t &) noexcept {
	return allocate(size);
}

void operator delete(void *memory) noexcept {
	live -= memory != nullptr ? malloc_usable_size(memory) : 0;
	std::free(memory);
}

void operator delete(void *memory, size_t) noexcept {
	operator delete(memory);
}

void operator delete(void *memory, const std::nothrow_t &) noexcept {
	operator delete(memory);
}

void operator delete[](void *memory) noexcept {
	operator delete(memory);
}

void operator delete[](void *memory, size_t) noexcept {
	operator delete(memory);
}

void operator delete[](void *memory, const std::nothrow_t &) noexcept {
	operator delete(memory);
}
