#include "allocation_counter.hpp"

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

uint64_t count = 0;
size_t live = 0;

// Before each block: its size, as only some systems tell it.
constexpr size_t HEADER = alignof(std::max_align_t);

void *allocate(size_t size) noexcept {
	void *memory = std::malloc(HEADER + size);
	if (memory == nullptr) {
		return nullptr;
	}
	++count;
	live += size;
	*static_cast<size_t *>(memory) = size;
	return static_cast<char *>(memory) + HEADER;
}

void release(void *memory) noexcept {
	if (memory == nullptr) {
		return;
	}
	void *block = static_cast<char *>(memory) - HEADER;
	live -= *static_cast<size_t *>(block);
	std::free(block);
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
	release(memory);
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
