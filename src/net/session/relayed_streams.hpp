#pragma once

#include "net/endpoint/receiver.hpp"
#include "net/session/section.hpp"
#include "net/session/session_statistics.hpp"
#include "net/session/traffic_meter.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace net {

/// The client's side of relaying: the streams of other owners that the server forwards.
class RelayedStreams {
public:
	/// Maximum number of streams, and of bodies in all of them. They bound the memory that the server can make a client allocate.
	static constexpr size_t MAX_STREAMS = 256;
	static constexpr size_t MAX_BODIES = 131072;
	/// Maximum number of bodies in a stream.
	static constexpr size_t MAX_STREAM_BODIES = 65536;
	/// The server's PeerId.
	static constexpr PeerId SERVER = 1;

	struct Stream {
		explicit Stream(std::shared_ptr<WorkBudget> work) :
				receiver(MAX_STREAM_BODIES, std::move(work)) {}

		uint32_t channel = 0;
		Receiver receiver;
		TrafficMeter received;
		uint64_t unauthorized_bodies = 0;
		size_t held_bodies = 0; ///< of the receiver, after the last packet
	};

	/// See Receiver::set_margin_limits.
	void set_margin_limits(double min, double max);
	/// Ends all streams.
	void clear();
	/// Processes the sections of a packet. Those of the server's own stream go to `server`.
	PacketResult accept(PeerId self, const uint8_t *bytes, size_t size, double now, Receiver &server);
	/// Ends the stream of a channel.
	void end(uint32_t channel, double now);

	/// Advances playback and calls visit(owner, stream) for each stream.
	template <class Visit>
	void advance(double now, Visit &&visit) {
		for (auto &[owner, stream] : _streams) {
			stream.receiver.advance(now);
			visit(owner, stream);
		}
	}
	/// Calls send(bytes, size) for each packet of acknowledgements that is due, those of `server` included.
	template <class Send>
	void send_acks(double now, size_t max_size, Receiver &server, Send &&send) {
		collect_acks(now, server);
		pack_sections(_sections, _bytes, max_size, _packet, send);
	}

	/// The stream of an owner; null if the server does not forward one.
	[[nodiscard]] Stream *find(PeerId owner) {
		const auto found = _streams.find(owner);
		return found != _streams.end() ? &found->second : nullptr;
	}
	[[nodiscard]] const Stream *find(PeerId owner) const { return const_cast<RelayedStreams *>(this)->find(owner); }
	/// The owners of all streams, in ascending order.
	[[nodiscard]] std::vector<PeerId> owners() const;
	/// Statistics of the stream of an owner. Received bytes are those of its sections.
	[[nodiscard]] SessionStatistics statistics(PeerId owner, double now);
	/// Totals over all streams, with the late windows of those that have ended, but without their bytes and packets, which are also
	/// those of the server.
	[[nodiscard]] SessionStatistics total_statistics(double now);

private:
	/// For this many seconds after a stream has ended, its late packets are ignored.
	static constexpr double LATE_PACKET_TIME = 2.0;

	PacketResult accept_section(PeerId self, const Section &section, const uint8_t *bytes, double now);
	PacketResult open(PeerId owner, uint32_t channel, double now);
	void remove(PeerId owner);
	void collect_acks(double now, Receiver &server);
	void add_ack(uint32_t channel, Receiver &receiver, double now);

	std::map<PeerId, Stream> _streams; // by owner
	std::map<uint32_t, PeerId> _channels; // owners by channel
	std::map<uint32_t, double> _ended; // when channels ended, for LATE_PACKET_TIME
	double _min_margin = 0.0;
	double _max_margin = -1.0;
	size_t _held_bodies = 0; // over all streams, see Receiver::held_bodies()
	std::shared_ptr<WorkBudget> _work = std::make_shared<WorkBudget>(ReceiverBudget::MAX_WORK, ReceiverBudget::BURST); // of all streams
	uint64_t _late = 0;
	std::vector<Section> _sections;
	std::vector<uint8_t> _bytes;
	std::vector<uint8_t> _ack;
	std::vector<uint8_t> _packet;
};

} // namespace net
