// A receiver and a hostile sender of well-coded snapshots and windows. Memory stays bounded, and everything shown is finite.

#include "hostile_stream.hpp"

#include "live_bytes.hpp"

#include "net/endpoint/receiver.hpp"

namespace {

using fuzz::require;
using fuzz::require_finite;

constexpr size_t MAX_BODIES = 16;
/// Every body that a stream may contain has a full track.
constexpr size_t MAX_MEMORY = 8000000;

void check(net::Receiver &receiver, uint32_t id) {
	const auto shown = receiver.shown(id);
	require_finite(shown.value_or(net::ShownBody()).pose);
	const auto known = receiver.first_known(id, shown ? shown->life + 1 : 0);
	require_finite(known.value_or(net::ShownBody()).pose);
	require(!shown || receiver.end(id, shown->life) == net::BodyEnd::NONE, "a life that is shown has ended");
	require(!shown || !known || known->life > shown->life, "lives are not ascending");
	require_finite(receiver.pose_at(id, receiver.media_time() + 1.0).value_or(cga::Pose<double>()));
	const uint64_t life = receiver.life_at_known_end(id);
	require_finite(receiver.last_pose(id, life).value_or(cga::Pose<double>()));
}

} // namespace

void fuzz::run(Input input) {
	const size_t before = live_bytes();
	HostileStream stream(input);
	net::Receiver receiver(MAX_BODIES);
	if (input.flag()) {
		receiver.record(1100);
	}
	std::vector<net::BodyEvent> events;
	Bytes ack;
	Bytes last;
	double now = 1.0;
	for (int packets = 0; !input.is_empty() && packets < 64; ++packets) {
		const uint8_t step = input.byte();
		for (int count = step % 8 == 2 ? input.byte() % 64 : 0; count > 0; --count) {
			const Bytes snapshot = stream.fresh_snapshot();
			(void)receiver.accept(snapshot.data(), snapshot.size(), now);
			now += TICK;
			receiver.advance(now);
		}
		Bytes packet = step % 8 == 0 ? last : stream.packet();
		if (step % 8 == 1) {
			edit(packet, input);
		}
		(void)receiver.accept(packet.data(), packet.size(), now);
		last = packet;
		now += step >= 240 ? input.between(0.0, 5.0) : (step >= 128 ? TICK : 0.0);
		receiver.take_ack(ack, now);
		require(ack.size() <= 256, "an acknowledgement has more than 256 bytes");
		receiver.advance(now);
		if (step % 2 == 0) {
			receiver.take_events(events);
		}
		require(std::isfinite(receiver.media_time()) && std::isfinite(receiver.known_time()), "the media time is not finite");
		require(receiver.is_refused() || receiver.stream_size() <= MAX_BODIES, "the stream has more bodies than MAX_BODIES");
		for (uint32_t id = 0; id < HostileStream::ID_LIMIT; id += 3) {
			check(receiver, id);
		}
		for (const uint32_t id : receiver.bodies()) {
			require(receiver.shown(id).has_value(), "a body is shown and has no pose");
		}
		require(live_bytes() < before + MAX_MEMORY, "the hostile sender makes the receiver use 8 MB or more");
	}
	if (receiver.is_ready()) {
		Bytes snapshot;
		receiver.encode_snapshot(snapshot);
		net::Receiver next(MAX_BODIES);
		const net::FragmentItem whole{ 1, 0, 0, 1, snapshot.data(), snapshot.size() };
		Bytes packet;
		net::put_fragment(packet, whole);
		require(snapshot.size() > 60000 || next.accept(packet.data(), packet.size(), now).has_value(), "the snapshot of a receiver is rejected");
	}
}
