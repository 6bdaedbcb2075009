#pragma once

#include "net/coding/bit_stream.hpp"
#include "net/motion/body_state.hpp"

#include <algorithm>
#include <array>

namespace net {

/// Maximum length of a window, in ticks.
inline constexpr int MAX_TICKS = 64;

/// The coded form of one body's motion over some ticks.
struct MotionCode {
	int coarseness = 0; ///< of the window, from 0 to BodyState::MAX_COARSENESS; set by the caller
	int finer = 0; ///< the body's BodyState::finer in this window, if that is coarse
	bool active = false;
	bool has_rest_correction = false; ///< only if not active
	int32_t rest_correction[6] = { 0, 0, 0, 0, 0, 0 }; ///< in steps, from -16 to 15 times 2^BodyState::coarseness
	bool must_jump = false; ///< set by MotionPlanner: no code reaches the samples, so the body rests, then jumps to its next pose
	int count = 0; ///< number of segments if active
	std::array<SegmentCode, MAX_TICKS> segments;

	static constexpr int REST_BITS = 5; ///< of a coordinate of a rest correction, plus BodyState::coarseness
};

/// Codes a body's motion over `ticks` from tick `begin` and advances its state. `Coder` is a RangeEncoder or a RangeDecoder,
/// which fills `motion`. Calls on_segment(state, code, steps, begin) before the state advances past each segment. False if the
/// input is malformed.
template <class Coder, class OnSegment>
bool code_motion(Coder &coder, MotionModels &models, BodyState &state, const StreamGrid &grid, double begin, int ticks, bool previous_active, MotionCode &motion, OnSegment &&on_segment) {
	coder.bit(models.active[state.active ? 1 : 0][previous_active ? 1 : 0], motion.active);
	if (!motion.active) {
		if (state.active || state.rest_corrected) {
			state.reset_motion();
			return true;
		}
		coder.bit(models.rest_correction, motion.has_rest_correction);
		if (!motion.has_rest_correction) {
			return true;
		}
		const int bits = MotionCode::REST_BITS + state.coarseness;
		const int32_t offset = 1 << (bits - 1);
		SegmentSteps steps;
		for (int i = 0; i < 6; ++i) {
			if (!state.is_coded(i)) {
				motion.rest_correction[i] = 0;
				continue;
			}
			uint32_t value = uint32_t(motion.rest_correction[i] + offset);
			coder.bits(value, bits);
			motion.rest_correction[i] = int32_t(value) - offset;
			steps.end[i] = motion.rest_correction[i];
		}
		on_segment(state, SegmentCode{ ticks }, steps, begin);
		return state.correct_rest(motion.rest_correction, grid);
	}
	if (motion.coarseness > 0) {
		bool is_same = motion.finer == state.finer;
		coder.bit(models.same_finer, is_same);
		uint32_t finer = uint32_t(is_same ? state.finer : motion.finer);
		if (!is_same) {
			coder.bits(finer, BodyState::COARSENESS_BITS);
		}
		motion.finer = std::min(int(finer), BodyState::MAX_COARSENESS);
	}
	state.set_coarseness(motion.coarseness, motion.coarseness > 0 ? motion.finer : state.finer);
	int index = 0;
	for (int left = ticks; left > 0; ++index) {
		SegmentCode &code = motion.segments[size_t(index)];
		bool split = left > 1 && index + 1 < motion.count;
		if (left > 1) {
			coder.bit(models.split[std::min(index, 2)], split);
		}
		if (split) {
			uint32_t ticks_minus_one = uint32_t(code.ticks - 1);
			coder.bits(ticks_minus_one, bit_width(uint64_t(left - 2)));
			code.ticks = int(ticks_minus_one) + 1;
			if (code.ticks >= left) {
				return false;
			}
		} else {
			code.ticks = left;
		}
		state.code(coder, models, code);
		const SegmentSteps steps = state.steps(code);
		on_segment(state, code, steps, begin);
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
