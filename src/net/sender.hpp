#pragma once

#include "net/stream_settings.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace net {

/// Bytes to give to a transport, for one receiver.
struct OutgoingPacket {
	uint32_t receiver = 0;
	size_t begin = 0; ///< in Sender::bytes()
	size_t size = 0;
};

struct ReceiverStatistics {
	uint64_t bytes_sent = 0;
	uint64_t packets_sent = 0;
	uint64_t chunks_repeated = 0;
	double loss = 0.0; ///< share of chunks that had to be repeated, recent
	double round_trip = 0.0; ///< seconds, smoothed; 0 before the first answer
};

/// The poses of one authority's bodies, sent to any number of receivers. It knows no network: packets are fetched after
/// `flush`, answers are given to `accept`. Times are in seconds on one clock of the sender's.
///
/// What is sent is coded once for all receivers, window by window, each against the window before it; a receiver that
/// misses one gets it again, one that is too far behind or new gets the whole state.
class Sender {
public:
	explicit Sender(const StreamSettings &settings);
	~Sender();

	/// A body appears, with its pose from now on. False if there is one of that id.
	bool add_body(uint32_t id, const cga::Pose<double> &pose);
	bool remove_body(uint32_t id);
	[[nodiscard]] bool has_body(uint32_t id) const;
	[[nodiscard]] size_t body_count() const;

	/// The pose of a body at a time, not before its last one. False if there is no such body, or the pose is not finite
	/// or out of range (then nothing changes).
	bool observe(uint32_t id, double time, const cga::Pose<double> &pose);
	/// The next observed pose is not interpolated to: the body is there at once.
	bool teleport(uint32_t id);

	void add_receiver(uint32_t receiver, double time);
	void remove_receiver(uint32_t receiver);
	[[nodiscard]] bool has_receiver(uint32_t receiver) const;

	/// All poses up to `time` have been observed. Makes the packets that are due; call it every tick.
	void flush(double time);
	/// The packets of the last flush, valid until the next.
	[[nodiscard]] const std::vector<OutgoingPacket> &packets() const;
	[[nodiscard]] const uint8_t *bytes() const;

	/// What a receiver answered. Null, or why it was dropped (a literal).
	const char *accept(uint32_t receiver, const uint8_t *packet, size_t size, double time);

	/// New settings hold from the next window on. All but the send rate restart the stream.
	void set_settings(const StreamSettings &settings);
	[[nodiscard]] const StreamSettings &settings() const;
	[[nodiscard]] ReceiverStatistics statistics(uint32_t receiver) const;
	/// What a time of this sender's is called by receivers (Receiver::media_time). 0 before the first flush.
	[[nodiscard]] double media_time(double time) const;
	/// Bodies that moved in the last window.
	[[nodiscard]] size_t moving_count() const;

private:
	struct State;
	std::unique_ptr<State> _state;
};

} // namespace net
