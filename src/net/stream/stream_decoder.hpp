#pragma once

#include "net/motion/motion_code.hpp"
#include "net/stream/stream_header.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// Something to show of a body, from a time on: a motion, after which it stays where that ends; or that it is gone.
struct BodyMotion {
	uint32_t id = 0;
	bool appears = false; ///< it is new, or jumps here: nothing leads from before to the segment
	bool vanishes = false; ///< it is gone from segment.begin on
	MotionSegment segment;
};

/// The other end of StreamEncoder: reads a state, then the windows after it, one by one. Any bytes are safe input; what
/// cannot be read changes nothing. Times in ticks.
class StreamDecoder {
public:
	StreamDecoder(float position_tolerance, float rotation_tolerance, size_t most_bodies);

	/// What StreamEncoder::encode_state wrote. False, with nothing changed, if it cannot be read.
	[[nodiscard]] bool read_state(const uint8_t *bytes, size_t size);
	/// The window after the last one, which begins at `begin`. Replaces `motions` by what is new, in order of time for each
	/// body. False, with nothing changed, if it cannot be read or does not lead to those bits of `check`
	/// that `check_mask` has.
	[[nodiscard]] bool decode_window(const uint8_t *bytes, size_t size, uint8_t check, uint8_t check_mask, double begin, cga::Mode mode, std::vector<BodyMotion> &motions, int &ticks);

	/// The pose and id of each body at the end of the last window.
	[[nodiscard]] size_t body_count() const { return _bodies.size(); }
	[[nodiscard]] uint32_t id(size_t index) const { return _bodies[index].id; }
	[[nodiscard]] cga::Pose<double> pose(size_t index) const { return _bodies[index].state.pose(_grid); }
	[[nodiscard]] const StreamGrid &grid() const { return _grid; }

private:
	enum class Change : uint8_t {
		NONE,
		APPEARS,
		JUMPS
	};

	struct Body {
		uint32_t id = 0;
		BodyState state;
		int from = 0; // ticks at which it appears or jumps in this window, 0 if it was there
		int until = 0; // ticks at which it is removed, MAX_TICKS + 1 if it is not
		Change change = Change::NONE;
		BodyState reached;
	};

	bool decode_changes(RangeDecoder &coder, int ticks);
	bool decode_motion(RangeDecoder &coder, Body &body, double begin, int ticks, cga::Mode mode, bool &neighbour_active, std::vector<BodyMotion> &motions);
	bool decode_span(RangeDecoder &coder, Body &body, double begin, int ticks, cga::Mode mode, bool &neighbour_active, std::vector<BodyMotion> &motions);

	StreamGrid _grid;
	size_t _most_bodies;
	MotionModels _models;
	MotionModels _new_models;
	std::vector<Body> _bodies;
	std::vector<Body> _new_bodies; // of the window being read
	MotionCode _motion;
	int _last_ticks = 0;
	uint32_t _check = 0;
};

} // namespace net
