#pragma once

#include "net/delivery/arrival_line.hpp"

#include <algorithm>

namespace net {

/// Maps a receiver's local time to the media time it shows.
///
/// An ArrivalLine estimates up to which media time motion can have arrived, and how fast the sender's media time runs; the
/// lateness of recent motion sets the playback delay. Playback follows by running a little faster or slower than the sender.
/// It goes back only if the sender itself has stopped or slowed down: to the begin of the first motion that was not shown.
/// Times in seconds.
class PlaybackClock {
public:
	/// Starts at `now`. Motion is known at media time `end` only: playback stays there until it is `delay` old.
	void start(double end, double delay, double now);
	/// Records that a packet arrived.
	void observe_packet(double now);
	/// Records that motion from media time `begin` to `end` arrived at `now`. If nothing moves, `begin` is `end`.
	void observe(double begin, double end, double now);
	/// Records that a chunk arrived that had been lost or overtaken. `loss` is the recent fraction of such chunks.
	void observe_loss(double loss, double now);
	/// Advances playback to `now`.
	void advance(double now);

	[[nodiscard]] bool is_running() const { return _running; }
	[[nodiscard]] double media_time() const { return std::max(_position, _begin); }
	[[nodiscard]] double media_time_at(double now) const { return std::max(position_at(now), _begin); }
	/// True while playback waits at the begin of the stream.
	[[nodiscard]] bool is_waiting() const { return _running && _position < _begin; }
	/// The target delay behind the newest media time that can have arrived, in media time.
	[[nodiscard]] double target_delay() const;
	/// The actual delay at `now`, in local time. While nothing arrives, it grows.
	[[nodiscard]] double delay_at(double now) const;
	/// Spread between the earliest and the latest recent arrivals.
	[[nodiscard]] double jitter() const { return _line.jitter(); }
	/// Media seconds of the sender per local second.
	[[nodiscard]] double sender_rate() const { return _line.rate(); }

	/// Limits of the delay.
	void set_limits(double min_delay, double max_delay) {
		_min_delay = min_delay;
		_max_delay = max_delay;
	}

private:
	/// Arrivals that are processed at one instant.
	struct Batch {
		double time = 0.0;
		double begin = 0.0; // earliest motion
		double end = 0.0; // latest known media time
		bool is_after_silence = false;
		bool is_open = false;
	};

	void close_batch();
	[[nodiscard]] double position_at(double now) const;
	[[nodiscard]] double speed(double now, double step) const;
	[[nodiscard]] double target(double now) const { return _line.newest_at(now) - target_delay(); }

	bool _running = false;
	double _begin = 0.0; // earliest known media time
	double _position = 0.0; // may be before _begin
	double _last = 0.0;
	double _min_delay = 0.0;
	double _max_delay = 0.2;
	double _losses_until = -1e9;
	ArrivalLine _line;
	RecentExtreme _required_delay{ 1.0, 6.0 }; // media time from the begin of a motion to its arrival
	double _delay_rate = 1.0; // the sender's rate for which _required_delay was measured
	double _suspect_delay = 0.0; // required by the last arrival, if that was suspect
	Batch _batch;
	double _known = 0.0; // media time
	double _known_at = 0.0;
	double _packet_time = 0.0;
	double _packet_interval = 0.1; // moving average
	double _silence_end = -1e9; // when a packet last arrived after unusual silence
	bool _is_silence_rare = false; // the last silence was the first in a long time
};

} // namespace net
