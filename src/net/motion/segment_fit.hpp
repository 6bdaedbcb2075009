#pragma once

#include "net/motion/body_state.hpp"
#include "net/motion/motion_sample.hpp"
#include "net/motion/segment_error.hpp"

#include <cstddef>
#include <cstdint>

namespace net {

/// Searches for the cheapest code of a segment that passes all samples within the tolerance.
///
/// The path is linear in its coefficients but for the curvature of rotations, which the right Jacobian of each sample
/// takes out: least squares give coefficients, rounding them gives a code, and single steps then make it feasible and
/// cheap. Errors of all samples are computed side by side.
class SegmentFit {
public:
	static constexpr size_t MAX_SAMPLES = SegmentErrorInput::MAX_SAMPLES;

	struct Result {
		SegmentCode code;
		float error = 0.0f; ///< in steps
	};

	SegmentFit(const StreamGrid &grid, cga::Mode mode) :
			_grid(grid), _mode(mode) {}

	/// The samples of the segments to come, which begin at `begin` in `state`: `count` that may be passed, `available` known.
	void begin(const BodyState &state, double begin, const MotionSample *samples, size_t count, size_t available);
	/// Of the samples the first `count` have times in (begin, begin + ticks]. True if `result` passes them within the
	/// tolerance; `thoroughly`: and is as cheap as can be found.
	bool fit(const BodyState &state, int ticks, size_t count, bool thoroughly, MotionModels &models, Result &result);
	/// A code that ends where sample `index` is as nearly as possible, whatever is between. False if none reaches it.
	bool reach(const BodyState &state, int ticks, size_t index, Result &result);

private:
	void pin_end(int ticks);
	bool set_length(const BodyState &state, int ticks, size_t count);
	void subtract_base_path(const BodyState &state, int ticks, const SegmentSteps &steps);
	void round_end(const double displacement[6], SegmentCode &code) const;
	bool try_code(const SegmentCode &code, float limit, Result &result) const;
	/// In 1/256 bit.
	static uint32_t cost_of(const BodyState &state, MotionModels &models, const SegmentCode &code);
	bool improve_error(Result &result) const;
	void improve_cost(Result &result) const;
	[[nodiscard]] float error_of(const SegmentSteps &steps, float limit) const;
	bool search(const BodyState &state, int ticks, bool thoroughly, MotionModels &models, Result &result);

	using Row = SegmentErrorInput::Row;

	StreamGrid _grid;
	cga::Mode _mode;

	// Of all samples that were loaded.
	const MotionSample *_samples = nullptr;
	size_t _loaded = 0;
	size_t _known = 0;
	double _begin = 0.0;
	cga::Pose<double> _start;
	Row _target[6]; // steps from the start
	Row _to_body[9]; // world's axes to the body's at the sample
	Row _jacobian[9]; // change of the rotation vector to the body's rotation at the sample
	Row _base_target[6]; // _target before the mode's path was subtracted

	// Of a segment of some length.
	int _count = 0;
	int _padded = 0;
	Row _u;
	Row _w;
	int64_t _predicted[6];
	double _pin_weight = 0.0; // of a guess of where the end is, for segments that end after their last sample
	double _pin[6];
	float _tolerance = 0.0f; // in steps, less what the scale takes of it
	int32_t _scale_change = 0;
};

} // namespace net
