// Two honest sessions and a hostile peer, with authority over bodies or without, and with relaying or without. The honest
// sessions' streams go on, and memory is bounded and released when the peer leaves.

#include "session_target.hpp"

void fuzz::run(Input input) {
	static const std::vector<Bytes> RECORDED[] = { record_session(false), record_session(true) };
	const bool has_authority = input.flag();
	const bool relay = input.flag();
	SessionTarget target(has_authority, relay);
	const size_t before = live_bytes();
	std::optional<HostilePackets> packets(std::in_place, RECORDED[relay ? 1 : 0], input);
	for (int count = 0; !input.is_empty() && count < 48; ++count) {
		Bytes packet = packets->next();
		target.attack(packet);
		require(live_bytes() < before + 4000000, "the hostile peer makes the session use 4 MB or more");
	}
	packets.reset();
	target.end();
	require(live_bytes() < before + 100000, "the memory of a peer that has left is not released");
}
