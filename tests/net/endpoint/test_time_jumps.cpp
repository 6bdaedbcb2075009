#include "../simulated_session.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace net;
using namespace net_test;

namespace {

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
constexpr double INFINITE = std::numeric_limits<double>::infinity();
constexpr double INVALID_TIMES[] = { NOT_A_NUMBER, INFINITE, -INFINITE, 1e13, -1e13, 1e18, 9007199254740993.0, 1e308, -1e308 };

/// Three moving bodies and a receiver that has received them for two seconds.
struct Jumping {
	SimulatedSession session;
	RemoteEnd *end = nullptr;

	explicit Jumping(double clock = 0.0) {
		session.sender_clock = clock;
		add_smooth_bodies(session, 3);
		end = &session.add_receiver(1);
		session.run(2.0);
		CHECK(session.error(*end) <= 1.3);
	}

	[[nodiscard]] uint64_t bytes_sent() const { return session.sender->statistics(1).bytes_sent; }
	/// The greatest error after `seconds`, if media time minus the time of the paths has changed by `shift`.
	double error_after(double seconds, double shift) {
		session.run(seconds);
		session.origin -= shift;
		double worst = 0.0;
		session.run(1.0, [&] { worst = std::max(worst, session.error(*end)); });
		return worst;
	}
};

} // namespace

TEST_CASE("time jumps: the sender's clock jumps forward: media time follows, with a snapshot if the pause is long") {
	for (const double clock : { 0.0, -5000.0, 1.7e9 }) {
		for (const double jump : { 0.5, 3.0, 60.0, 69.0, 86400.0, 71582788.3, 1e9, 1e10 }) {
			CAPTURE(clock);
			CAPTURE(jump);
			Jumping jumping(clock);
			jumping.end->items.clear();
			jumping.session.sender_clock += jump;
			const uint64_t before = jumping.bytes_sent();
			jumping.session.run(0.1);
			CHECK(jumping.bytes_sent() - before < 4000);
			// The paths are not as fine as times this large.
			CHECK(jumping.error_after(4.0, jump) <= (jump > 1e8 ? 1.4 : 1.3));
			CHECK((jumping.end->items.count(0xe0) != 0) == (jump > 4096 * SimulatedSession::TICK));
			CHECK(jumping.end->steps_back == 0);
			CHECK(jumping.end->not_finite == 0);
		}
	}
}

TEST_CASE("time jumps: the sender's clock jumps back: media time goes on from where it is") {
	for (const double clock : { 0.0, -5000.0, 1.7e9, 9e11 }) {
		for (const double jump : { -1.1, -5.0, -86400.0, -1e9, -1.5e12 }) {
			CAPTURE(clock);
			CAPTURE(jump);
			if (clock + jump < -MAX_TIME) {
				continue;
			}
			Jumping jumping(clock);
			jumping.end->items.clear();
			jumping.session.sender_clock += jump;
			jumping.session.run(0.1);
			// No tick passes in the step in which the clock jumps.
			CHECK(jumping.error_after(4.0, -SimulatedSession::TICK) <= (clock > 1e10 ? 1.5 : 1.3));
			CHECK(jumping.end->items.count(0xe0) == 0);
			CHECK(jumping.end->steps_back == 0);
		}
	}
}

TEST_CASE("time jumps: a small step back of the sender's clock makes media time wait") {
	Jumping jumping;
	jumping.session.sender_clock -= 0.5;
	CHECK(jumping.error_after(4.0, -0.5) <= 1.3);
}

TEST_CASE("time jumps: beyond 2^40 ticks the stream starts anew, and receivers follow") {
	Jumping jumping;
	jumping.session.sender_clock += 9e11;
	jumping.session.run(4.0);
	CHECK(jumping.session.sender->media_time(jumping.session.sender_now()) < 10.0);
	jumping.session.origin = jumping.session.now - jumping.session.sender->media_time(jumping.session.sender_now());
	// At such times, a double rounds to 0.0001 s.
	CHECK(jumping.error_after(1.0, 0.0) <= 1.5);
}

TEST_CASE("time jumps: invalid times are refused or ignored, and nothing is lost") {
	for (const double time : INVALID_TIMES) {
		CAPTURE(time);
		Jumping jumping;
		Sender &sender = *jumping.session.sender;
		const PoseD pose = jumping.session.bodies.at(0).path(jumping.session.now);
		jumping.end->items.clear();
		for (int i = 0; i < 10; ++i) {
			CHECK_FALSE(sender.observe(0, time, pose));
			CHECK_FALSE(sender.observe(0, time));
			sender.flush(time);
			sender.flush(time, jumping.session.now);
			const uint8_t ack[] = { 0xc2 };
			(void)sender.accept(1, ack, 1, time);
			std::vector<uint8_t> bytes;
			(void)jumping.end->receiver->accept(ack, 1, time);
			jumping.end->receiver->take_ack(bytes, time);
			jumping.end->receiver->advance(time);
			CHECK(std::isfinite(jumping.end->receiver->media_time_at(time)));
			CHECK(std::isfinite(sender.media_time(time)));
			CHECK_FALSE(jumping.end->receiver->pose_at(0, NOT_A_NUMBER));
			const auto shown = jumping.end->receiver->pose_at(0, time);
			CHECK((!shown || cga_test::is_finite(*shown)));
			jumping.session.run(0.1);
		}
		CHECK(jumping.error_after(1.0, 0.0) <= 1.3);
		CHECK(jumping.end->not_finite == 0);
	}
}

TEST_CASE("time jumps: invalid times before all others do not begin the stream") {
	for (const double time : INVALID_TIMES) {
		SimulatedSession session;
		session.sender->add_receiver(9, time);
		session.sender->flush(time);
		(void)session.sender->add_body(77, PoseD(), false, time);
		CHECK(session.sender->remove_body(77));
		add_smooth_bodies(session, 3);
		session.sender->remove_receiver(9);
		RemoteEnd &end = session.add_receiver(1);
		end.receiver->advance(time);
		session.run(3.0);
		CHECK(session.error(end) <= 1.3);
	}
}

TEST_CASE("time jumps: one observation or body at a wrong time does not disturb those that follow") {
	for (const double wrong : { 101.0 + 90.0, 1e6, 1e9, 1e12, 0.0, -1e12 }) {
		for (const bool idle : { false, true }) {
			CAPTURE(wrong);
			CAPTURE(idle);
			Jumping jumping;
			Sender &sender = *jumping.session.sender;
			if (idle) {
				sender.remove_receiver(1);
			}
			const PoseD pose = jumping.session.bodies.at(0).path(jumping.session.now);
			CHECK(sender.teleport(0));
			CHECK(sender.observe(0, wrong, pose));
			CHECK(sender.observe(1, wrong));
			CHECK(sender.add_body(50, pose, false, wrong));
			CHECK(sender.add_body(51, pose, false, wrong));
			CHECK(sender.observe(51, wrong, pose));
			CHECK(sender.remove_body(51));
			if (idle) {
				jumping.end = &jumping.session.add_receiver(1);
			}
			jumping.session.bodies[50] = { [pose](double) { return pose; } };
			CHECK(jumping.error_after(3.0, 0.0) <= 1.3);
			CHECK_FALSE(jumping.end->receiver->pose(51));
		}
	}
}

TEST_CASE("time jumps: the receiver's clock jumps: playback recovers, in lossy networks too") {
	for (const double loss : { 0.0, 0.05 }) {
		for (const double jump : { 0.5, 3.0, 86400.0, 1e9, 9e11, -0.5, -3.0, -86400.0, -1e9, -9e11 }) {
			CAPTURE(loss);
			CAPTURE(jump);
			Jumping jumping;
			jumping.end->change_links([&](LinkSettings &link) { link.loss = loss; });
			jumping.session.receiver_clock += jump;
			CHECK(jumping.error_after(6.0, 0.0) <= 1.4);
			CHECK(jumping.end->not_finite == 0);
			CHECK(jumping.session.sender_now() - 100.0 - jumping.end->media_time < 0.5);
		}
	}
}

TEST_CASE("time jumps: a sender whose clock jumps often, forward and back, goes on sending") {
	Jumping jumping;
	const double clocks[] = { 0.0, 1e9, 0.0, -1e9, 1e12 - 1e6, -1e12, 3.0, 1e11, 2.0 };
	for (int i = 0; i < 500; ++i) {
		jumping.session.sender_clock = clocks[i % 9];
		jumping.session.receiver_clock = clocks[i * 4 % 9];
		jumping.session.run(0.05);
	}
	jumping.session.sender_clock = 0.0;
	jumping.session.receiver_clock = 5000.0;
	jumping.session.run(5.0);
	jumping.session.origin = jumping.session.now - jumping.session.sender->media_time(jumping.session.now);
	CHECK(jumping.error_after(1.0, 0.0) <= 1.3);
}
