#include "../simulated_session.hpp"

#include <doctest/doctest.h>

using namespace net;
using namespace net_test;

namespace {

/// A body that swings at up to 6 m/s and 12 rad/s.
Path swing(uint32_t id) {
	return [id](double t) {
		const double phase = 7.0 * (t - 100.0) + double(id);
		return turned_at(Vector3D(0.8 * std::sin(phase), 0.3 * std::cos(1.3 * phase), double(id)), Vector3D(0.3, 1.0, -0.2), 1.5 * std::sin(1.1 * phase));
	};
}

} // namespace

TEST_CASE("join: all that a new receiver shows is within the tolerance, whether the stream is new or has been running") {
	for (const double running_for : { 0.0, 0.4, 3.0 }) {
		for (const double delay : { 0.0, 0.03, 0.15 }) {
			for (const double latency : { 0.05, 0.2 }) {
				StreamSettings settings;
				settings.max_latency = latency;
				SimulatedSession session(settings);
				for (uint32_t id = 0; id < 6; ++id) {
					session.add_body(id, swing(id));
				}
				if (running_for > 0.0) {
					session.add_receiver(1, { delay });
					session.run(running_for);
				}
				RemoteEnd &end = session.add_receiver(2, { delay });
				double worst = 0.0;
				double first_media = -1e9;
				session.run(2.3, [&] {
					if (end.receiver->is_ready()) {
						first_media = first_media < -1e8 ? end.receiver->media_time() : first_media;
						worst = std::max(worst, session.error(end));
					}
				});
				CAPTURE(running_for);
				CAPTURE(delay);
				CAPTURE(latency);
				CHECK(worst <= 1.3); // the bound holds at samples; this measures between them too
				CHECK(first_media >= 0.0);
				CHECK(end.ready_at > 0.0);
				CHECK(end.steps_back == 0);
			}
		}
	}
}

TEST_CASE("join: a stream begins at the newest poses, also after a pause without receivers, with poses between ticks") {
	for (const double fraction : { 0.0, 0.4, 0.7 }) {
		SimulatedSession session;
		session.add_receiver(9); // media time begins now
		session.sender->remove_receiver(9);
		session.ends.clear();
		session.now += fraction * SimulatedSession::TICK;
		session.add_body(0, swing(0));
		for (int turn = 0; turn < 3; ++turn) {
			session.run(0.71);
			const double joined = session.now;
			RemoteEnd &end = session.add_receiver(1);
			const StreamGrid grid(float(session.sender->settings().position_tolerance), float(session.sender->settings().rotation_tolerance));
			double worst = 0.0;
			int samples = 0;
			double first_media = -1.0;
			session.run(1.5, [&] {
				if (!end.receiver->is_ready()) {
					return;
				}
				const double media_time = end.receiver->media_time();
				first_media = first_media < 0.0 ? media_time : first_media;
				// At the times of the samples, up to the end of the known motion.
				for (double time = joined + SimulatedSession::TICK; time - session.origin <= end.receiver->known_time(); time += SimulatedSession::TICK) {
					if (time - session.origin >= media_time) {
						worst = std::max(worst, error_share(*end.receiver->pose_at(0, time - session.origin), swing(0)(time), grid));
						++samples;
					}
				}
			});
			CAPTURE(fraction);
			CAPTURE(turn);
			CHECK(first_media <= joined - session.origin + (fraction > 0.0 ? 2.0 : 1.0) * SimulatedSession::TICK + 1e-6);
			CHECK(first_media > joined - session.origin);
			CHECK(samples > 200);
			CHECK(worst <= 1.02);
			session.sender->remove_receiver(1);
			session.ends.clear();
		}
	}
}
