#pragma once

#include "measures.hpp"
#include "scene.hpp"

#include "../../harness/simulated_link.hpp"
#include "net/session/session.hpp"

#include <cstddef>
#include <cstdint>
#include <map>

namespace bench {

/// The bodies of one owner: those of the scene from `first` to before `end`.
struct OwnedBodies {
	net::PeerId owner = 0;
	size_t first = 0;
	size_t end = 0;
};

/// One peer of a session network and what is measured at it. Times are in seconds of the network's clock.
class SessionEnd {
public:
	SessionEnd(net::PeerId id, const net::StreamSettings &settings) :
			_id(id), _session(settings) {}

	/// Connects to the peers, which own these bodies.
	void connect(const std::vector<net::PeerId> &peers, const std::vector<OwnedBodies> &owned);
	/// Runs a tick and a frame, with the packets that have arrived, and measures the time it takes.
	void step(double time, const LoadScene &scene);
	/// Takes a packet when the next step begins.
	void deliver(net::PeerId from, std::vector<uint8_t> bytes) { _arrived.push_back({ from, std::move(bytes) }); }
	/// Measures some of an owner's bodies as shown here. `media_begin`: the time of media time 0 of its stream.
	void measure(const LoadScene &scene, const OwnedBodies &owned, double time, double media_begin);
	/// Discards what was measured.
	void reset_measures();

	[[nodiscard]] net::Session &session() { return _session; }
	[[nodiscard]] net::PeerId id() const { return _id; }
	/// The time on this peer's clock; clocks are not synchronized.
	[[nodiscard]] double local(double time) const { return time + 1000.0 * double(_id); }
	/// The time of media time 0 of the outgoing stream.
	[[nodiscard]] double media_begin() const { return _media_begin; }
	[[nodiscard]] const Histogram &errors() const { return _errors; }
	[[nodiscard]] const Histogram &delays() const { return _delays; }
	[[nodiscard]] const Histogram &frames() const { return _frames; } ///< processor time of frames, in seconds
	[[nodiscard]] const Playback &playback(net::PeerId owner) { return _playback[owner]; }
	[[nodiscard]] Meter &meter() { return _meter; }
	/// Packets of a peer that were rejected.
	[[nodiscard]] uint64_t rejected(net::PeerId peer, double time) { return _session.statistics(peer, local(time)).rejected; }

private:
	struct Arrived {
		net::PeerId from;
		std::vector<uint8_t> bytes;
	};

	void tick(double time);

	net::PeerId _id;
	net::Session _session;
	std::vector<OwnedBodies> _owned;
	std::vector<cga::Pose<double>> _poses; // of the own bodies
	std::vector<Arrived> _arrived;
	Histogram _errors; // meters
	Histogram _delays; // seconds
	Histogram _frames;
	std::map<net::PeerId, Playback> _playback;
	Meter _meter;
	double _media_begin = 0.0;
	size_t _next_body = 0;
};

} // namespace bench
