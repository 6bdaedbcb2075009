#include "net/endpoint/forwarded_stream.hpp"

#include "../simulated_session.hpp"

#include <doctest/doctest.h>

using namespace net;
using namespace net_test;

namespace {

constexpr size_t MAX_SIZE = 600;

/// A sender, the receiver that forwards its stream, and receivers of the forwarded stream.
struct ForwardingScene {
	explicit ForwardingScene(const LinkSettings &link, uint32_t bodies = 12) :
			first(session.add_receiver(1, link)), forwarded((first.receiver->record(MAX_SIZE), *first.receiver)) {
		add_smooth_bodies(session, bodies);
	}

	RemoteEnd &add_receiver(uint32_t id, const LinkSettings &link) {
		forwarded.add_receiver(id, session.now);
		return ends.emplace(std::piecewise_construct, std::forward_as_tuple(id), std::forward_as_tuple(id * 31 + 7, link)).first->second;
	}

	void step() {
		session.step();
		forwarded.update(session.now, MAX_SIZE);
		for (auto &[id, end] : ends) {
			std::vector<uint8_t> bytes;
			forwarded.send(id, session.now, MAX_SIZE, bytes, [&, to = &end](size_t begin, size_t size) {
				to->largest_packet = std::max(to->largest_packet, size);
				to->bytes_sent.resize(to->bytes_sent.size() + size);
				to->down.send(session.now, bytes.data() + begin, size);
			});
			step_end(id, end);
		}
	}

	template <class EachStep>
	void run(double seconds, EachStep &&each) {
		for (const double end = session.now + seconds - 1e-9; session.now < end;) {
			step();
			each();
		}
	}
	void run(double seconds) {
		run(seconds, [] {});
	}

	SimulatedSession session;
	RemoteEnd &first;
	ForwardedStream forwarded;
	std::map<uint32_t, RemoteEnd> ends;
	int rejected = 0;

private:
	void step_end(uint32_t id, RemoteEnd &end) {
		const double receiver_now = session.now + 7000.0;
		while (const std::optional<harness::Delivery> packet = end.down.receive(session.now + 1e-9)) {
			rejected += end.receiver->accept(packet->bytes.data(), packet->bytes.size(), receiver_now) ? 0 : 1;
		}
		std::vector<uint8_t> ack;
		end.receiver->take_ack(ack, receiver_now);
		if (!ack.empty()) {
			end.up.send(session.now, ack.data(), ack.size());
		}
		end.receiver->advance(receiver_now);
		PacketContent content;
		while (const std::optional<harness::Delivery> packet = end.up.receive(session.now + 1e-9)) {
			rejected += read_packet(packet->bytes.data(), packet->bytes.size(), content) ? 0 : 1;
			forwarded.accept(id, content, session.now);
		}
	}
};

} // namespace

TEST_CASE("forwarded stream: receivers show the owner's motion within the tolerance, at no more delay than the links add") {
	ForwardingScene scene({ 0.03 });
	RemoteEnd &early = scene.add_receiver(2, { 0.03 });
	scene.run(1.5);
	RemoteEnd &late = scene.add_receiver(3, { 0.03 });
	scene.run(1.0);
	double worst = 0.0;
	double delay = 0.0;
	scene.run(5.0, [&] {
		for (const RemoteEnd *end : { &early, &late }) {
			worst = std::max(worst, scene.session.error(*end));
			const double behind = scene.session.now - scene.session.origin - end->receiver->media_time();
			const double first_behind = scene.session.now - scene.session.origin - scene.first.receiver->media_time();
			delay = std::max(delay, behind - first_behind);
		}
	});
	CHECK(worst <= 1.3);
	CHECK(delay <= 0.03 + 1.0 / 60.0 + 0.002);
	CHECK(scene.rejected == 0);
	CHECK(early.receiver->statistics().late_windows == 0);
	CHECK(early.receiver->snapshot_count() == 1);
	CHECK(early.receiver->statistics().round_trip == doctest::Approx(0.06).epsilon(0.5));
}

TEST_CASE("forwarded stream: each hop repeats what it has lost") {
	for (const LinkSettings &link : { LinkSettings{ 0.03, 0.1 }, LinkSettings{ 0.03, 0.03, 0.05 }, LinkSettings{ 0.05, 0.1, 0.3, 0.1 } }) {
		ForwardingScene scene(link);
		RemoteEnd &lossy = scene.add_receiver(2, link);
		RemoteEnd &clean = scene.add_receiver(3, { 0.01 });
		scene.run(8.0);
		for (auto &body : scene.session.bodies) {
			const PoseD last = body.second.path(scene.session.now);
			body.second.path = [last](double) { return last; };
		}
		scene.run(6.0);
		CAPTURE(link.loss);
		CHECK(scene.session.error(lossy) <= 1.02);
		CHECK(scene.session.error(clean) <= 1.02);
		CHECK(scene.rejected == 0);
	}
}

TEST_CASE("forwarded stream: after a new snapshot of the source, and after it was held, receivers continue with a snapshot") {
	ForwardingScene scene({ 0.03 });
	RemoteEnd &end = scene.add_receiver(2, { 0.03 });
	scene.run(2.0);
	StreamSettings settings;
	settings.position_tolerance = 0.02;
	scene.session.sender->set_settings(settings);
	scene.run(2.0);
	CHECK(end.receiver->settings().position_tolerance == doctest::Approx(0.02));
	CHECK(end.receiver->snapshot_count() == 2);
	CHECK(scene.session.error(end) <= 1.3);
	CHECK(end.largest_packet <= MAX_SIZE);
	scene.forwarded.set_held(true, scene.session.now);
	scene.run(0.1);
	const double known = end.receiver->known_time();
	scene.run(4.0);
	CHECK(end.receiver->known_time() == known);
	scene.forwarded.set_held(false, scene.session.now);
	scene.run(2.0);
	CHECK(scene.session.error(end) <= 1.3);
	CHECK(end.receiver->snapshot_count() == 3);
}

TEST_CASE("forwarded stream: while the owner is silent, receivers that have everything get no snapshots") {
	ForwardingScene scene({ 0.03 }, 200);
	RemoteEnd &end = scene.add_receiver(2, { 0.03 });
	scene.run(2.0);
	scene.first.change_links([](LinkSettings &link) { link.loss = 1.0; });
	scene.run(0.5);
	const size_t before = end.bytes_sent.size();
	scene.run(10.0);
	CHECK(end.bytes_sent.size() - before <= 200);
	scene.first.change_links([](LinkSettings &link) { link.loss = 0.0; });
	scene.run(3.0);
	CHECK(scene.session.error(end) <= 1.3);
}
