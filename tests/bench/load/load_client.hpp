#pragma once

#include "load_scenario.hpp"
#include "measures.hpp"
#include "scene.hpp"

#include "net/endpoint/receiver.hpp"

namespace bench {

/// One receiver, its lines and what is measured at it. Times are in seconds on the sender's clock.
class LoadClient {
public:
	LoadClient(const LoadScenario &scenario, const ReceiverGroup &group, uint64_t seed);

	[[nodiscard]] double join_time() const { return _join; }
	/// Carries a packet of the sender.
	void send(double time, const uint8_t *bytes, size_t size);
	/// Ends the sender's tick.
	void end_tick(double time);
	/// Takes the next packet for the sender.
	[[nodiscard]] std::optional<harness::Delivery> take_ack(double time) { return _up.receive(time); }
	/// Receives what has arrived, shows a frame, and compares some of the bodies with the scene. `begin`: the sender's time of media
	/// time 0.
	void show_frame(double time, const LoadScene &scene, double begin);

	/// Bytes per tick of the measured time, and before it.
	[[nodiscard]] const TickBytes &ticks() const { return _ticks; }
	[[nodiscard]] const TickBytes &early_ticks() const { return _early_ticks; }
	[[nodiscard]] const Histogram &moving_errors() const { return _moving_errors; }
	[[nodiscard]] const Histogram &resting_errors() const { return _resting_errors; }
	[[nodiscard]] const Histogram &delays() const { return _delays; }
	[[nodiscard]] const Playback &playback() const { return _playback; }
	[[nodiscard]] Meter &meter() { return _meter; }
	[[nodiscard]] uint64_t unseen() const { return _unseen; }
	[[nodiscard]] uint64_t ack_bytes() const { return _ack_bytes; }
	[[nodiscard]] uint64_t rejected() const { return _rejected; }
	[[nodiscard]] uint64_t packets() const { return _packets; }
	[[nodiscard]] uint64_t dropped() const { return _down.dropped(); }
	[[nodiscard]] uint64_t snapshots() const { return _receiver.snapshot_count() - _early_snapshots; }
	/// From the join to the first frame that shows bodies; infinite if there was none.
	[[nodiscard]] double ready_after() const { return _ready_after; }

private:
	[[nodiscard]] bool is_measured(double time) const { return time >= _measured_from; }
	void measure_frame(double time, const LoadScene &scene, double begin);
	void measure_errors(const LoadScene &scene, double begin);

	net::Receiver _receiver;
	Line _down;
	Line _up;
	double _join;
	double _measured_from;
	double _ready_after;
	TickBytes _early_ticks;
	TickBytes _ticks;
	Histogram _moving_errors; // meters
	Histogram _resting_errors; // meters
	Histogram _delays; // seconds
	Playback _playback;
	Meter _meter;
	std::vector<uint8_t> _ack;
	size_t _next_body = 0; // whose error is measured next
	size_t _tick_bytes = 0;
	uint64_t _unseen = 0;
	uint64_t _ack_bytes = 0;
	uint64_t _rejected = 0;
	uint64_t _packets = 0;
	uint32_t _early_snapshots = 0;
};

} // namespace bench
