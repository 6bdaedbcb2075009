#pragma once

#include "net/motion/motion_code.hpp"
#include "net/stream/body_blocks.hpp"
#include "net/stream/decoding_work.hpp"
#include "net/stream/packet_error.hpp"
#include "net/stream/stream_header.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace net {

/// The inverse of StreamEncoder: decodes a snapshot, then the windows after it in order. Any bytes are safe input. If decoding
/// fails, nothing changes. Times in ticks.
class StreamDecoder {
public:
	StreamDecoder(float position_tolerance, float rotation_tolerance, size_t max_bodies) :
			_grid(position_tolerance, rotation_tolerance), _max_bodies(max_bodies) {}

	/// Reads the output of StreamEncoder::encode_snapshot.
	PacketResult read_snapshot(const uint8_t *bytes, size_t size);
	/// Number of bodies that the last snapshot declared, even if it was rejected with TOO_MANY_BODIES.
	[[nodiscard]] size_t declared_count() const { return _declared_count; }
	/// Decodes the next window, which begins at `begin`, and replaces `motions` with its segments, those of each body in order of
	/// time. Returns the window's length in ticks; std::nullopt if it cannot be decoded or its checksum differs.
	[[nodiscard]] std::optional<int> decode_window(const uint8_t *bytes, size_t size, WindowCheck check, double begin, cga::Mode mode, std::vector<BodyMotion> &motions);

	/// Appends the state after the last window, as StreamEncoder::encode_snapshot does.
	void encode_snapshot(std::vector<uint8_t> &bytes);
	/// Eight-bit checksum of the state after the last window.
	[[nodiscard]] uint8_t check() const { return check_bits(_check); }

	void set_max_bodies(size_t max_bodies) { _max_bodies = max_bodies; }
	/// The bodies at the end of the last window.
	[[nodiscard]] size_t body_count() const { return _bodies.size(); }
	[[nodiscard]] uint32_t id(size_t index) const { return _bodies[index].id; }
	[[nodiscard]] cga::Pose<double> pose(size_t index) const { return _bodies[index].state.pose(_grid); }

	/// The work of the last call of read_snapshot or decode_window, also if it failed.
	[[nodiscard]] size_t work() const { return _work; }

private:
	struct Body {
		uint32_t id = 0;
		uint32_t hash = 0; // body_hash()
		BodyState state{};
		int32_t event = NO_EVENT; // index in _events while a window is decoded
	};

	/// The events of one body in a window.
	struct BodyEvents {
		size_t index = 0; // of the body
		bool appears = false;
		bool jumps = false;
		int tick = 0; // at which it appears or jumps, from the window's begin
		int removal_tick = NEVER; // from the window's begin
		bool freed = false; // if removed
		BodyState target{}; // state after a jump
	};

	/// A body before the window that is being decoded.
	struct Saved {
		size_t index;
		Body body;
	};

	static constexpr int NEVER = MAX_TICKS + 1;
	static constexpr int32_t NO_EVENT = -1;

	bool decode_events(RangeDecoder &coder, int ticks);
	bool decode_bodies(RangeDecoder &coder, double begin, int ticks, cga::Mode mode, std::vector<BodyMotion> &motions);
	bool decode_motion(RangeDecoder &coder, Body &body, double begin, int ticks, cga::Mode mode, std::vector<BodyMotion> &motions);
	bool decode_span(RangeDecoder &coder, Body &body, double begin, int ticks, cga::Mode mode, std::vector<BodyMotion> &motions);
	BodyEvents &events_of(size_t index);
	void undo(size_t body_count);
	void remove_bodies();

	StreamGrid _grid;
	size_t _max_bodies;
	size_t _declared_count = 0;
	MotionModels _models;
	std::vector<Body> _bodies;
	BodyBlocks _blocks;
	MotionCode _motion;
	bool _previous_active = false; // the previous body in the list moves in this window
	int _last_ticks = 0;
	int _last_coarseness = 0;
	uint32_t _check = 0;
	uint32_t _hash_sum = 0; // over all bodies
	size_t _work = 0;
	// While a window is decoded:
	std::vector<BodyEvents> _events;
	std::vector<bool> _has_events; // by block
	std::vector<Saved> _saved;
	MotionModels _saved_models;
	AdaptiveBit _saved_block_model;
};

} // namespace net
