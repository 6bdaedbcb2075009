// Fuzzes everything in src/net that parses bytes from a peer. As a program it mutates recorded traffic from a fixed seed,
// as many times as its argument says; with -DLIBFUZZER and -fsanitize=fuzzer it is a libFuzzer target (linked with
// tests/harness). A failure ends it: a sanitizer's report or a violated condition.

#include "input.hpp"
#include "relay_client_target.hpp"
#include "session_target.hpp"

#include "net/endpoint/receiver.hpp"
#include "net/endpoint/sender.hpp"
#include "net/pose_codec.hpp"
#include "net/session/envelope.hpp"
#include "net/stream/stream_decoder.hpp"
#include "net/stream/stream_encoder.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

namespace {

using fuzz::Bytes;
using fuzz::Pieces;
using fuzz::pose_at;
using fuzz::require;
using fuzz::require_finite;
using fuzz::TICK;

constexpr size_t MAX_BODIES = 64;

/// Traffic between a sender and a receiver, and output of the codecs.
struct Recording {
	std::vector<Bytes> packets;
	std::vector<Bytes> acks;
	Bytes snapshot; // of a StreamEncoder
	std::vector<Bytes> windows; // after the snapshot
	Bytes poses; // of the pose codec

	Recording() {
		net::Sender sender{ net::StreamSettings() };
		net::Receiver receiver(MAX_BODIES);
		for (uint32_t id = 0; id < 12; ++id) {
			(void)sender.add_body(id, pose_at(id, 0.0), id % 3 == 0);
		}
		sender.add_receiver(1, 0.0);
		Bytes ack;
		for (int tick = 1; tick < 240; ++tick) {
			const double now = tick * TICK;
			for (uint32_t id = 0; id < 12; ++id) {
				(void)sender.observe(id, now, pose_at(id, now));
			}
			if (tick % 40 == 0) {
				(void)sender.remove_body(uint32_t(tick / 40), tick % 80 == 0);
			}
			sender.flush(now);
			for (const net::OutgoingPacket &packet : sender.packets()) {
				packets.emplace_back(sender.bytes() + packet.begin, sender.bytes() + packet.begin + packet.size);
				(void)receiver.accept(packets.back().data(), packet.size, now);
			}
			receiver.take_ack(ack, now);
			if (!ack.empty()) {
				acks.push_back(ack);
				(void)sender.accept(1, ack.data(), ack.size(), now);
			}
		}
		net::StreamEncoder encoder(0.005f, 1.4f, cga::Mode::SEPARATE);
		for (int window = 0; window < 20; ++window) {
			(void)encoder.add_body(uint32_t(window), window * 12.0, pose_at(0, 0.0), window % 3 == 0);
			if (window % 4 == 3) {
				(void)encoder.jump(uint32_t(window) / 2);
			}
			for (int tick = 1; tick <= 12; ++tick) {
				for (uint32_t id = 0; id <= uint32_t(window); ++id) {
					(void)encoder.observe(id, window * 12.0 + tick, pose_at(id, (window * 12.0 + tick) * TICK));
				}
			}
			(void)encoder.remove_body(uint32_t(window) / 3, window * 12.0 + 7.0, window % 2 == 0);
			Bytes bytes;
			encoder.encode_window(window * 12.0, 12, bytes);
			if (window < 10) {
				snapshot.clear();
				encoder.encode_snapshot(snapshot);
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

void fuzz_receiver(Pieces pieces) {
	net::Receiver receiver(MAX_BODIES);
	Bytes piece;
	Bytes ack;
	std::vector<net::BodyEvent> events;
	for (double now = 1.0; pieces.next(piece); now += TICK) {
		(void)receiver.accept(piece.data(), piece.size(), now);
		receiver.take_ack(ack, now);
		require(ack.size() <= 64, "an acknowledgement has more than 64 bytes");
		receiver.advance(now);
		receiver.take_events(events);
		require(std::isfinite(receiver.media_time()), "the media time is not finite");
		for (uint32_t id = 0; id < 12; ++id) {
			const auto shown = receiver.shown(id);
			require_finite(shown.value_or(net::ShownBody()).pose);
			const auto known = receiver.first_known(id, shown ? shown->life + 1 : 0);
			require_finite(known.value_or(net::ShownBody()).pose);
			require(!shown || receiver.end(id, shown->life) == net::BodyEnd::NONE, "a life that is shown has ended");
			require(!shown || !known || known->life > shown->life, "lives are not ascending");
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
		size_t total = 0;
		for (const net::OutgoingPacket &packet : sender.packets()) {
			require(packet.size <= net::StreamSettings().max_packet_size, "a packet is larger than max_packet_size");
			total += packet.size;
		}
		require(total < 400000, "the sender sends 400,000 bytes or more in a tick");
		(void)sender.accept(1, piece.data(), piece.size(), now);
		require(std::isfinite(sender.statistics(1).round_trip), "the round trip is not finite");
	}
}

void fuzz_decoder(Pieces pieces) {
	net::StreamDecoder decoder(0.005f, 1.4f, MAX_BODIES);
	Bytes piece;
	std::vector<net::BodyMotion> motions;
	if (!pieces.next(piece) || !decoder.read_snapshot(piece.data(), piece.size())) {
		return;
	}
	double begin = 0.0;
	while (pieces.next(piece)) {
		// Without the checksum, which would reject nearly all mutations.
		begin += decoder.decode_window(piece.data(), piece.size(), { 0, 0 }, begin, cga::Mode(piece.size() % 3), motions).value_or(0);
		require(decoder.body_count() <= MAX_BODIES, "the decoder has more than MAX_BODIES bodies");
		for (const net::BodyMotion &motion : motions) {
			require_finite(motion.segment.pose_at(motion.segment.begin + 0.3 * motion.segment.length));
		}
	}
}

void fuzz_pose_codec(Pieces pieces) {
	Bytes piece;
	std::vector<net::BodyPose> bodies;
	while (pieces.next(piece)) {
		require(net::decode(piece.data(), piece.size(), bodies) || bodies.empty(), "a rejected packet has bodies");
		for (const net::BodyPose &body : bodies) {
			require_finite(cga::pose_cast<double>(body.pose));
		}
	}
}

void fuzz_envelope(Pieces pieces) {
	Bytes piece;
	while (pieces.next(piece)) {
		(void)net::read_envelope(piece.data(), piece.size());
	}
}

struct Target {
	const char *name;
	void (*run)(Pieces);
	std::vector<Bytes> (*seed)();
};

const Target TARGETS[] = {
	{ "receiver", fuzz_receiver, [] { return recording().packets; } },
	{ "sender", fuzz_sender, [] { return recording().acks; } },
	{ "decoder", fuzz_decoder, [] {
		 std::vector<Bytes> pieces = recording().windows;
		 pieces.insert(pieces.begin(), recording().snapshot);
		 return pieces;
	 } },
	{ "pose codec", fuzz_pose_codec, [] { return std::vector<Bytes>(4, recording().poses); } },
	{ "envelope", fuzz_envelope, [] { return recording().packets; } },
	{ "session, peer with authority", [](Pieces pieces) { fuzz::fuzz_session(pieces, true, false); }, [] { return fuzz::record_session(false); } },
	{ "session, peer without authority", [](Pieces pieces) { fuzz::fuzz_session(pieces, false, false); }, [] { return fuzz::record_session(false); } },
	{ "relaying session", [](Pieces pieces) { fuzz::fuzz_session(pieces, true, true); }, [] { return fuzz::record_session(true); } },
	{ "client of a relay", fuzz::fuzz_relay_client, fuzz::record_relay },
};
constexpr size_t TARGET_COUNT = sizeof(TARGETS) / sizeof(TARGETS[0]);

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's entry point
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
			for (size_t mutations = random() % 8; mutations > 0; --mutations) {
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
