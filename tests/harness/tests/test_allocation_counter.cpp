#include "../allocation_counter.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <new>
#include <vector>

TEST_CASE("allocation counter: counts calls, and bytes until they are freed") {
	const uint64_t count = harness::allocation_count();
	const size_t live = harness::live_bytes();
	auto bytes = std::make_unique<std::vector<char>>(10000);
	const uint64_t allocated = harness::allocation_count() - count;
	const size_t used = harness::live_bytes() - live;
	bytes.reset();
	const size_t left = harness::live_bytes() - live;
	CHECK(allocated == 2);
	CHECK(used >= 10000);
	CHECK(used < 11000);
	CHECK(left == 0);
}

TEST_CASE("allocation counter: all forms of the operators") {
	const uint64_t count = harness::allocation_count();
	const size_t live = harness::live_bytes();
	// Called as functions, because the compiler may leave out the allocation of an expression.
	void *const single = ::operator new(100, std::nothrow);
	void *const array = ::operator new[](100);
	void *const other = ::operator new[](100, std::nothrow);
	const uint64_t allocated = harness::allocation_count() - count;
	const size_t used = harness::live_bytes() - live;
	::operator delete(single);
	::operator delete[](array);
	::operator delete[](other);
	CHECK(allocated == 3);
	CHECK(used >= 300);
	CHECK(harness::live_bytes() == live);
}
