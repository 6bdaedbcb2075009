#include "playground/drawing/instance_slots.hpp"

#include <doctest/doctest.h>

#include <random>
#include <vector>

using playground::drawing::InstanceSlots;

TEST_CASE("the last instance moves into the slot of a removed one") {
	InstanceSlots slots;
	const size_t a = slots.add(), b = slots.add(), c = slots.add();
	CHECK(slots.size() == 3);
	CHECK(slots.slot_of(c) == 2);
	CHECK(slots.remove(a) == 0);
	CHECK(slots.size() == 2);
	CHECK(slots.slot_of(c) == 0);
	CHECK(slots.slot_of(b) == 1);
	// Removing the last slot moves nothing.
	const size_t freed = slots.remove(b);
	CHECK(freed == slots.size());
	CHECK(slots.slot_of(c) == 0);
	CHECK(slots.remove(c) == 0);
	CHECK(slots.size() == 0);
}

TEST_CASE("slots stay dense and distinct after any sequence of additions and removals") {
	std::mt19937 random(2026);
	InstanceSlots slots;
	std::vector<size_t> owners;
	std::vector<size_t> instances; // the owner of each slot, updated as the caller of remove() must
	for (int step = 0; step < 5000; ++step) {
		if (owners.empty() || random() % 100 < 52) {
			owners.push_back(slots.add());
			instances.push_back(owners.back());
		} else {
			const size_t index = random() % owners.size();
			const size_t slot = slots.remove(owners[index]);
			instances[slot] = instances.back();
			instances.pop_back();
			owners.erase(owners.begin() + ptrdiff_t(index));
		}
		REQUIRE(slots.size() == owners.size());
		REQUIRE(slots.size() == instances.size());
		for (const size_t owner : owners) {
			REQUIRE(instances[slots.slot_of(owner)] == owner);
		}
	}
}
