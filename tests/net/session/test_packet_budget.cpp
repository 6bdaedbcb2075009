#include "net/session/packet_budget.hpp"

#include <doctest/doctest.h>

using namespace net;

using Verdict = PacketBudget::Verdict;

TEST_CASE("packet budget: a peer may send its rate for any time, and half a second of it at once") {
	PacketBudget budget;
	double now = 100.0;
	for (int i = 0; i < 10000; ++i) {
		now += 1.001 / PacketBudget::MIN_RATE;
		REQUIRE(budget.take(100, 0, now) == Verdict::ACCEPTED);
		REQUIRE_FALSE(budget.is_busy(0, now));
	}
	now += 1.0;
	for (int i = 1; i < int(PacketBudget::BURST * PacketBudget::MIN_RATE); ++i) {
		REQUIRE(budget.take(100, 0, now) == Verdict::ACCEPTED);
	}
	CHECK(budget.is_busy(0, now));
	CHECK(budget.take(100, 0, now) == Verdict::FLOOD_BEGINS);
	CHECK(budget.take(100, 0, now) == Verdict::IGNORED);
}

TEST_CASE("packet budget: a flood is ignored as long as it lasts, and half a second more") {
	PacketBudget budget;
	double now = 0.0;
	int begun = 0;
	for (int i = 0; i < 100000; ++i) {
		now += 1e-4;
		begun += budget.take(1, 0, now) == Verdict::FLOOD_BEGINS ? 1 : 0;
	}
	CHECK(begun == 1);
	CHECK(budget.take(1, 0, now + PacketBudget::BURST - 0.01) == Verdict::IGNORED);
	CHECK(budget.take(1, 0, now + PacketBudget::BURST + 0.01) == Verdict::ACCEPTED);
}

TEST_CASE("packet budget: bodies raise the rate, and large packets count as several") {
	const auto accepted = [](size_t size, size_t bodies) {
		PacketBudget budget;
		int count = 0;
		while (budget.take(size, bodies, 1.0) == Verdict::ACCEPTED) {
			++count;
		}
		return count;
	};
	CHECK(accepted(1, 0) == 999);
	CHECK(accepted(1024, 0) == 999);
	CHECK(accepted(10240, 0) == 99);
	CHECK(accepted(1, 8000) == 4999);
	// Bodies that are added or removed do not give the burst again.
	PacketBudget budget;
	for (int i = 0; i < 999; ++i) {
		(void)budget.take(1, 0, 1.0);
	}
	CHECK(budget.take(1, 8, 1.0) == Verdict::ACCEPTED);
	CHECK(budget.take(1, 0, 1.0) == Verdict::FLOOD_BEGINS);
}
