#pragma once

#include "net/endpoint/receiver.hpp"
#include "net/endpoint/sender.hpp"
#include "net/session/packet_budget.hpp"
#include "net/session/rejections.hpp"
#include "net/session/repetition.hpp"
#include "net/session/session_statistics.hpp"
#include "net/session/traffic_meter.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace net {

/// A session's state for one connected peer.
struct Peer {
	/// Maximum pause between two OPEN packets, in seconds.
	static constexpr double MAX_OPEN_INTERVAL = 4.0;
	static constexpr double MAX_REFUSAL_PAUSE = 30.0;
	/// After a stream of so many seconds, its next refusal is a first one again.
	static constexpr double REFUSAL_MEMORY = 120.0;
	/// For this many seconds after a stream has ended, its late packets are ignored instead of rejected.
	static constexpr double LATE_PACKET_TIME = 2.0;
	/// Work of decoding per second for a peer of which we know no bodies, and seconds of it that can be done at once. 2,000 bodies that
	/// move cost 700,000.
	static constexpr double MIN_WORK = 1e6;
	static constexpr double BURST = 0.05;
	/// A snapshot is decoded at once if it takes no more work than this for each body that we know.
	static constexpr double MAX_PROMPT_WORK = 4096.0;
	struct EndedStream {
		uint8_t link = 0;
		double time = -1e9;
	};

	TrafficMeter sent;
	TrafficMeter received;
	Rejections rejections;
	std::array<EndedStream, 16> ended; ///< the last streams that have ended, in either direction; at most 5 a second do
	size_t next_ended = 0;

	// Our stream to the peer.
	std::optional<uint8_t> requested; ///< link of the stream that the peer has requested last
	std::optional<uint16_t> token; ///< that the peer has to repeat to request `challenged`
	uint8_t challenged = 0; ///< link
	bool subscribed = false;
	uint8_t subscription = 0; ///< link of the stream
	double subscribed_at = -1e9;

	// Relaying.
	std::optional<uint8_t> relay_link; ///< link of the client to which we, the server, relay
	double relayed_at = -1e9; ///< when that began
	double acked_at = -1e9; ///< when its stream was last acknowledged
	uint8_t stream_version = 0; ///< of the peer's last packet with another one than ours
	std::optional<bool> relay; ///< whether the peer relays, as its last OPEN says

	// The peer's stream to us.
	uint8_t link = 0; ///< of the stream that we request
	int opens_sent = 0; ///< with this link
	double opened_at = -1e9; ///< when the last was sent
	bool is_request_known = false; ///< the peer has challenged it
	std::optional<Receiver> stream; ///< from its first packet on
	PacketBudget packets; ///< of all kinds
	std::shared_ptr<WorkBudget> work = std::make_shared<WorkBudget>(MIN_WORK, BURST); ///< of decoding all its streams
	Repetition open{ MAX_OPEN_INTERVAL };
	bool is_refused = false; ///< the last stream was refused
	size_t refused_size = 0; ///< number of its bodies
	double refused_at = -1e9;
	double refusal_pause = Repetition::FIRST; ///< seconds from the next refusal to the next OPEN
	uint64_t unauthorized_bodies = 0;

	/// Limits the work of decoding the peer's streams to that of `bodies` bodies. Decoding waits while packets arrive that may be a flood.
	void limit_work(size_t bodies, double now) {
		work->set_rate(ReceiverBudget::work_rate(bodies) - ReceiverBudget::MIN_WORK + MIN_WORK);
		work->set_max_prompt(BURST * MIN_WORK + MAX_PROMPT_WORK * double(bodies));
		work->hold(packets.is_busy(bodies, now));
	}

	/// Requests a new stream from now on. All sessions of a process number their links in one sequence, with a time-dependent start, so
	/// that packets of an earlier stream are not mistaken for those of a new one.
	void request_stream(double now) {
		static std::atomic<uint8_t> last_link = uint8_t(int64_t(now * 1e3)); // sessions may run in several threads
		link = ++last_link;
		opens_sent = 0;
		is_request_known = false;
		open.restart(now);
	}
	[[nodiscard]] bool is_open_sent() const { return opens_sent > 0; }
	[[nodiscard]] bool is_subscribed(uint8_t to_link) const { return subscribed && subscription == to_link; }
	void note_end(uint8_t of_link, double now) { ended[next_ended++ % ended.size()] = { of_link, now }; }
	[[nodiscard]] bool ended_recently(uint8_t of_link, double now) const {
		return std::any_of(ended.begin(), ended.end(), [&](const EndedStream &stream) { return stream.link == of_link && now - stream.time < LATE_PACKET_TIME; });
	}

	/// Statistics of this peer. `sent_to` are those of our stream to it.
	[[nodiscard]] SessionStatistics statistics(double now, const ReceiverStatistics &sent_to) {
		SessionStatistics result{ sent.bytes_per_second(now), sent.packets_per_second(now), received.bytes_per_second(now), received.packets_per_second(now) };
		result.loss = sent_to.loss;
		result.round_trip = sent_to.round_trip;
		result.line_rate = sent_to.line_rate;
		result.relaxation = sent_to.relaxation;
		if (stream) {
			result.loss = std::max(result.loss, stream->statistics().loss);
			result.round_trip = std::max(result.round_trip, stream->statistics().round_trip);
			result.playback_delay = stream->statistics().playback_delay;
			result.late = stream->statistics().late_windows;
		}
		result.rejected = rejections.count();
		result.unauthorized = unauthorized_bodies;
		return result;
	}
};

} // namespace net
