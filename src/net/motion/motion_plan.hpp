#pragma once

#include "net/motion/motion_code.hpp"
#include "net/motion/segment_fit.hpp"

namespace net {

/// Chooses the segments of a body's motion: one, if one passes all samples within the tolerance; else the longest that
/// does, and so on from its end. The decoder's own state is simulated, so that no error adds up.
class MotionPlanner {
public:
	MotionPlanner(const StreamGrid &grid, cga::Mode mode) :
			_grid(grid), _fit(grid, mode) {}

	/// The first `count` samples have times in (begin, begin + ticks]; up to `available` are known. False if the motion is out of range: the body has to jump.
	bool plan(const BodyState &state, double begin, int ticks, const MotionSample *samples, size_t count, size_t available, MotionModels &models, MotionCode &motion);

private:
	bool plan_moving(const BodyState &state, double begin, int ticks, const MotionSample *samples, size_t count, size_t available, MotionModels &models, MotionCode &motion);
	bool longest_segment(const BodyState &state, double begin, int ticks, const MotionSample *samples, size_t count, MotionModels &models, SegmentFit::Result &result);
	void plan_resting(const BodyState &state, const MotionSample &last, MotionCode &motion) const;

	StreamGrid _grid;
	SegmentFit _fit;
};

} // namespace net
