#include "net/endpoint/sender.hpp"

#include "../simulated_session.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace net;
using namespace net_test;

namespace {

PoseD at(double x) {
	PoseD pose;
	pose.translation.x = x;
	return pose;
}

} // namespace

TEST_CASE("sender: invalid bodies, poses and receivers are rejected") {
	Sender sender{ StreamSettings() };
	for (const bool with_receiver : { false, true }) {
		if (with_receiver) {
			sender.add_receiver(4, 0.0);
			sender.flush(0.1);
		}
		const uint32_t id = with_receiver ? 2 : 1;
		CHECK(sender.add_body(id, at(1.0)));
		CHECK_FALSE(sender.add_body(id, at(2.0)));
		CHECK_FALSE(sender.add_body(0x80000000u, at(2.0)));
		CHECK_FALSE(sender.add_body(9, at(std::numeric_limits<double>::quiet_NaN())));
		CHECK(sender.observe(id, 0.1, at(1.5)));
		CHECK_FALSE(sender.observe(id, 0.1, at(1e300)));
		CHECK_FALSE(sender.observe(id, std::numeric_limits<double>::quiet_NaN(), at(1.0)));
		CHECK_FALSE(sender.observe(9, 0.1, at(1.0)));
		CHECK(sender.teleport(id));
		CHECK_FALSE(sender.teleport(9));
		CHECK_FALSE(sender.remove_body(9));
	}
	CHECK(sender.body_count() == 2);
	CHECK(sender.has_receiver(4));
	CHECK_FALSE(sender.has_receiver(5));
	sender.remove_receiver(4);
	sender.flush(0.2);
	CHECK(sender.packets().empty());
}

TEST_CASE("sender: random acknowledgements and those from unknown peers do not affect other receivers") {
	SimulatedSession session;
	add_smooth_bodies(session, 5);
	RemoteEnd &end = session.add_receiver(1);
	session.add_receiver(2);
	session.run(2.0);
	const uint8_t request = 0xc2;
	const PacketResult result = session.sender->accept(99, &request, 1, session.now);
	REQUIRE_FALSE(result);
	CHECK(result.error() == PacketError::UNKNOWN_RECEIVER);
	cga_test::Random random(91);
	end.items.clear();
	double worst = 0.0;
	session.run(4.0, [&] {
		for (int i = 0; i < 10; ++i) {
			std::vector<uint8_t> ack(size_t(random.uniform(0.0, 20.0)));
			for (uint8_t &byte : ack) {
				byte = uint8_t(random.uniform(0.0, 256.0));
			}
			if (!ack.empty()) {
				const uint8_t kinds[] = { 0xc0, 0xc1, 0xc2, 0xd0, ack[0] };
				ack[0] = kinds[i % 5];
			}
			(void)session.sender->accept(2, ack.data(), ack.size(), session.now);
		}
		worst = std::max(worst, session.error(end));
	});
	CHECK(worst <= 1.3);
	CHECK(end.items.count(0xe0) == 0); // no snapshot
	// The receiver that they claimed to come from recovers.
	session.run(6.0);
	CHECK(session.error(*session.ends[2]) <= 1.3);
}

TEST_CASE("sender: a late receiver shows all bodies within two round trips and a tick, at no cost to others") {
	size_t bytes[2] = { 0, 0 };
	for (const bool with_late : { false, true }) {
		SimulatedSession session;
		session.keeps_bytes = true;
		add_smooth_bodies(session, 40);
		RemoteEnd &first = session.add_receiver(1, { 0.05 });
		session.run(3.0);
		first.items.clear();
		const size_t before = first.bytes_sent.size();
		double worst = 0.0;
		if (with_late) {
			const double joined = session.now;
			RemoteEnd &late = session.add_receiver(2, { 0.05 });
			session.run(0.2 + SimulatedSession::TICK, [&] { worst = std::max(worst, session.error(first)); });
			CHECK(late.receiver->is_ready());
			CHECK(late.ready_at - joined <= 0.2 + SimulatedSession::TICK + 1e-6);
			CHECK(late.receiver->bodies().size() == 40);
			CHECK(session.error(late) < 1e9);
			session.run(1.0, [&] { worst = std::max(worst, session.error(first)); });
			CHECK(session.error(late) <= 1.3);
			CHECK(late.steps_back == 0);
			CHECK(late.items.count(0xe0) == 1);
		} else {
			session.run(1.2 + SimulatedSession::TICK);
		}
		CHECK(worst <= 1.3);
		CHECK(first.items.count(0xe0) == 0); // no snapshot for it
		bytes[with_late] = first.bytes_sent.size() - before;
	}
	// The only cost: windows may be shorter until the new link has been measured, and one more ends at the snapshot.
	CHECK(bytes[1] < bytes[0] * 2);
	CHECK(bytes[0] > 300);
}

TEST_CASE("sender: a removed receiver gets no packets; a silent one gets only probes until it returns") {
	SimulatedSession session;
	add_smooth_bodies(session, 8);
	RemoteEnd &quiet = session.add_receiver(1);
	RemoteEnd &other = session.add_receiver(2);
	session.run(3.0);
	quiet.change_links([&](LinkSettings &link) {
		link.outage_begin = session.now;
		link.outage_end = session.now + 9.0;
	});
	session.run(4.0);
	const uint64_t before = session.sender->statistics(1).bytes_sent;
	double worst = 0.0;
	session.run(5.0, [&] { worst = std::max(worst, session.error(other)); });
	CHECK(session.sender->statistics(1).bytes_sent - before <= 30);
	CHECK(worst <= 1.3);
	const int steps_back = quiet.steps_back;
	uint64_t max_in_tick = 0;
	uint64_t sent = session.sender->statistics(1).bytes_sent;
	session.run(2.0, [&] {
		max_in_tick = std::max(max_in_tick, session.sender->statistics(1).bytes_sent - sent);
		sent = session.sender->statistics(1).bytes_sent;
	});
	CHECK(max_in_tick < 8000); // a snapshot, not all missed windows
	CHECK(session.error(quiet) <= 1.3);
	CHECK(quiet.steps_back == steps_back);
	CHECK(steps_back == 0);
	session.sender->remove_receiver(1);
	session.run(1.0, [&] {
		for (const OutgoingPacket &packet : session.sender->packets()) {
			CHECK(packet.receiver == 2);
		}
	});
	CHECK(session.sender->statistics(1).bytes_sent == 0);
}

TEST_CASE("sender: receivers recover from outages at the join, one-way outages, a new receiver and a new sender") {
	struct Row {
		std::string name;
		double down_from, down_until, up_from, up_until; // outages, from the start
		double new_receiver, new_sender; // times
	};
	const double never = 1e9;
	for (const Row &row : {
				 Row{ "no packets either way for 4 s at the join", 0.0, 4.0, 0.0, 4.0, never, never },
				 Row{ "no acks for 4 s at the join", never, never, 0.0, 4.0, never, never },
				 Row{ "no packets either way from the middle of the join", 0.1, 4.5, 0.1, 4.5, never, never },
				 Row{ "no acks for 5 s", never, never, 3.0, 8.0, never, never },
				 Row{ "no packets for 5 s", 3.0, 8.0, never, never, never, never },
				 Row{ "no packets either way for 25 s", 3.0, 28.0, 3.0, 28.0, never, never },
				 Row{ "a new receiver behind the same address", never, never, never, never, 3.0, never },
				 Row{ "a new sender", never, never, never, never, never, 3.0 },
				 Row{ "a new sender while a snapshot arrives", 0.02, 0.5, never, never, never, 0.3 },
				 Row{ "a new sender soon after the join", never, never, never, never, never, 0.5 },
		 }) {
		SimulatedSession session;
		add_smooth_bodies(session, 30);
		RemoteEnd &end = session.add_receiver(1, { 0.05, 0.02 });
		const double start = session.now;
		end.down.settings().outage_begin = start + row.down_from;
		end.down.settings().outage_end = start + row.down_until;
		end.up.settings().outage_begin = start + row.up_from;
		end.up.settings().outage_end = start + row.up_until;
		double fixed = start;
		for (const double until : { row.down_until, row.up_until, row.new_receiver, row.new_sender }) {
			fixed = until < never ? std::max(fixed, start + until) : fixed;
		}
		bool receiver_replaced = false;
		bool sender_replaced = false;
		// When the first second without an error began. (Later errors occur as windows lengthen again.)
		double good_from = -1.0;
		double recovered = 1e9;
		session.run(fixed - start + 8.0, [&] {
			if (!receiver_replaced && session.now >= start + row.new_receiver) {
				end.receiver = std::make_unique<Receiver>(1000);
				receiver_replaced = true;
			}
			if (!sender_replaced && session.now >= start + row.new_sender) {
				session.sender = std::make_unique<Sender>(StreamSettings());
				for (const auto &body : session.bodies) {
					CHECK(session.sender->add_body(body.first, body.second.path(session.now)));
				}
				session.sender->add_receiver(1, session.now);
				session.origin = session.now;
				sender_replaced = true;
			}
			const bool is_good = session.now >= fixed && end.receiver->is_ready() && session.error(end) <= 1.5;
			good_from = !is_good ? -1.0 : (good_from < 0.0 ? session.now : good_from);
			recovered = is_good && recovered > 1e8 && session.now - good_from >= 1.0 ? good_from : recovered;
		});
		CAPTURE(row.name);
		CHECK(recovered - fixed <= 2.0);
		CHECK((end.steps_back == 0 || receiver_replaced || sender_replaced));
	}
}

TEST_CASE("sender: settings can change at any time") {
	SimulatedSession session;
	add_smooth_bodies(session, 8);
	RemoteEnd &end = session.add_receiver(1, { 0.03, 0.01 });
	session.run(3.0);
	StreamSettings settings;
	settings.max_latency = 0.1;
	for (int change = 0; change < 4; ++change) {
		if (change == 1) {
			settings.position_tolerance = 0.001;
			settings.rotation_tolerance = 0.3;
		} else if (change == 2) {
			settings.mode = cga::Mode::SCREW;
		} else if (change == 3) {
			settings.tick = 1.0 / 30.0;
			session.origin = session.now;
		}
		session.sender->set_settings(settings);
		CHECK(session.sender->settings().max_latency == 0.1);
		const double changed = session.now;
		double bad_until = changed;
		session.run(5.0, [&] { bad_until = session.error(end) > 2.0 ? session.now : bad_until; });
		CAPTURE(change);
		CHECK(bad_until - changed <= 2.0);
		CHECK(float(end.receiver->settings().max_latency) == 0.1f);
		CHECK(float(end.receiver->settings().position_tolerance) == float(settings.position_tolerance));
		CHECK(end.receiver->settings().mode == settings.mode);
		CHECK(end.receiver->settings().tick == settings.tick);
	}
}

TEST_CASE("sender: a scene at rest costs a few bytes per second") {
	SimulatedSession session;
	for (uint32_t id = 0; id < 200; ++id) {
		session.add_body(id, [id](double) { return at(double(id)); });
	}
	session.add_receiver(1);
	session.run(3.0);
	const ReceiverStatistics before = session.sender->statistics(1);
	session.run(10.0);
	const ReceiverStatistics after = session.sender->statistics(1);
	CHECK(after.bytes_sent - before.bytes_sent <= 150);
	CHECK(after.packets_sent - before.packets_sent <= 25);
	CHECK(after.loss < 0.01);
	CHECK(session.sender->moving_count() == 0);
}

TEST_CASE("sender: after an hour without a flush there is no flood of packets") {
	SimulatedSession session;
	add_smooth_bodies(session, 3);
	RemoteEnd &end = session.add_receiver(1);
	session.run(2.0);
	session.now += 3600.0;
	const uint64_t before = session.sender->statistics(1).bytes_sent;
	session.run(0.1);
	CHECK(session.sender->statistics(1).bytes_sent - before < 20000);
	session.run(4.0);
	CHECK(session.error(end) <= 1.3);
	CHECK(end.steps_back == 0);
}

TEST_CASE("sender: long round trips, from the start or later, are measured and cause no retransmissions") {
	for (const double delay : { 0.01, 0.15, 0.3, 0.5 }) {
		for (const bool from_start : { true, false }) {
			SimulatedSession session;
			add_smooth_bodies(session, 8);
			RemoteEnd &end = session.add_receiver(1, { from_start ? delay : 0.02 });
			session.run(2.0);
			end.change_links([&](LinkSettings &link) { link.delay = delay; });
			session.run(6.0);
			const ReceiverStatistics before = session.sender->statistics(1);
			session.run(6.0);
			const ReceiverStatistics after = session.sender->statistics(1);
			CAPTURE(delay);
			CAPTURE(from_start);
			CHECK(after.round_trip >= 1.95 * delay);
			CHECK(after.round_trip <= 2.0 * delay + 0.06);
			CHECK(after.chunks_repeated - before.chunks_repeated <= 2);
			CHECK(after.loss < 0.05);
		}
	}
}

TEST_CASE("sender: windows end at the instants that a receiver requests, and within max_latency") {
	SimulatedSession session;
	add_smooth_bodies(session, 3);
	RemoteEnd &end = session.add_receiver(1);
	session.run(10.0); // until the loss is known to be low
	// Media times at which windows end, in ticks.
	const auto window_ends = [&](double seconds) {
		std::vector<int64_t> ends;
		double known = end.receiver->known_time();
		session.run(seconds, [&] {
			if (end.receiver->known_time() > known) {
				known = end.receiver->known_time();
				ends.push_back(std::lround(known / SimulatedSession::TICK));
			}
		});
		return ends;
	};
	const auto request = [&](uint8_t number, double period, double shift) {
		std::vector<uint8_t> packet;
		put_alignment(packet, { number, period, shift });
		REQUIRE(session.sender->accept(1, packet.data(), packet.size(), session.now));
	};
	for (const int ticks : { 9, 8 }) {
		request(uint8_t(ticks), ticks * SimulatedSession::TICK, 0.0);
		(void)window_ends(0.5);
		const std::vector<int64_t> ends = window_ends(2.0);
		CAPTURE(ticks);
		CHECK(std::abs(double(ends.size()) - 120.0 / ticks) < 1.0);
		const int64_t phase = ends[0] % ticks;
		for (const int64_t window_end : ends) {
			CHECK(window_end % ticks == phase);
		}
		if (ticks == 8) {
			request(1, 8 * SimulatedSession::TICK, 3 * SimulatedSession::TICK);
			request(2, 8 * SimulatedSession::TICK, 3 * SimulatedSession::TICK); // too soon after the first
			(void)window_ends(0.5);
			request(1, 8 * SimulatedSession::TICK, 3 * SimulatedSession::TICK); // a duplicate
			for (const int64_t window_end : window_ends(1.0)) {
				CHECK(window_end % 8 == (phase + 3) % 8);
			}
		}
	}
	// A period that is longer than the windows may be is divided; far shorter ones are ignored.
	request(3, 16 * SimulatedSession::TICK, 0.0);
	(void)window_ends(0.5);
	CHECK(std::abs(int(window_ends(2.0).size()) - 15) <= 1);
	request(4, SimulatedSession::TICK, 0.0);
	CHECK(std::abs(int(window_ends(2.0).size()) - 15) <= 1);
	CHECK(session.error(end) <= 1.3);
	CHECK(end.receiver->statistics().late_windows == 0);
}

TEST_CASE("sender: planar bodies are shown in their plane, also after a time without receivers") {
	SimulatedSession session;
	const auto path = [](double t) { return turned_at(Vector3D(std::sin(t), 0.4 * t, 5.0), Vector3D(0, 0, 1), 2.0 * t); };
	const auto planar_path = [path](double t) { return BodyState::planar_part(path(t)); };
	CHECK(session.sender->add_body(1, path(session.now), true));
	session.bodies[1] = { planar_path };
	session.add_body(2, path);
	for (int i = 0; i < 2; ++i) {
		RemoteEnd &end = session.add_receiver(1);
		if (i == 1) {
			CHECK(session.sender->add_body(3, path(session.now), true)); // while the stream runs
			session.bodies[3] = { planar_path };
		}
		session.run(2.0);
		CHECK(session.error(end) <= 1.1);
		for (const auto &body : session.bodies) {
			const PoseD shown = end.receiver->pose(body.first).value_or(path(0.0));
			CHECK(std::abs(shown.translation.z - (body.first == 2 ? 5.0 : 0.0)) <= (body.first == 2 ? 0.01 : 0.0));
		}
		session.sender->remove_receiver(1);
		session.ends.clear();
		session.run(1.0);
	}
}

TEST_CASE("sender: the tolerance of planar bodies reaches the receivers, in the units of both") {
	SimulatedSession session;
	RemoteEnd &end = session.add_receiver(1);
	session.add_body(1, [](double t) { return at(t); });
	session.run(1.0);
	REQUIRE(end.receiver->is_ready());
	CHECK(end.receiver->settings().planar_unit() == doctest::Approx(0.01).epsilon(1e-6)); // 5 mm for half a pixel
	StreamSettings settings = session.sender->settings();
	settings.position_tolerance_2d = 2.0;
	session.sender->set_settings(settings);
	session.run(2.0);
	CHECK(session.error(end) <= 1.1);
	CHECK(end.receiver->settings().position_tolerance_2d == 2.0);
	CHECK(end.receiver->settings().planar_unit() == session.sender->settings().planar_unit());
}
