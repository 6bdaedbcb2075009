#pragma once

#include "net/delivery/packet.hpp"
#include "net/session/envelope.hpp"
#include "net/stream/stream_encoder.hpp"

#include "../../harness/random_bits.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace bench {

/// What a hostile owner of one body sends. All packets are well-formed.
enum class Attack : uint8_t {
	FRESH_IDS, ///< whole snapshots, each with new bodies and one tick later
	EMPTY_WINDOWS, ///< snapshots of 4,128 bodies, each followed by 40 packets of 127 windows in which nothing moves
	RESTARTED_SNAPSHOTS, ///< packets of one-byte fragments; every 64th packet begins another snapshot
	OPENS, ///< requests for a stream, each with another link
	SNAPSHOT_REQUESTS, ///< requests for a snapshot of the stream that the peer receives
	RANDOM_ACKS, ///< acknowledgements of random chunks
	RANDOM_BYTES, ///< motion packets of random bytes
	COUNT
};

[[nodiscard]] const char *attack_name(Attack attack);

/// Makes the packets of an attack.
class HostilePeer {
public:
	HostilePeer(Attack attack, uint64_t seed) :
			_attack(attack), _random(seed) {}

	/// Takes a packet from the server: learns the link that the server requests, and starts again if it is new.
	void hear(const uint8_t *bytes, size_t size);
	/// A request for the server's stream.
	[[nodiscard]] std::vector<uint8_t> open() const;
	/// The next packet of the attack.
	[[nodiscard]] std::vector<uint8_t> next();

private:
	using Bytes = std::vector<uint8_t>;

	struct EmptyWindow {
		Bytes bytes;
		uint8_t check = 0; // of the state after it
	};

	[[nodiscard]] Bytes begin(net::PacketKind kind, uint8_t link) const;
	/// Queues a snapshot of this content after the header.
	void queue_snapshot(const Bytes &content);
	void queue_fresh_snapshot();
	void encode_windows();
	[[nodiscard]] Bytes empty_windows();
	[[nodiscard]] Bytes restarted_fragments();
	[[nodiscard]] Bytes random_ack();
	[[nodiscard]] Bytes random_bytes();

	Attack _attack;
	harness::RandomBits _random;
	std::deque<Bytes> _queue; // packets of a snapshot
	Bytes _many_bodies; // content of a snapshot
	std::vector<EmptyWindow> _windows; // after it
	uint8_t _link = 0; // of the stream that the server requests
	uint8_t _own_link = 1; // of the stream that this peer requests
	uint32_t _snapshot = 0; // number of the last snapshot
	uint32_t _chunk = 0; // number of the next chunk
	uint32_t _tick = 1000;
	uint32_t _next_id = 1000000;
	size_t _next_window = 0;
	bool _needs_snapshot = true; // before the next window
	uint64_t _sent = 0;
};

} // namespace bench
