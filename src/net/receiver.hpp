#pragma once

#include "net/stream_settings.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace net {

struct StreamStatistics {
	uint64_t bytes_received = 0;
	uint64_t packets_received = 0;
	uint64_t packets_rejected = 0;
	uint64_t late_windows = 0; ///< arrived after their place in the motion had begun to be shown
	double playback_delay = 0.0; ///< seconds behind the newest media time that could have arrived
	double jitter = 0.0; ///< seconds between the earliest and the late arrivals, recent
	double round_trip = 0.0; ///< seconds, as the sender measured it; 0 before that
	double loss = 0.0; ///< share of chunks that did not come at the first try, recent
};

struct BodyEvent {
	enum Kind : uint8_t {
		ADDED,
		REMOVED
	};
	Kind kind;
	uint32_t id;
};

/// What one authority's stream looks like at a receiver: takes packets in any order, keeps a jitter buffer of decoded
/// motion for each body, and shows all bodies at one media time. It knows no network. `now` is in seconds on the
/// receiver's own clock. Memory is bounded whatever arrives.
class Receiver {
public:
	/// At most `most_bodies` bodies; a stream with more is rejected.
	explicit Receiver(size_t most_bodies = 65536);
	~Receiver();

	/// Takes a packet. Null, or why it was rejected (a literal); then nothing has changed. Repeats are no error.
	const char *accept(const uint8_t *packet, size_t size, double now);
	/// Replaces `packet` with an answer for the sender. False if none is due. Call it after the packets of a frame.
	bool take_answer(std::vector<uint8_t> &packet, double now);

	/// True once there is something to show.
	[[nodiscard]] bool is_ready() const;
	/// Moves playback on to `now`; never backwards in media time.
	void advance(double now);
	/// Media time shown, in seconds of the sender's clock since its stream began.
	[[nodiscard]] double media_time() const;
	/// Media time that is shown at `now`, without moving playback.
	[[nodiscard]] double media_time_at(double now) const;
	/// Up to where all motion has arrived, in seconds of media time.
	[[nodiscard]] double known_time() const;

	/// The pose shown of a body. False if it is not there (yet).
	bool pose(uint32_t id, cga::Pose<double> &pose) const;
	/// The pose of a body at another media time not before media_time(), for measuring. False if it is not known.
	bool pose_at(uint32_t id, double media_time, cga::Pose<double> &pose) const;
	/// Ids of the bodies shown.
	void bodies(std::vector<uint32_t> &ids) const;
	/// What appeared and vanished since the last call, in order.
	void take_events(std::vector<BodyEvent> &events);

	/// The playback delay adapts to what the network needs, in seconds: at least `least`, at most the stream's max_latency
	/// plus `most`, which is as much again before this is called.
	void set_margin_limits(double least, double most);
	[[nodiscard]] const StreamSettings &settings() const;
	[[nodiscard]] StreamStatistics statistics() const;

private:
	struct State;
	std::unique_ptr<State> _state;
};

} // namespace net
