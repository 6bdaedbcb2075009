// Hostile bytes for everything in src/net that reads bytes of others. As a program it mutates what a session really sent,
// from fixed seeds, so many times as its argument says; with -DLIBFUZZER and -fsanitize=fuzzer it is libFuzzer's target.
// What fails ends it: by a sanitizer, or by an abort where an answer is not as it must be.

#include "mutation.hpp"

#include "net/delivery/envelope.hpp"
#include "net/pose_codec.hpp"
#include "net/receiver.hpp"
#include "net/sender.hpp"
#include "net/stream/stream_decoder.hpp"
#include "net/stream/stream_encoder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

namespace {

using fuzz::Bytes;

constexpr size_t MAX_BODIES = 64;
constexpr double TICK = 1.0 / 60.0;

void demand(bool condition, const char *what) {
	if (!condition) {
		std::fprintf(stderr, "net_fuzz: %s\n", what);
		std::abort();
	}
}

void demand_sound(const cga::Pose<double> &pose) {
	const double sum = pose.translation.x + pose.translation.y + pose.translation.z + pose.rotation.w + pose.rotation.x + pose.rotation.y + pose.rotation.z + pose.scale;
	demand(std::isfinite(sum) && pose.scale > 0.0, "a pose is not finite");
}

cga::Pose<double> pose_at(uint32_t id, double time) {
	cga::Pose<double> pose;
	pose.translation = cga::Vector3<double>(double(id) + std::sin(time * (1.0 + id)), std::fabs(std::sin(3.0 * time)), 0.1 * time);
	pose.rotation = glm::angleAxis(2.0 * time * id, cga::Vector3<double>(0.6, 0.0, 0.8));
	return pose;
}

/// What a sender and a receiver told each other.
struct Recording {
	std::vector<Bytes> packets;
	std::vector<Bytes> answers;
	Bytes state; // of a StreamEncoder
	std::vector<Bytes> windows; // after it
	Bytes poses; // of the pose codec

	Recording() {
		net::Sender sender{ net::StreamSettings() };
		net::Receiver receiver(MAX_BODIES);
		for (uint32_t id = 0; id < 12; ++id) {
			(void)sender.add_body(id, pose_at(id, 0.0));
		}
		sender.add_receiver(1, 0.0);
		Bytes answer;
		for (int tick = 1; tick < 240; ++tick) {
			const double now = tick * TICK;
			for (uint32_t id = 0; id < 12; ++id) {
				(void)sender.observe(id, now, pose_at(id, now));
			}
			sender.flush(now);
			for (const net::OutgoingPacket &packet : sender.packets()) {
				packets.emplace_back(sender.bytes() + packet.begin, sender.bytes() + packet.begin + packet.size);
				(void)receiver.accept(packets.back().data(), packet.size, now);
			}
			if (receiver.take_answer(answer, now)) {
				answers.push_back(answer);
				(void)sender.accept(1, answer.data(), answer.size(), now);
			}
		}
		net::StreamEncoder encoder(0.005f, 1.4f, cga::Mode::SEPARATE);
		for (int window = 0; window < 20; ++window) {
			(void)encoder.add_body(uint32_t(window), window * 12.0, pose_at(0, 0.0));
			for (int tick = 1; tick <= 12; ++tick) {
				for (uint32_t id = 0; id <= uint32_t(window); ++id) {
					(void)encoder.observe(id, window * 12.0 + tick, pose_at(id, (window * 12.0 + tick) * TICK));
				}
			}
			Bytes bytes;
			encoder.encode_window(window * 12.0, 12, bytes);
			if (window < 10) {
				state.clear();
				encoder.encode_state(state);
			} else {
				windows.push_back(bytes);
			}
		}
		std::vector<net::BodyPose> bodies(10);
		for (uint32_t id = 0; id < 10; ++id) {
			bodies[id] = { id * id, cga::pose_cast<float>(pose_at(id, 1.0)) };
		}
		(void)net::encode(bodies.data(), bodies.size(), net::Tolerance(), poses);
	}
};

const Recording &recording() {
	static const Recording RECORDING;
	return RECORDING;
}

/// Takes pieces of an input: a length in two bytes, then as many bytes as there are of it.
struct Pieces {
	const uint8_t *bytes;
	size_t size;

	bool next(Bytes &piece) {
		if (size < 2) {
			return false;
		}
		const size_t count = std::min<size_t>(bytes[0] | size_t(bytes[1]) << 8, size - 2);
		piece.assign(bytes + 2, bytes + 2 + count);
		bytes += 2 + count;
		size -= 2 + count;
		return true;
	}
};

void fuzz_receiver(Pieces pieces) {
	net::Receiver receiver(MAX_BODIES);
	Bytes piece;
	Bytes answer;
	std::vector<net::BodyEvent> events;
	cga::Pose<double> pose;
	for (double now = 1.0; pieces.next(piece); now += TICK) {
		(void)receiver.accept(piece.data(), piece.size(), now);
		(void)receiver.take_answer(answer, now);
		demand(answer.size() <= 64, "an answer is too long");
		receiver.advance(now);
		receiver.take_events(events);
		demand(std::isfinite(receiver.media_time()), "the media time is not finite");
		for (uint32_t id = 0; id < 12; ++id) {
			if (receiver.pose(id, pose)) {
				demand_sound(pose);
			}
		}
	}
}

void fuzz_sender(Pieces pieces) {
	net::Sender sender{ net::StreamSettings() };
	for (uint32_t id = 0; id < 4; ++id) {
		(void)sender.add_body(id, pose_at(id, 0.0));
	}
	sender.add_receiver(1, 0.0);
	Bytes piece;
	for (double now = TICK; pieces.next(piece); now += TICK) {
		for (uint32_t id = 0; id < 4; ++id) {
			(void)sender.observe(id, now, pose_at(id, now));
		}
		sender.flush(now);
		size_t sum = 0;
		for (const net::OutgoingPacket &packet : sender.packets()) {
			demand(packet.size <= size_t(net::MAX_PACKET_BYTES), "a packet is too long");
			sum += packet.size;
		}
		demand(sum < 400000, "a flood");
		(void)sender.accept(1, piece.data(), piece.size(), now);
		demand(std::isfinite(sender.statistics(1).round_trip), "the round trip is not finite");
	}
}

void fuzz_decoder(Pieces pieces) {
	net::StreamDecoder decoder(0.005f, 1.4f, MAX_BODIES);
	Bytes piece;
	std::vector<net::BodyMotion> motions;
	if (!pieces.next(piece) || !decoder.read_state(piece.data(), piece.size())) {
		return;
	}
	double begin = 0.0;
	while (pieces.next(piece)) {
		int ticks = 0;
		// Without a check: what it is there to catch is what is looked for.
		if (decoder.decode_window(piece.data(), piece.size(), 0, 0, begin, cga::Mode(piece.size() % 3), motions, ticks)) {
			begin += ticks;
		}
		demand(decoder.body_count() <= MAX_BODIES, "too many bodies");
		for (const net::BodyMotion &motion : motions) {
			demand_sound(motion.segment.pose_at(motion.segment.begin + 0.3 * motion.segment.length));
		}
	}
}

void fuzz_pose_codec(Pieces pieces) {
	Bytes piece;
	std::vector<net::BodyPose> bodies;
	while (pieces.next(piece)) {
		const net::CodecStatus status = net::decode(piece.data(), piece.size(), bodies);
		demand(status.error == nullptr || bodies.empty(), "a refused packet has bodies");
		for (const net::BodyPose &body : bodies) {
			demand_sound(cga::pose_cast<double>(body.pose));
		}
	}
}

void fuzz_envelope(Pieces pieces) {
	Bytes piece;
	net::Envelope envelope;
	while (pieces.next(piece)) {
		(void)net::read_envelope(piece.data(), piece.size(), envelope);
	}
}

struct Target {
	const char *name;
	void (*run)(Pieces);
	std::vector<Bytes> (*seed)();
};

const Target TARGETS[] = {
	{ "receiver", fuzz_receiver, [] { return recording().packets; } },
	{ "sender", fuzz_sender, [] { return recording().answers; } },
	{ "decoder", fuzz_decoder, [] {
		 std::vector<Bytes> pieces = recording().windows;
		 pieces.insert(pieces.begin(), recording().state);
		 return pieces;
	 } },
	{ "pose codec", fuzz_pose_codec, [] { return std::vector<Bytes>(4, recording().poses); } },
	{ "envelope", fuzz_envelope, [] { return recording().packets; } },
};
constexpr size_t TARGET_COUNT = sizeof(TARGETS) / sizeof(TARGETS[0]);

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size) {
	if (size > 0) {
		TARGETS[bytes[0] % TARGET_COUNT].run({ bytes + 1, size - 1 });
	}
	return 0;
}

#ifndef LIBFUZZER

namespace {

Bytes input_of(uint8_t target, const std::vector<Bytes> &pieces) {
	Bytes input = { target };
	for (const Bytes &piece : pieces) {
		input.push_back(uint8_t(piece.size()));
		input.push_back(uint8_t(piece.size() >> 8));
		input.insert(input.end(), piece.begin(), piece.end());
	}
	return input;
}

} // namespace

int main(int count, char **arguments) {
	const int rounds = count > 1 ? std::atoi(arguments[1]) : 2000;
	std::mt19937 random(20240601);
	for (size_t target = 0; target < TARGET_COUNT; ++target) {
		const std::vector<Bytes> seed = TARGETS[target].seed();
		for (int round = 0; round < rounds; ++round) {
			std::vector<Bytes> pieces = seed;
			for (size_t wrong = random() % 8; wrong > 0; --wrong) {
				fuzz::mutate(pieces[random() % pieces.size()], random);
			}
			if (random() % 4 == 0) {
				std::swap(pieces[random() % pieces.size()], pieces[random() % pieces.size()]);
			}
			const Bytes input = input_of(uint8_t(target), pieces);
			LLVMFuzzerTestOneInput(input.data(), input.size());
		}
		std::printf("%s: %d inputs\n", TARGETS[target].name, rounds);
	}
	std::printf("[net_fuzz] %d passed, 0 failed\n", int(TARGET_COUNT));
	return 0;
}

#endif
