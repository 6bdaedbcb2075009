#include "net/session/body_view.hpp"
#include "session_network.hpp"

#include <algorithm>

using namespace net;
using namespace net_test;

using Phase = BodyView::Phase;

namespace {

constexpr double SPEED = 2.0; // m/s

/// Three peers, and what peer 3 shows of body 5, which moves along x.
struct Watcher {
	SessionNetwork network{ { 0.02 } };
	BodyView view;
	BodyView::Frame frame;
	double x = 0.0; // as shown last
	double max_step = 0.0;
	int standing = 0; // frames in which it does not move
	std::vector<Phase> phases; // without repetitions

	Watcher() {
		for (const PeerId id : { 1, 2, 3 }) {
			network.join(id);
		}
		network.paths[5] = [](double time) {
			PoseD pose;
			pose.translation.x = SPEED * (time - 100.0);
			return pose;
		};
	}

	void follow(PeerId owner, uint64_t min_life = 0) { view.follow({ owner, 5, min_life }, network.local(3)); }

	void run(double seconds) {
		max_step = 0.0;
		standing = 0;
		network.run(seconds, [&] {
			frame = view.frame(network.session(3), network.local(3));
			if (phases.empty() || phases.back() != frame.phase) {
				phases.push_back(frame.phase);
			}
			if (frame.pose) {
				const double step = frame.pose->translation.x - x;
				max_step = std::max(max_step, std::abs(step));
				standing += step < 0.1 * SPEED * network.tick ? 1 : 0;
				x = frame.pose->translation.x;
			}
		});
	}
};

} // namespace

TEST_CASE("body view: a new body is at its first pose until playback reaches it") {
	Watcher watcher;
	watcher.network.set_owner(9, 1);
	watcher.network.paths[9] = [](double) { return PoseD(); };
	watcher.follow(1);
	watcher.run(1.0);
	CHECK(watcher.frame.phase == Phase::UNKNOWN);
	CHECK_FALSE(watcher.frame.pose);
	watcher.network.set_owner(5, 1);
	const double born = SPEED * (watcher.network.now - 100.0);
	watcher.run(0.6);
	CHECK(watcher.phases == std::vector<Phase>{ Phase::UNKNOWN, Phase::UNBORN, Phase::CURRENT });
	CHECK(watcher.view.has_shown());
	CHECK(watcher.x > born);
	CHECK(watcher.view.life() != 0);
}

TEST_CASE("body view: motion continues from one owner to the next, at the media time of both") {
	Watcher watcher;
	watcher.network.set_owner(5, 1);
	watcher.follow(1);
	watcher.run(1.5);
	CHECK(watcher.frame.phase == Phase::CURRENT);
	watcher.phases.clear();
	watcher.network.set_owner(5, 2);
	watcher.follow(2);
	watcher.run(1.0);
	CHECK(watcher.phases == std::vector<Phase>{ Phase::PREVIOUS, Phase::CURRENT });
	CHECK(watcher.standing <= 2);
	CHECK(watcher.max_step < 3.0 * SPEED * watcher.network.tick);
	CHECK_FALSE(watcher.view.has_previous());
}

TEST_CASE("body view: a new node of the same name waits for a new life of its body") {
	Watcher watcher;
	watcher.network.set_owner(5, 1);
	watcher.follow(1);
	watcher.run(1.5);
	const uint64_t life = watcher.view.life();
	REQUIRE(life != 0);
	// The body is removed and added again, elsewhere.
	watcher.network.session(1).remove_body(5);
	watcher.network.paths[5] = [](double time) {
		PoseD pose;
		pose.translation.x = 500.0 + time;
		return pose;
	};
	watcher.network.set_owner(5, 1);
	watcher.view = BodyView();
	watcher.x = 0.0;
	watcher.follow(1, life + 1);
	watcher.phases.clear();
	double min_x = 1e9;
	for (int i = 0; i < 60; ++i) {
		watcher.run(watcher.network.tick);
		min_x = watcher.frame.pose ? std::min(min_x, watcher.frame.pose->translation.x) : min_x;
	}
	CHECK(watcher.frame.phase == Phase::CURRENT);
	CHECK(watcher.view.life() > life);
	CHECK(min_x >= 500.0);
}

TEST_CASE("body view: if only the node was replaced, the old life is shown after a while") {
	Watcher watcher;
	watcher.network.set_owner(5, 1);
	watcher.follow(1);
	watcher.run(1.5);
	const uint64_t life = watcher.view.life();
	watcher.view = BodyView();
	watcher.follow(1, life + 1);
	watcher.run(0.5);
	CHECK(watcher.frame.phase == Phase::UNKNOWN);
	watcher.run(0.5);
	CHECK(watcher.frame.phase == Phase::CURRENT);
}

TEST_CASE("body view: a freed body ends at its last pose") {
	Watcher watcher;
	watcher.network.set_owner(5, 1);
	watcher.follow(1);
	watcher.run(1.5);
	const double end = SPEED * (watcher.network.now - 100.0);
	watcher.network.session(1).free_body(5);
	watcher.network.peers.at(1).owners.clear();
	watcher.run(0.5);
	CHECK(watcher.phases.back() == Phase::ENDED);
	CHECK(std::abs(watcher.x - end) <= 0.006);
}

TEST_CASE("body view: who loses a body keeps it where it is until the new owner's motion begins") {
	Watcher watcher;
	watcher.network.set_owner(5, 3);
	watcher.run(0.5);
	watcher.view.mark_shown();
	watcher.network.set_owner(5, 2);
	watcher.follow(2);
	watcher.phases.clear();
	watcher.run(1.0);
	CHECK(watcher.phases == std::vector<Phase>{ Phase::UNKNOWN, Phase::CURRENT });
}
