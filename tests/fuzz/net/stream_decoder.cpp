// The decoder of snapshots and windows, without the checksum, which would reject nearly all edits.

#include "hostile_stream.hpp"

#include "net/stream/stream_decoder.hpp"

void fuzz::run(Input input) {
	constexpr size_t MAX_BODIES = 64;
	HostileStream stream(input);
	net::StreamDecoder decoder(float(stream.settings().position_tolerance), float(stream.settings().rotation_tolerance), MAX_BODIES);
	std::vector<net::BodyMotion> motions;
	double begin = 0.0;
	for (int step = 0; !input.is_empty() && step < 64; ++step) {
		if (step == 0 || input.byte() >= 250) {
			const Bytes snapshot = input.flag() ? stream.snapshot() : input.take(input.byte());
			(void)decoder.read_snapshot(snapshot.data(), snapshot.size());
		} else {
			int ticks = 0;
			const Bytes window = input.byte() < 200 ? stream.window(ticks) : input.take(input.byte());
			const int length = decoder.decode_window(window.data(), window.size(), { 0, 0 }, begin, cga::Mode(input.byte() % 3), motions).value_or(0);
			require(length >= 0 && length <= net::MAX_TICKS, "the length of a window is out of range");
			begin += length;
		}
		require(decoder.body_count() <= MAX_BODIES, "the decoder has more than MAX_BODIES bodies");
		for (const net::BodyMotion &motion : motions) {
			require_finite(motion.segment.pose_at(motion.segment.begin + 0.3 * motion.segment.length));
			require_finite(motion.segment.pose_at(motion.segment.end()));
		}
		for (size_t i = 0; i < decoder.body_count(); ++i) {
			require_finite(decoder.pose(i));
		}
		// The state can be sent on.
		Bytes state;
		decoder.encode_snapshot(state);
		net::StreamDecoder next(float(stream.settings().position_tolerance), float(stream.settings().rotation_tolerance), MAX_BODIES);
		require(next.read_snapshot(state.data(), state.size()).has_value(), "the decoder's snapshot is rejected");
		require(next.check() == decoder.check(), "the decoder's snapshot has another state");
	}
}
