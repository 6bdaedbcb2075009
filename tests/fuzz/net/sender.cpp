// A sender with an honest and two hostile receivers. The honest one sees every body within the tolerance, and what the sender
// sends is bounded, whatever the others acknowledge.

#include "live_bytes.hpp"
#include "moving_bodies.hpp"

#include "net/delivery/packet.hpp"

namespace {

using fuzz::Bytes;
using fuzz::Input;
using fuzz::require;

constexpr uint32_t HONEST = 1;
constexpr uint32_t HOSTILE = 2; // and 3
constexpr size_t MAX_MEMORY = 4000000;

void add_runs(net::AckRuns &runs, Input &input) {
	for (size_t count = input.byte() % 8; count > 0; --count) {
		const auto missing = uint16_t(1 + input.byte());
		runs.add(missing, uint16_t(1 + input.below(4096)));
	}
}

void add_hostile_item(Bytes &packet, Input &input) {
	switch (input.byte() % 6) {
		case 0:
		case 1: {
			net::AckItem ack;
			ack.next = decltype(ack.next)(input.bits(2));
			add_runs(ack.later, input);
			ack.packets = decltype(ack.packets)(input.byte());
			net::put_ack(packet, ack);
			break;
		}
		case 2: {
			net::SnapshotAckItem ack;
			ack.snapshot = decltype(ack.snapshot)(input.byte());
			ack.next = decltype(ack.next)(input.bits(2));
			add_runs(ack.later, input);
			net::put_snapshot_ack(packet, ack);
			break;
		}
		case 3:
			net::put_snapshot_request(packet);
			break;
		case 4:
			net::put_alignment(packet, { input.byte(), input.between(0.0, 2.0), input.between(-4.0, 4.0) });
			break;
		default: {
			const Bytes raw = input.take(input.byte() % 32);
			packet.insert(packet.end(), raw.begin(), raw.end());
		}
	}
}

void attack(net::Sender &sender, const Bytes &honest_ack, double now, Input &input) {
	Bytes packet;
	if (input.flag()) {
		packet = honest_ack;
		fuzz::edit(packet, input);
	}
	for (size_t items = input.byte() % 4; items > 0; --items) {
		add_hostile_item(packet, input);
	}
	(void)sender.accept(HOSTILE + uint32_t(input.flag()), packet.data(), packet.size(), now);
}

} // namespace

void fuzz::run(Input input) {
	net::Sender sender{ net::StreamSettings() };
	net::Receiver receiver(64);
	MovingBodies bodies;
	Bytes ack;
	const size_t before = live_bytes();
	int64_t tick = 0;
	const auto step = [&] {
		const double now = double(tick) * TICK;
		bodies.step(sender, tick, input);
		sender.flush(now);
		size_t total = 0;
		for (const net::OutgoingPacket &packet : sender.packets()) {
			require(packet.size <= net::StreamSettings().max_packet_size, "a packet is larger than max_packet_size");
			total += packet.size;
			if (packet.receiver == HONEST) {
				require(receiver.accept(sender.bytes() + packet.begin, packet.size, now).has_value(), "the receiver rejects a packet");
			}
		}
		require(total < 400000, "the sender sends 400,000 bytes or more in a tick");
		receiver.take_ack(ack, now);
		if (!ack.empty()) {
			require(sender.accept(HONEST, ack.data(), ack.size(), now).has_value(), "the sender rejects an acknowledgement");
		}
		receiver.advance(now);
		bodies.check(receiver, sender.statistics(HONEST).relaxation);
		++tick;
	};
	sender.add_receiver(HONEST, 0.0);
	while (!input.is_empty() && tick < 400) {
		const uint8_t choice = input.byte();
		if (choice >= 250) {
			sender.remove_receiver(HOSTILE + uint32_t(input.flag()));
		} else if (choice >= 230) {
			sender.add_receiver(HOSTILE + uint32_t(input.flag()), double(tick) * TICK);
		}
		for (size_t packets = choice % 8; packets > 0 && choice < 230; --packets) {
			attack(sender, ack, double(tick) * TICK, input);
		}
		step();
		for (uint32_t id = HONEST; id <= HOSTILE + 1; ++id) {
			require(!sender.has_receiver(id) || std::isfinite(sender.statistics(id).round_trip), "the round trip is not finite");
		}
		require(live_bytes() < before + MAX_MEMORY, "the hostile receivers make the sender use 4 MB or more");
	}
	for (int rest = 0; rest < 90 && !(receiver.is_ready() && bodies.is_complete(receiver)); ++rest) {
		step();
	}
	require(receiver.is_ready() && bodies.is_complete(receiver), "the honest receiver lacks a body");
}
