#include "session_network.hpp"

#include <algorithm>
#include <vector>

using namespace net;
using namespace net_test;

namespace {

constexpr double SPEED = 2.0; // m/s in the sender's time

/// A server and a client that shows one body, which moves SPEED / 60 meters in each tick that the server makes.
struct MovingBody {
	SessionNetwork network;
	double shown = 0.0;
	double max_step_back = 0.0;
	int frames = 0;
	int frozen = 0;

	explicit MovingBody(const LinkSettings &link = { 0.02 }, uint64_t seed = 0) :
			network(link) {
		network.link_seed = seed;
		network.frames_per_tick = 2;
		network.join(1);
		network.join(2);
		network.paths[5] = [this](double) {
			PoseD pose;
			pose.translation.x = SPEED * double(network.peers.at(1).ticks) * network.tick;
			return pose;
		};
		network.set_owner(5, 1);
	}

	/// Counts the frames in which the body moves less than a tenth of `speed`.
	void run(double seconds, double speed = SPEED) {
		frames = frozen = 0;
		const double frame = network.tick / network.frames_per_tick;
		network.run(seconds, [&] {
			const Receiver *stream = network.session(2).stream(1);
			const auto pose = stream != nullptr ? stream->pose(5) : std::nullopt;
			if (!pose) {
				return;
			}
			const double step = pose->translation.x - shown;
			shown = pose->translation.x;
			++frames;
			frozen += step < 0.1 * speed * frame * network.frames_per_tick ? 1 : 0;
			max_step_back = std::max(max_step_back, -step);
		});
	}

	[[nodiscard]] double delay() { return network.statistics(1, 2).playback_delay; }
	/// How far the body is behind the server's, in seconds of its motion.
	[[nodiscard]] double lag() { return double(network.peers.at(1).ticks) * network.tick - shown / SPEED; }
};

using Seeds = std::vector<uint64_t>;

template <class Number>
Number median(std::vector<Number> values) {
	std::sort(values.begin(), values.end());
	return values[values.size() / 2];
}

} // namespace

TEST_CASE("session: after a server stood still, clients see smooth motion within 0.5 s and the usual delay within 2 s") {
	for (const double max_latency : { 0.05, 0.1, 0.2 }) {
		for (const double seconds : { 0.2, 0.5, 1.0, 3.0, 10.0, 60.0 }) {
			for (const double loss : { 0.0, 0.02 }) {
				CAPTURE(max_latency);
				CAPTURE(seconds);
				CAPTURE(loss);
				LinkSettings link{ 0.02 };
				link.loss = loss;
				// Two losses of the same chunk raise the delay for a while, in one of several runs.
				std::vector<double> added;
				std::vector<int> frozen;
				for (const uint64_t seed : loss == 0.0 ? Seeds{ 0 } : Seeds{ 0, 1000, 2000, 3000, 4000 }) {
					MovingBody body(link, seed);
					StreamSettings settings;
					settings.max_latency = max_latency;
					body.network.session(1).set_settings(settings);
					body.run(5.0);
					const double delay = body.delay();
					body.network.peers.at(1).held_until = body.network.now + seconds;
					body.run(seconds + 0.5);
					body.run(1.5);
					added.push_back(body.delay() - delay);
					frozen.push_back(body.frozen * (loss == 0.0 ? 50 : 10) - body.frames);
					CHECK(body.delay() == doctest::Approx(body.lag() - 0.02).epsilon(0.3));
					CHECK(body.max_step_back < 0.05);
				}
				CHECK(median(frozen) <= 0);
				CHECK(median(added) < (loss == 0.0 ? 0.02 : 0.15));
			}
		}
	}
}

TEST_CASE("session: a server that drops ticks is shown smoothly at its own rate") {
	for (const double rate : { 57.0 / 60.0, 54.0 / 60.0, 40.0 / 60.0, 24.0 / 60.0 }) {
		for (const double max_latency : { 0.05, 0.1, 0.2 }) {
			CAPTURE(rate);
			CAPTURE(max_latency);
			MovingBody body;
			StreamSettings settings;
			settings.max_latency = max_latency;
			body.network.session(1).set_settings(settings);
			body.network.peers.at(1).tick_share = rate;
			body.run(3.0, SPEED * rate);
			body.run(6.0, SPEED * rate);
			CHECK(body.frozen <= body.frames / 50);
			CHECK(body.delay() == doctest::Approx(body.lag() / rate - 0.02).epsilon(0.3));
		}
	}
}

TEST_CASE("session: round trips are measured in local time while the server's ticks stand still or are dropped") {
	for (const bool is_held : { false, true }) {
		for (const double delay : { 0.03, 0.1 }) {
			MovingBody body(LinkSettings{ delay });
			body.run(1.0);
			body.network.peers.at(1).tick_share = is_held ? 1.0 : 0.4;
			for (int i = 0; i < 12; ++i) {
				body.network.peers.at(1).held_until = body.network.now + (is_held ? 0.3 : 0.0);
				body.run(0.5);
			}
			CAPTURE(is_held);
			CAPTURE(delay);
			CHECK(body.network.statistics(2, 1).round_trip >= 2.0 * delay);
			CHECK(body.network.statistics(2, 1).round_trip <= 2.0 * delay + 0.03);
			CHECK(body.network.statistics(2, 1).loss < 0.02);
		}
	}
}

TEST_CASE("session: a server that was paused or blocked knows its receivers' round trips, and sends to them at once") {
	for (const bool is_blocked : { false, true }) {
		for (const double seconds : { 0.5, 2.0, 10.0, 60.0 }) {
			MovingBody body(LinkSettings{ 0.05 });
			body.run(4.0);
			SessionNetwork::Peer &server = body.network.peers.at(1);
			(is_blocked ? server.blocked_until : server.held_until) = body.network.now + seconds;
			body.run(seconds);
			const double resumed = body.network.now;
			body.run(0.65);
			CAPTURE(is_blocked);
			CAPTURE(seconds);
			CHECK(body.network.packets(1, 2, PacketKind::MOTION, resumed).size() >= 2);
			CHECK(body.network.statistics(2, 1).round_trip >= 0.0999);
			CHECK(body.network.statistics(2, 1).round_trip <= 0.2);
			body.run(1.5);
			CHECK(body.frozen <= body.frames / 50);
			CHECK(body.network.statistics(2, 1).loss < 0.1);
			CHECK(body.network.packets(1, 2, PacketKind::MOTION, resumed).front().envelope.link == body.network.packets(1, 2, PacketKind::MOTION).front().envelope.link);
		}
	}
}

TEST_CASE("session: a server that stood still and then makes up for ticks, all at once, on lines with jitter") {
	for (const bool relay : { false, true }) {
		for (const double delay : { 0.001, 0.005, 0.02, 0.05 }) {
			for (const double jitter : { 0.0, 0.005, 0.015 }) {
				for (const double max_latency : { 0.05, 0.1, 0.2 }) {
					for (const double seconds : { 0.2, 0.3, 0.5, 1.0, 1.03, 3.0 }) {
						CAPTURE(relay);
						CAPTURE(delay);
						CAPTURE(jitter);
						CAPTURE(max_latency);
						CAPTURE(seconds);
						MovingBody body({ delay, jitter });
						StreamSettings settings;
						settings.max_latency = max_latency;
						body.network.session(1).set_settings(settings);
						body.network.session(1).set_relay(relay);
						body.network.session(2).set_relay(relay);
						body.network.peers.at(1).max_catch_up = 8; // as Godot does
						body.run(5.0);
						const double usual = body.delay();
						body.network.peers.at(1).held_until = body.network.now + seconds;
						body.run(seconds + 0.5);
						body.run(1.5);
						CHECK(body.frozen <= 2);
						CHECK(body.delay() < usual + 0.03);
					}
				}
			}
		}
	}
}

TEST_CASE("session: a slow server on a line with jitter and losses") {
	for (const double rate : { 0.95, 0.9, 0.8, 0.67, 0.5, 0.4 }) {
		for (const double delay : { 0.001, 0.02, 0.05 }) {
			for (const double loss : { 0.0, 0.02, 0.05 }) {
				for (const double max_latency : { 0.05, 0.1, 0.2 }) {
					CAPTURE(rate);
					CAPTURE(delay);
					CAPTURE(loss);
					CAPTURE(max_latency);
					LinkSettings link{ delay, 0.01 };
					link.loss = loss;
					std::vector<int> frozen;
					for (const uint64_t seed : loss == 0.0 ? Seeds{ 0 } : Seeds{ 0, 2000, 3000 }) {
						MovingBody body(link, seed);
						StreamSettings settings;
						settings.max_latency = max_latency;
						body.network.session(1).set_settings(settings);
						body.network.session(2).set_margin_limits(0.0, 0.2);
						body.run(4.0);
						body.network.peers.at(1).tick_share = rate;
						body.run(3.0, SPEED * rate);
						body.run(5.0, SPEED * rate);
						frozen.push_back(body.frozen * (loss == 0.0 ? 50 : 20) - body.frames);
					}
					CHECK(median(frozen) <= 0);
				}
			}
		}
	}
}
