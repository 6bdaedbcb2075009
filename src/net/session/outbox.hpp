#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace net {

using PeerId = int32_t;

/// Queue of outgoing packets. The caller drains it, because a transport may call back into the session while sending.
class Outbox {
public:
	struct Packet {
		PeerId peer;
		bool reliable;
		size_t begin;
		size_t size;
	};

	/// Adds a packet of `size` bytes and returns a pointer to its bytes, valid until the next call.
	[[nodiscard]] uint8_t *add(PeerId peer, bool reliable, size_t size) {
		const size_t begin = _bytes.size();
		_packets.push_back({ peer, reliable, begin, size });
		_bytes.resize(begin + size);
		return _bytes.data() + begin;
	}

	/// Calls send(packet, bytes) for each packet and empties the outbox. Packets added by `send` remain queued.
	template <class Send>
	void drain(Send &&send) {
		std::vector<Packet> packets = std::exchange(_packets, {});
		std::vector<uint8_t> bytes = std::exchange(_bytes, {});
		for (const Packet &packet : packets) {
			send(packet, bytes.data() + packet.begin);
		}
		if (_packets.empty()) {
			// Reuse the memory, so that a steady stream does not allocate.
			packets.clear();
			bytes.clear();
			packets.swap(_packets);
			bytes.swap(_bytes);
		}
	}

private:
	std::vector<Packet> _packets;
	std::vector<uint8_t> _bytes;
};

} // namespace net
