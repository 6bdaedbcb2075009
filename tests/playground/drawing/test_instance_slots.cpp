#include "playground/drawing/instance_slots.hpp"

#include <doctest/doctest.h>

#include <random>
#include <vector>

using playground::drawing::InstanceSlots;

TEST_CASE("the last instance takes the place of a removed one") {
	InstanceSlots slots;
	const size_t a = slots.add(), b = slots.add(), c = slots.add();
	CHECK(slots.size() == 3);
	CHECK(slots.slot_of(c) == 2);
	CHECK(slots.remove(a) == 0);
	CHECK(slots.size() == 2);
	CHECK(slots.slot_of(c) == 0);
	CHECK(slots.slot_of(b) == 1);
	// The last one leaves without a move.
	const size_t freed = slots.remove(b);
	CHECK(freed == slots.size());
	CHECK(slots.slot_of(c) == 0);
	CHECK(slots.remove(c) == 0);
	CHECK(slots.size() == 0);
}

TEST_CASE("slots stay dense and tell owners apart, whatever comes and goes") {
	std::mt19937 random(2026);
	InstanceSlots slots;
	std::vector<size_t> owners;
	std::vector<size_t> row; // what a row of instances would hold, kept as the comments say
	for (int step = 0; step < 5000; ++step) {
		if (owners.empty() || random() % 100 < 52) {
			owners.push_back(slots.add());
			row.push_back(owners.back());
		} else {
			const size_t index = random() % owners.size();
			const size_t slot = slots.remove(owners[index]);
			row[slot] = row.back();
			row.pop_back();
			owners.erase(owners.begin() + ptrdiff_t(index));
		}
		REQUIRE(slots.size() == owners.size());
		REQUIRE(slots.size() == row.size());
		for (const size_t owner : owners) {
			REQUIRE(row[slots.slot_of(owner)] == owner);
		}
	}
}
