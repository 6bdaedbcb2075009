#pragma once

#include "net/delivery/packet.hpp"
#include "net/session/envelope.hpp"
#include "net/stream/stream_encoder.hpp"

#include "../../harness/random_bits.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace bench {

/// What a hostile owner of one body sends. All packets are well-formed.
enum class Attack : uint8_t {
	FRESH_IDS, ///< whole snapshots, each with new bodies and one tick later
	REVERSED_SNAPSHOTS, ///< the same, fragments in reverse order
	REPEATED_SNAPSHOT, ///< one snapshot, again and again
	EMPTY_WINDOWS, ///< snapshots of 4,128 bodies, each followed by 40 packets of 127 windows in which nothing moves
	BUSY_WINDOWS, ///< snapshots of 4,128 bodies, each followed by windows in which all of them move
	RESTARTED_SNAPSHOTS, ///< packets of one-byte fragments; every 64th packet begins another snapshot
	SMALL_CHUNKS, ///< packets of 210 chunks without bytes
	LARGE_PACKETS, ///< packets of 64,000 bytes, fragments of a snapshot that never ends
	OPENS, ///< requests for a stream, each with another link
	STREAM_SWITCHES, ///< requests for a stream, which the peer ends as soon as it begins
	SNAPSHOT_REQUESTS, ///< requests for a snapshot of the stream that the peer receives
	RANDOM_ACKS, ///< acknowledgements of random chunks
	GAP_ACKS, ///< acknowledgements of every second chunk
	LARGE_ACKS, ///< packets of 8,000 acknowledgements
	RANDOM_BYTES, ///< motion packets of random bytes
	MIXTURE, ///< of all others
	COUNT
};

[[nodiscard]] const char *attack_name(Attack attack);

/// Makes the packets of an attack.
class HostilePeer {
public:
	HostilePeer(Attack attack, uint64_t seed) :
			_attack(attack), _random(seed) {}

	/// Takes a packet from the server: learns the link that the server requests, starts again if it is new, and learns the token that a
	/// request needs.
	void hear(const uint8_t *bytes, size_t size);
	/// A request for the server's stream.
	[[nodiscard]] std::vector<uint8_t> open() const;
	/// The next packet of the attack.
	[[nodiscard]] std::vector<uint8_t> next();

private:
	using Bytes = std::vector<uint8_t>;

	struct Window {
		Bytes bytes;
		uint8_t check = 0; // of the state after it
	};

	[[nodiscard]] static Bytes begin(net::PacketKind kind, uint8_t link);
	[[nodiscard]] Bytes make(Attack attack);
	[[nodiscard]] Bytes from_queue(Attack attack);
	/// Queues a snapshot of this content after the header.
	void queue_snapshot(const Bytes &content);
	void queue_fresh_snapshot();
	void queue_windows(Attack attack);
	void encode_windows(Attack attack);
	[[nodiscard]] Bytes restarted_fragments();
	[[nodiscard]] Bytes small_chunks();
	[[nodiscard]] Bytes large_packet();
	/// A request for the server's stream with the token that the server has asked for; without one, with a new link.
	[[nodiscard]] Bytes subscribe();
	[[nodiscard]] Bytes switch_stream();
	[[nodiscard]] Bytes acknowledge(Attack attack);
	[[nodiscard]] Bytes random_bytes();

	Attack _attack;
	harness::RandomBits _random;
	std::deque<Bytes> _queue; // packets of a snapshot and windows
	Bytes _many_bodies; // content of a snapshot
	std::vector<Window> _windows; // after it
	uint8_t _link = 0; // of the stream that the server requests
	uint8_t _own_link = 1; // of the stream that this peer requests
	std::optional<uint16_t> _token; // that the server has asked for
	bool _is_subscribed = false; // the token was sent
	uint32_t _snapshot = 0; // number of the last snapshot
	uint32_t _chunk = 0; // number of the next chunk
	uint32_t _tick = 1000;
	uint32_t _next_id = 1000000;
	uint64_t _sent = 0;
	size_t _next_kind = 0; // of a mixture
};

} // namespace bench
