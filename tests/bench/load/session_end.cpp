#include "session_end.hpp"

#include "../network/pose_error.hpp"

#include <algorithm>

namespace bench {

namespace {

/// Bodies whose error is measured in one frame.
constexpr size_t BODIES_PER_FRAME = 20;

} // namespace

void SessionEnd::connect(const std::vector<net::PeerId> &peers, const std::vector<OwnedBodies> &owned) {
	_meter.begin();
	_session.connect(_id);
	std::vector<net::PeerId> others;
	std::copy_if(peers.begin(), peers.end(), std::back_inserter(others), [this](net::PeerId peer) { return peer != _id; });
	(void)_session.set_peers(others, local(0.0));
	_owned = owned;
	for (const OwnedBodies &bodies : owned) {
		for (size_t body = bodies.first; body < bodies.end; ++body) {
			_session.set_owner(uint32_t(body), bodies.owner);
		}
	}
	_meter.end();
}

void SessionEnd::step(double time, const LoadScene &scene) {
	_poses.clear();
	for (const OwnedBodies &bodies : _owned) {
		for (size_t body = bodies.first; bodies.owner == _id && body < bodies.end; ++body) {
			_poses.push_back(scene.pose(body, time));
		}
	}
	const double before = _meter.seconds();
	_meter.begin();
	tick(time);
	_meter.end();
	_frames.add(_meter.seconds() - before);
	_arrived.clear();
	_media_begin = time - _session.media_time(_id);
}

void SessionEnd::tick(double time) {
	for (const Arrived &packet : _arrived) {
		_session.accept(packet.from, packet.bytes.data(), packet.bytes.size(), local(time));
	}
	_session.begin_tick(local(time), net::StreamSettings().tick);
	size_t next = 0;
	for (const OwnedBodies &bodies : _owned) {
		for (size_t body = bodies.first; bodies.owner == _id && _session.is_sending() && body < bodies.end; ++body) {
			(void)_session.observe(uint32_t(body), _poses[next++]);
		}
	}
	_session.end_tick();
	_session.advance(local(time));
	_session.report_rejections([](net::PeerId, const net::Rejections::Report &) {});
}

void SessionEnd::measure(const LoadScene &scene, const OwnedBodies &owned, double time, double media_begin) {
	const net::Receiver *stream = _session.stream(owned.owner);
	if (stream == nullptr) {
		_playback[owned.owner].add(time, 0.0);
		return;
	}
	_playback[owned.owner].add(time, std::min(stream->media_time(), stream->known_time()));
	_delays.add(time - media_begin - stream->media_time());
	for (size_t i = 0; i < std::min(owned.end - owned.first, BODIES_PER_FRAME); ++i) {
		const size_t body = owned.first + _next_body++ % (owned.end - owned.first);
		if (const auto pose = stream->pose(uint32_t(body))) {
			_errors.add(lever_distance(*pose, scene.pose(body, media_begin + stream->media_time())));
		}
	}
}

void SessionEnd::reset_measures() {
	_errors = Histogram();
	_delays = Histogram();
	_frames = Histogram();
	_playback.clear();
	_meter.reset_time();
	(void)_meter.take_peak();
}

} // namespace bench
