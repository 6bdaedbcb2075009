#include "cga/object/classify.hpp"
#include "net/endpoint/receiver.hpp"
#include "net/endpoint/sender.hpp"
#include "net/pose_codec.hpp"
#include "playground/document/document.hpp"
#include "playground/document/document_json.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <thread>
#include <vector>

// Different objects may be used in different threads at once: they share no state. tools/test --sanitize runs this with the
// thread sanitizer.

namespace {

constexpr int THREADS = 4;

/// Calls work(thread) in several threads and returns the results.
template <class Work>
auto in_threads(const Work &work) {
	std::vector<decltype(work(0))> results(THREADS);
	std::vector<std::thread> threads;
	threads.reserve(THREADS);
	for (int thread = 0; thread < THREADS; ++thread) {
		threads.emplace_back([&, thread] { results[size_t(thread)] = work(thread); });
	}
	for (std::thread &thread : threads) {
		thread.join();
	}
	return results;
}

/// The lives of the bodies that a receiver has shown.
std::vector<uint64_t> lives_of_stream(int seed) {
	constexpr uint32_t BODIES = 40;
	net::Sender sender{ net::StreamSettings() };
	net::Receiver receiver;
	sender.add_receiver(1, 0.0);
	std::vector<uint8_t> ack;
	std::vector<uint64_t> lives;
	for (int tick = 0; tick < 120; ++tick) {
		const double now = tick / 60.0;
		if (uint32_t(tick) < BODIES) {
			(void)sender.add_body(uint32_t(tick), cga::Pose<double>(), false, now);
		}
		for (uint32_t id = 0; id < BODIES; ++id) {
			cga::Pose<double> pose;
			pose.translation.x = seed + now * id;
			(void)sender.observe(id, now, pose);
		}
		sender.flush(now);
		for (const net::OutgoingPacket &packet : sender.packets()) {
			(void)receiver.accept(sender.bytes() + packet.begin, packet.size, now);
		}
		receiver.take_ack(ack, now);
		(void)sender.accept(1, ack.data(), ack.size(), now);
		receiver.advance(now);
	}
	lives.reserve(BODIES);
	for (uint32_t id = 0; id < BODIES; ++id) {
		lives.push_back(receiver.life_at_known_end(id));
	}
	return lives;
}

std::string edited_document(int seed) {
	playground::Document document;
	(void)document.add("a", "point(1, 2, " + std::to_string(seed) + ")");
	for (int i = 0; i < 40; ++i) {
		const std::string name = "x" + std::to_string(i) + "y";
		(void)document.add(name, i == 0 ? "sphere(a, 2)" : "x" + std::to_string(i - 1) + "y + " + std::to_string(i));
		(void)document.rename("a", i % 2 == 0 ? "b" : "a");
		(void)document.rename("b", "a");
		(void)document.set_attribute(name, "note", std::string("note"));
	}
	const cga::TextResult<cga::Multivector> value = document.evaluate("x39y * a");
	return playground::to_json(document.state()) + (value ? cga::describe(cga::classify(*value)) : value.error().describe());
}

} // namespace

TEST_CASE("threads: each receiver has its own lives, which differ from those of all others") {
	std::set<uint64_t> lives;
	size_t count = 0;
	for (const std::vector<uint64_t> &some : in_threads(lives_of_stream)) {
		CHECK(std::count(some.begin(), some.end(), 0) == 0);
		lives.insert(some.begin(), some.end());
		count += some.size();
	}
	CHECK(lives.size() == count);
}

TEST_CASE("threads: documents are edited and evaluated as alone") {
	const std::vector<std::string> together = in_threads(edited_document);
	for (int seed = 0; seed < THREADS; ++seed) {
		CHECK(together[size_t(seed)] == edited_document(seed));
	}
}

TEST_CASE("threads: poses are encoded as alone") {
	const auto encoded = [](int seed) {
		std::vector<net::BodyPose> bodies(200);
		for (uint32_t id = 0; id < bodies.size(); ++id) {
			bodies[id].id = id;
			bodies[id].pose.translation.x = float(id) * float(seed);
		}
		std::vector<uint8_t> packet;
		(void)net::encode(bodies.data(), bodies.size(), net::Tolerance(), packet);
		return packet;
	};
	const auto together = in_threads(encoded);
	for (int seed = 0; seed < THREADS; ++seed) {
		CHECK(together[size_t(seed)] == encoded(seed));
	}
}
