#pragma once

#include "../harness/simulated_link.hpp"
#include "motion_scenes.hpp"
#include "net/endpoint/receiver.hpp"
#include "net/endpoint/sender.hpp"

#include <doctest/doctest.h>

#include <map>
#include <memory>
#include <optional>
#include <set>

namespace net_test {

using harness::LinkSettings;
using harness::SimulatedLink;

/// A receiver, the links between it and the sender, and what was observed of them.
struct RemoteEnd {
	RemoteEnd(uint64_t seed, const LinkSettings &link, size_t max_bodies = 1000) :
			receiver(std::make_unique<net::Receiver>(max_bodies)), down(link, seed), up(link, seed + 1000) {}

	/// Changes both links.
	template <class Change>
	void change_links(Change &&change) {
		change(down.settings());
		change(up.settings());
	}

	std::unique_ptr<net::Receiver> receiver;
	SimulatedLink down; // to the receiver
	SimulatedLink up;
	std::vector<uint8_t> bytes_sent; // to the receiver, if SimulatedSession::keeps_bytes
	size_t largest_packet = 0;
	std::set<uint8_t> items; // first bytes of packets that do not begin with a chunk
	double ready_at = -1.0;
	double media_time = -1e9;
	int steps_back = 0;
	int not_finite = 0;
};

/// A sender that replicates moving bodies at 60 Hz to any number of receivers, in virtual time.
class SimulatedSession {
public:
	explicit SimulatedSession(const net::StreamSettings &settings = {}) :
			sender(std::make_unique<net::Sender>(settings)) {}

	struct Body {
		Path path;
	};

	void add_body(uint32_t id, const Path &path) {
		bodies[id] = { path };
		CHECK(sender->add_body(id, path(now)));
	}

	/// The same link settings in both directions; by default 30 ms of delay.
	RemoteEnd &add_receiver(uint32_t id, const LinkSettings &link = { 0.03 }) {
		auto &end = ends[id];
		end = std::make_unique<RemoteEnd>(id * 17 + 5, link);
		sender->add_receiver(id, sender_now());
		return *end;
	}

	/// One tick: the sender observes the bodies and sends, the receivers play and acknowledge.
	void step() {
		now += TICK;
		for (const auto &body : bodies) {
			sender->observe(body.first, sender_now(), body.second.path(now));
		}
		sender->flush(sender_now());
		for (const net::OutgoingPacket &packet : sender->packets()) {
			RemoteEnd &end = *ends.at(packet.receiver);
			const uint8_t *bytes = sender->bytes() + packet.begin;
			end.bytes_sent.insert(end.bytes_sent.end(), bytes, bytes + (keeps_bytes ? packet.size : 0));
			end.largest_packet = std::max(end.largest_packet, packet.size);
			if (bytes[0] >= 0xc0) {
				end.items.insert(bytes[0]);
			}
			end.down.send(now, bytes, packet.size);
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

	[[nodiscard]] double sender_now() const { return now + sender_clock; }
	/// The error of a body as the receiver shows it now, relative to the tolerance; 1e9 if it is not shown.
	[[nodiscard]] double error(const RemoteEnd &end, uint32_t id) const {
		const net::StreamSettings &settings = end.receiver->settings();
		const net::StreamGrid grid(float(settings.position_tolerance), float(settings.rotation_tolerance));
		const std::optional<PoseD> shown = end.receiver->pose(id);
		return shown ? error_share(*shown, bodies.at(id).path(origin + end.receiver->media_time()), grid) : 1e9;
	}
	/// The largest error of the bodies.
	[[nodiscard]] double error(const RemoteEnd &end) const {
		double worst = 0.0;
		for (const auto &body : bodies) {
			worst = std::max(worst, error(end, body.first));
		}
		return worst;
	}

	static constexpr double TICK = 1.0 / 60.0;
	std::unique_ptr<net::Sender> sender;
	std::map<uint32_t, Body> bodies;
	std::map<uint32_t, std::unique_ptr<RemoteEnd>> ends;
	double now = 100.0;
	double origin = 100.0; // the time of the sender's first observation, where its media time is 0
	// The clocks are not the same.
	double sender_clock = 0.0; // its time minus `now`
	double receiver_clock = 5000.0;
	bool keeps_bytes = false;
	bool takes_events = true;
	int acks_rejected = 0;
	int packets_rejected = 0;

private:
	void step_end(uint32_t id, RemoteEnd &end) {
		const double receiver_now = now + receiver_clock;
		// Sums of ticks are rounded: a packet of this tick may be due slightly later.
		const double due = now + 1e-9;
		while (const std::optional<harness::Delivery> packet = end.down.receive(due)) {
			packets_rejected += end.receiver->accept(packet->bytes.data(), packet->bytes.size(), receiver_now) ? 0 : 1;
		}
		std::vector<uint8_t> ack;
		end.receiver->take_ack(ack, receiver_now);
		if (!ack.empty()) {
			end.up.send(now, ack.data(), ack.size());
		}
		end.receiver->advance(receiver_now);
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
			const std::optional<PoseD> pose = end.receiver->pose(body.first);
			end.not_finite += pose && !cga_test::is_finite(*pose) ? 1 : 0;
		}
		while (const std::optional<harness::Delivery> received = end.up.receive(due)) {
			acks_rejected += sender->accept(id, received->bytes.data(), received->bytes.size(), sender_now()) ? 0 : 1;
		}
	}
};

/// Adds bodies that move smoothly, so that the error bound holds between ticks too.
inline void add_smooth_bodies(SimulatedSession &session, uint32_t count) {
	std::vector<Motion> smooth;
	for (const Motion &motion : motions(Vector3D(0.0))) {
		if (!motion.has_kinks && motion.name != "rest" && motion.name != "line" && motion.name != "parabola" && motion.name != "large" && motion.name != "growth") {
			smooth.push_back(motion);
		}
	}
	for (uint32_t id = 0; id < count; ++id) {
		const Path path = smooth[id % smooth.size()].path;
		const Vector3D position(double(id), 0.0, double(id % 7));
		session.add_body(id, [path, position, id](double t) {
			PoseD pose = path(t - 100.0 + 0.37 * id);
			pose.translation += position;
			return pose;
		});
	}
}

} // namespace net_test
