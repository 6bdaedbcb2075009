#include "../hostile_run.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace bench;

namespace {

constexpr double MAX_MEMORY = 16e6; // bytes that a hostile peer can make the server allocate
constexpr double MAX_ERROR_P99 = 0.010; // meters, at honest peers
constexpr double MAX_STALL = 0.1; // seconds, there
constexpr double MAX_HONEST_RATIO = 1.1; // of the bytes to honest peers, with and without the attack
constexpr double MAX_AMPLIFICATION = 4.0;
constexpr double MAX_BYTES_UNASKED = 60.0; // what a session sends to each peer in 10 s: requests for the peer's own stream

} // namespace

TEST_CASE("hostile: an owner that sends 10,000 packets a second costs little memory, and honest peers nothing") {
	for (size_t attack = 0; attack < size_t(Attack::COUNT); ++attack) {
		const std::string name = attack_name(Attack(attack));
		CAPTURE(name);
		HostileScenario scenario;
		scenario.attack = Attack(attack);
		scenario.bodies = 200;
		scenario.seconds = 2.0;
		scenario.memory_limit = 1e8;
		scenario.cpu_limit = 30.0;
		const HostileResult result = run_hostile(scenario);
		CHECK(result.during.memory - result.before.memory <= MAX_MEMORY);
		CHECK(result.during.error_p99 <= MAX_ERROR_P99);
		CHECK(result.during.longest_stall <= MAX_STALL);
		CHECK(result.during.client_bytes_per_second <= MAX_HONEST_RATIO * result.before.client_bytes_per_second);
	}
}

TEST_CASE("hostile: a peer that acknowledges nothing draws few bytes") {
	CHECK(4.0 * measure_amplification(1000, 1, 0.0).ratio <= MAX_BYTES_UNASKED); // one request has 4 bytes
	CHECK(measure_amplification(1000, 27, 0.25).ratio <= MAX_AMPLIFICATION);
}
