#pragma once

#include "net/coding/bit_stream.hpp"
#include "net/motion/body_state.hpp"

#include <algorithm>
#include <array>

namespace net {

/// The longest window, in ticks.
inline constexpr int MAX_TICKS = 64;

/// What is sent of one body's motion over some ticks.
struct MotionCode {
	bool active = false;
	bool settles = false; ///< only where not active
	int32_t offset[6] = { 0, 0, 0, 0, 0, 0 }; ///< of settling, from -16 to 15
	int count = 0; ///< of segments
	std::array<SegmentCode, MAX_TICKS> segments;
};

/// Codes a body's motion over `ticks` from tick `begin`, and moves its state on. `Coder` is a RangeEncoder or a
/// RangeDecoder, which fills `motion`. `sink` gets the state, code, steps and begin of each
/// segment before the state moves on. False for what no encoder writes.
template <class Coder, class Sink>
bool code_motion(Coder &coder, MotionModels &models, BodyState &state, const StreamGrid &grid, double begin, int ticks, bool neighbour_active, MotionCode &motion, Sink &&sink) {
	coder.bit(models.active[state.active ? 1 : 0][neighbour_active ? 1 : 0], motion.active);
	if (!motion.active) {
		if (state.active || state.settled) {
			state.rest();
			return true;
		}
		coder.bit(models.settled, motion.settles);
		if (!motion.settles) {
			return true;
		}
		SegmentSteps steps;
		for (int i = 0; i < 6; ++i) {
			uint32_t value = uint32_t(motion.offset[i] + 16);
			coder.bits(value, 5);
			motion.offset[i] = int32_t(value) - 16;
			steps.displacement[i] = motion.offset[i];
		}
		SegmentCode code;
		code.ticks = ticks;
		sink(state, code, steps, begin);
		return state.settle(motion.offset, grid);
	}
	int index = 0;
	for (int left = ticks; left > 0; ++index) {
		SegmentCode &code = motion.segments[size_t(index)];
		bool split = index + 1 < motion.count;
		if (left > 1) {
			coder.bit(models.split[std::min(index, 2)], split);
		} else {
			split = false;
		}
		if (split) {
			uint32_t less_one = uint32_t(code.ticks - 1);
			coder.bits(less_one, bit_width(uint64_t(left - 2)));
			code.ticks = int(less_one) + 1;
			if (code.ticks >= left) {
				return false;
			}
		} else {
			code.ticks = left;
		}
		state.code(coder, models, code);
		const SegmentSteps steps = state.steps(code);
		sink(state, code, steps, begin);
		if (!state.apply(code, steps, grid)) {
			return false;
		}
		begin += code.ticks;
		left -= code.ticks;
	}
	motion.count = index;
	return true;
}

} // namespace net
