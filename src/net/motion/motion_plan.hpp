#pragma once

#include "net/motion/motion_code.hpp"
#include "net/motion/segment_fit.hpp"

namespace net {

/// Splits a body's motion into segments: a single one if it passes all samples within the tolerance, otherwise the longest that
/// does, then the same from its end. Each segment starts in the state that the decoder will have, so errors do not accumulate.
class MotionPlanner {
public:
	MotionPlanner(const StreamGrid &grid, cga::Mode mode) :
			_grid(grid), _fit(grid, mode) {}

	/// Replaces `motion`, except for its `coarseness` and `finer`: tolerances and quantization steps of a moving body are larger by a factor
	/// of 2^coarseness, reduced by 2^finer. The first `count` samples have times in (begin, begin + ticks]; those up to `available` are
	/// look-ahead. Sets `motion.must_jump` if the motion is out of range.
	void plan(const BodyState &state, double begin, int ticks, const MotionSample *samples, size_t count, size_t available, MotionModels &models, MotionCode &motion);

private:
	void plan_moving(const BodyState &state, double begin, int ticks, const MotionSample *samples, size_t count, size_t available, MotionModels &models, MotionCode &motion);
	std::optional<SegmentCode> longest_segment(const BodyState &state, double begin, int ticks, const MotionSample *samples, size_t count, MotionModels &models);
	void plan_resting(const BodyState &state, const MotionSample &last, MotionCode &motion) const;

	StreamGrid _grid;
	SegmentFit _fit;
};

} // namespace net
