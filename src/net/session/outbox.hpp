#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

using PeerId = int32_t;

/// The packets that a session wants to send. The caller drains it: a transport may call back into the session.
class Outbox {
public:
	struct Packet {
		PeerId peer;
		bool reliable;
		size_t begin;
		size_t size;
	};

	/// Adds a packet of `size` bytes and returns where to write it, until the next call.
	[[nodiscard]] uint8_t *add(PeerId peer, bool reliable, size_t size) {
		const size_t begin = _bytes.size();
		_packets.push_back({ peer, reliable, begin, size });
		_bytes.resize(begin + size);
		return _bytes.data() + begin;
	}

	/// Calls send(packet, bytes) for each packet and empties the outbox. `send` may add further packets: they stay.
	template <class Send>
	void drain(Send &&send) {
		std::vector<Packet> packets;
		std::vector<uint8_t> bytes;
		packets.swap(_packets);
		bytes.swap(_bytes);
		for (const Packet &packet : packets) {
			send(packet, bytes.data() + packet.begin);
		}
		if (_packets.empty()) {
			// Keep the memory: a steady stream does not allocate.
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
