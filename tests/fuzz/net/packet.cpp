// The packets of a stream: any bytes, to the parser and to a receiver without state.

#include "motion.hpp"

#include "net/endpoint/receiver.hpp"

void fuzz::run(Input input) {
	const Bytes bytes = input.rest();
	net::PacketContent content;
	const bool is_valid = net::read_packet(bytes.data(), bytes.size(), content).has_value();
	const uint8_t *end = bytes.data() + bytes.size();
	for (const net::ChunkItem &chunk : content.chunks) {
		require(!is_valid || (chunk.bytes >= bytes.data() && chunk.bytes + chunk.size <= end), "a chunk is not in the packet");
	}
	for (const net::FragmentItem &fragment : content.fragments) {
		require(!is_valid || (fragment.bytes >= bytes.data() && fragment.bytes + fragment.size <= end), "a fragment is not in the packet");
	}
	require(std::isfinite(content.round_trip), "the round trip is not finite");
	require(!content.alignment || (std::isfinite(content.alignment->period) && std::isfinite(content.alignment->shift)), "the alignment is not finite");

	net::Receiver receiver(16);
	(void)receiver.accept(bytes.data(), bytes.size(), 1.0);
	Bytes ack;
	receiver.take_ack(ack, 1.0);
	receiver.advance(1.0 + TICK);
	require(ack.size() <= 256, "an acknowledgement has more than 256 bytes");
	require(std::isfinite(receiver.media_time()), "the media time is not finite");
}
