#pragma once

#include "net/delivery/delivery.hpp"
#include "net/endpoint/receiver.hpp"
#include "net/stream/packet_error.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace net {

/// Forwards the stream that a Receiver decodes to any number of further receivers: the windows as they were encoded, after the
/// Receiver has checked them. Each hop retransmits what it has lost; snapshots are made from the decoded state. `time` is in
/// seconds of local time.
class ForwardedStream {
public:
	/// `source` must record its windows and exist as long as this object.
	explicit ForwardedStream(Receiver &source) :
			_source(source) {}

	void add_receiver(uint32_t receiver, double time);
	void remove_receiver(uint32_t receiver) { _receivers.erase(receiver); }
	/// While a stream is held, nothing is forwarded. After that, each receiver gets a snapshot.
	void set_held(bool held, double time);
	[[nodiscard]] bool is_held() const { return _is_held; }

	/// Sends the receiver a snapshot instead of anything that is in flight.
	void resend_all(uint32_t receiver);

	/// Prepares what is due at `time`: call it before `send`. Packets have at most `max_size` bytes.
	void update(double time, size_t max_size);
	/// Appends all packets that are due for a receiver to `bytes` and calls packet_done(begin, size) for each.
	template <class PacketDone>
	void send(uint32_t receiver, double time, size_t max_size, std::vector<uint8_t> &bytes, PacketDone &&packet_done) {
		const auto found = _receivers.find(receiver);
		if (found != _receivers.end() && _source.is_ready() && !_is_held) {
			found->second.send(*_source.recorded(), time, max_size, bytes, packet_done);
		}
	}
	/// Processes the acknowledgements in a packet from a receiver.
	void accept(uint32_t receiver, PacketContent &acks, double time);

private:
	void restart(double time);

	Receiver &_source;
	std::map<uint32_t, Delivery> _receivers;
	uint32_t _source_snapshots = 0; // number of the source's snapshot that the deliveries continue from
	uint8_t _snapshot_number = 0; // of the last snapshot sent
	bool _is_held = false;
};

} // namespace net
