#pragma once

#include "motion_scenes.hpp"
#include "net/endpoint/receiver.hpp"
#include "net/endpoint/sender.hpp"

#include <doctest/doctest.h>

#include <map>
#include <memory>
#include <queue>
#include <set>

namespace net_test {

struct Conditions {
	double delay = 0.03; // seconds, one way
	double jitter = 0.0; // on top, evenly
	double loss = 0.0;
	double duplicates = 0.0;
	double outage_from = 1e9; // nothing gets through between these times
	double outage_until = 1e9;
};

/// One direction of a network: packets get lost, late, doubled and out of order, from a seed.
class SimulatedWire {
public:
	explicit SimulatedWire(unsigned seed) :
			_random(seed) {}

	void send(const uint8_t *bytes, size_t size, double now) {
		if ((now >= conditions.outage_from && now < conditions.outage_until) || _random.uniform(0.0, 1.0) < conditions.loss) {
			last_lost = now;
			return;
		}
		const int copies = _random.uniform(0.0, 1.0) < conditions.duplicates ? 2 : 1;
		for (int i = 0; i < copies; ++i) {
			_flying.push({ now + conditions.delay + _random.uniform(0.0, conditions.jitter), _number++, std::vector<uint8_t>(bytes, bytes + size) });
		}
	}

	template <class Take>
	void deliver(double now, Take &&take) {
		while (!_flying.empty() && _flying.top().arrival <= now + 1e-9) {
			const Packet packet = _flying.top();
			_flying.pop();
			take(packet.bytes);
		}
	}

	Conditions conditions;
	double last_lost = -1e9;

private:
	struct Packet {
		double arrival;
		uint64_t number;
		std::vector<uint8_t> bytes;
		bool operator<(const Packet &other) const { return arrival != other.arrival ? arrival > other.arrival : number > other.number; }
	};

	std::priority_queue<Packet> _flying;
	uint64_t _number = 0;
	cga_test::Random _random;
};

/// A receiver at the other end of two wires, and what it has seen.
struct RemoteEnd {
	explicit RemoteEnd(unsigned seed, size_t max_bodies = 1000) :
			receiver(std::make_unique<net::Receiver>(max_bodies)), down(seed), up(seed + 1000) {}

	std::unique_ptr<net::Receiver> receiver;
	SimulatedWire down; // to the receiver
	SimulatedWire up;
	std::vector<uint8_t> bytes_sent; // all that went down
	size_t largest_packet = 0;
	std::set<uint8_t> kinds; // first bytes of all packets, without those of chunks
	double ready_at = -1.0;
	double media_time = -1e9;
	int steps_back = 0;
	int not_finite = 0;
};

/// A sender that plays paths at 60 Hz to any number of receivers.
class Session {
public:
	explicit Session(const net::StreamSettings &settings = {}) :
			sender(std::make_unique<net::Sender>(settings)) {}

	struct Body {
		Path path;
		bool is_there = true;
	};

	void add_body(uint32_t id, const Path &path) {
		bodies[id] = { path };
		CHECK(sender->add_body(id, path(now)));
	}

	RemoteEnd &add_receiver(uint32_t id, const Conditions &conditions) {
		auto &end = ends[id];
		end = std::make_unique<RemoteEnd>(id * 17 + 5);
		end->down.conditions = end->up.conditions = conditions;
		sender->add_receiver(id, now);
		return *end;
	}

	/// One tick: the sender observes and sends, wires deliver, receivers take in, show and answer.
	void step() {
		now += TICK;
		for (const auto &body : bodies) {
			sender->observe(body.first, now, body.second.path(now));
		}
		sender->flush(now);
		for (const net::OutgoingPacket &packet : sender->packets()) {
			RemoteEnd &end = *ends.at(packet.receiver);
			const uint8_t *bytes = sender->bytes() + packet.begin;
			end.bytes_sent.insert(end.bytes_sent.end(), bytes, bytes + (keeps_bytes ? packet.size : 0));
			end.largest_packet = std::max(end.largest_packet, packet.size);
			if (bytes[0] >= 0xc0) {
				end.kinds.insert(bytes[0]);
			}
			end.down.send(bytes, packet.size, now);
		}
		for (auto &entry : ends) {
			step_end(entry.first, *entry.second);
		}
	}

	template <class EachStep>
	void run(double seconds, EachStep &&each) {
		for (const double end = now + seconds - 1e-9; now < end;) {
			step();
			each();
		}
	}
	void run(double seconds) {
		run(seconds, [] {});
	}

	/// The largest error of what is shown now, of all bodies, in shares of the tolerance; a body that is not shown counts 1e9.
	[[nodiscard]] double error(const RemoteEnd &end) const {
		const net::StreamSettings &settings = end.receiver->settings();
		const net::StreamGrid grid(float(settings.position_tolerance), float(settings.rotation_tolerance));
		const double time = origin + end.receiver->media_time();
		double worst = 0.0;
		for (const auto &body : bodies) {
			PoseD shown;
			worst = std::max(worst, end.receiver->pose(body.first, shown) ? error_share(shown, body.second.path(time), grid) : 1e9);
		}
		return worst;
	}

	static constexpr double TICK = 1.0 / 60.0;
	std::unique_ptr<net::Sender> sender;
	std::map<uint32_t, Body> bodies;
	std::map<uint32_t, std::unique_ptr<RemoteEnd>> ends;
	double now = 100.0;
	double origin = 100.0; // of the sender's media time: when it first heard of anything
	bool keeps_bytes = false;
	bool takes_events = true;
	int answers_rejected = 0;
	int packets_rejected = 0;

private:
	void step_end(uint32_t id, RemoteEnd &end) {
		// Its own clock shows another time.
		const double there = now + 5000.0;
		end.down.deliver(now, [&](const std::vector<uint8_t> &packet) { packets_rejected += end.receiver->accept(packet.data(), packet.size(), there) != nullptr; });
		std::vector<uint8_t> answer;
		if (end.receiver->take_ack(answer, there)) {
			end.up.send(answer.data(), answer.size(), now);
		}
		end.receiver->advance(there);
		if (takes_events) {
			std::vector<net::BodyEvent> events;
			end.receiver->take_events(events);
		}
		if (end.receiver->is_ready()) {
			end.ready_at = end.ready_at < 0.0 ? now : end.ready_at;
			end.steps_back += end.receiver->media_time() < end.media_time ? 1 : 0;
			end.media_time = end.receiver->media_time();
		}
		for (const auto &body : bodies) {
			PoseD pose;
			end.not_finite += end.receiver->pose(body.first, pose) && !cga_test::is_finite(pose) ? 1 : 0;
		}
		end.up.deliver(now, [&](const std::vector<uint8_t> &packet) { answers_rejected += sender->accept(id, packet.data(), packet.size(), now) != nullptr; });
	}
};

/// Bodies that move smoothly, so that the error bound holds at all times, between ticks too.
inline void add_smooth_bodies(Session &session, uint32_t count) {
	std::vector<Motion> smooth;
	for (const Motion &motion : motions(Vector3D(0.0))) {
		if (!motion.has_kinks && motion.name != "rest" && motion.name != "line" && motion.name != "parabola" && motion.name != "large" && motion.name != "growth") {
			smooth.push_back(motion);
		}
	}
	for (uint32_t id = 0; id < count; ++id) {
		const Path path = smooth[id % smooth.size()].path;
		const Vector3D place(double(id), 0.0, double(id % 7));
		session.add_body(id, [path, place, id](double t) {
			PoseD pose = path(t - 100.0 + 0.37 * id);
			pose.translation += place;
			return pose;
		});
	}
}

} // namespace net_test
