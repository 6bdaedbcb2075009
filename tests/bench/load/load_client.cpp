#include "load_client.hpp"

#include "../network/pose_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bench {

namespace {

/// Seconds by which the receiver's clock is ahead of the sender's: clocks are not synchronized.
constexpr double RECEIVER_EPOCH = 4321.0;
/// Bodies whose error is measured in one frame; the next frame measures the next ones.
constexpr size_t BODIES_PER_FRAME = 50;
constexpr double NOT_SHOWN = -1e8; // media time of a frame without bodies

} // namespace

net::StreamSettings load_settings(double tolerance, double max_latency) {
	net::StreamSettings settings;
	settings.position_tolerance = tolerance;
	// The angle that weighs as much as the tolerance at LEVER_ARM: see net::StreamGrid.
	settings.rotation_tolerance = glm::degrees(std::sqrt(1.5) * tolerance / LEVER_ARM);
	settings.max_latency = max_latency;
	return settings;
}

LoadClient::LoadClient(const LoadScenario &scenario, const ReceiverGroup &group, uint64_t seed) :
		_down(group.down, seed), _up(group.up, ~seed), _join(group.join), _measured_from(group.join > 0.0 ? group.join : scenario.warm_up), _ready_after(std::numeric_limits<double>::infinity()) {
	const size_t ticks = size_t(std::max(scenario.seconds, _measured_from) / scenario.stream.tick) + 1;
	_ticks.reserve(ticks);
	_early_ticks.reserve(ticks);
}

void LoadClient::send(double time, const uint8_t *bytes, size_t size) {
	_tick_bytes += size;
	_packets += is_measured(time) ? 1 : 0;
	_down.send(time, bytes, size);
}

void LoadClient::end_tick(double time) {
	(is_measured(time) ? _ticks : _early_ticks).add(_tick_bytes);
	_tick_bytes = 0;
	if (!is_measured(time)) {
		_early_snapshots = _receiver.snapshot_count();
		_meter.reset_time();
	}
}

void LoadClient::show_frame(double time, const LoadScene &scene, double begin) {
	const double now = time + RECEIVER_EPOCH;
	while (const std::optional<harness::Delivery> delivery = _down.receive(time)) {
		_meter.begin();
		_rejected += _receiver.accept(delivery->bytes.data(), delivery->bytes.size(), now) ? 0 : 1;
		_meter.end();
	}
	_meter.begin();
	_receiver.advance(now);
	_receiver.take_ack(_ack, now);
	_meter.end();
	if (!_ack.empty()) {
		_ack_bytes += is_measured(time) ? _ack.size() : 0;
		_up.send(time, _ack.data(), _ack.size());
	}
	if (_receiver.is_ready() && std::isinf(_ready_after)) {
		_ready_after = time - _join;
	}
	if (is_measured(time) && (_receiver.is_ready() || _join == 0.0)) {
		measure_frame(time, scene, begin);
	}
}

void LoadClient::measure_frame(double time, const LoadScene &scene, double begin) {
	_playback.add(time, _receiver.is_ready() ? std::min(_receiver.media_time(), _receiver.known_time()) : NOT_SHOWN);
	if (_receiver.is_ready()) {
		_delays.add(time - begin - _receiver.media_time());
	}
	measure_errors(scene, begin);
}

void LoadClient::measure_errors(const LoadScene &scene, double begin) {
	for (size_t i = 0; i < std::min(scene.size(), BODIES_PER_FRAME); ++i) {
		const size_t body = _next_body++ % scene.size();
		if (const std::optional<cga::Pose<double>> pose = _receiver.pose(uint32_t(body))) {
			const double error = lever_distance(*pose, scene.pose(body, begin + _receiver.media_time()));
			(scene.is_moving(body) ? _moving_errors : _resting_errors).add(error);
		} else {
			++_unseen;
		}
	}
}

} // namespace bench
