#pragma once

#include "net/motion/body_state.hpp"
#include "net/motion/motion_sample.hpp"
#include "net/motion/segment_error.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace net {

/// Searches for the cheapest code of a segment that passes all samples within the tolerance.
///
/// The right Jacobian at each sample makes the path linear in its coefficients. Least squares give the coefficients, rounding
/// them gives a code, and single quantization steps then bring it within the tolerance and make it cheaper.
class SegmentFit {
public:
	static constexpr size_t MAX_SAMPLES = SegmentErrorInput::MAX_SAMPLES;

	SegmentFit(const StreamGrid &grid, cga::Mode mode) :
			_grid(grid), _mode(mode) {}

	/// Loads the samples for segments that start in `state` at `begin`: `count` to pass; those up to `available` are
	/// look-ahead.
	void begin(const BodyState &state, double begin, const MotionSample *samples, size_t count, size_t available);
	/// A code that passes the first `count` samples, whose times are in (begin, begin + ticks], within the tolerance; nothing if
	/// none was found. A search that is not `thorough` is faster, finds fewer codes, and does not look for the cheapest.
	std::optional<SegmentCode> fit(const BodyState &state, int ticks, size_t count, bool thorough, MotionModels &models);
	/// A code that ends as near to sample `index` as possible, whatever the error at other samples; nothing if that is out of
	/// range.
	std::optional<SegmentCode> reach(const BodyState &state, int ticks, size_t index);

private:
	struct Candidate {
		SegmentCode code;
		float error; // in steps
	};
	struct LeastSquares;

	void set_end_target(int ticks);
	/// False if the segment rotates too far.
	bool set_length(const BodyState &state, int ticks, size_t count);
	void subtract_base_path(const BodyState &state, int ticks, const SegmentSteps &steps);
	void round_end(const double end[6], SegmentCode &code) const;
	[[nodiscard]] Candidate evaluate(const SegmentCode &code, float limit) const;
	[[nodiscard]] bool is_within(const Candidate &candidate) const { return candidate.error <= _tolerance; }
	/// Close enough to the tolerance that single steps may bring it within.
	[[nodiscard]] bool is_nearly_within(const Candidate &candidate) const;
	/// In 1/256 bit.
	static uint32_t cost_of(const BodyState &state, MotionModels &models, const SegmentCode &code);
	void improve_error(Candidate &best) const;
	void improve_cost(Candidate &best) const;
	std::optional<SegmentCode> search(const BodyState &state, int ticks, bool thorough, MotionModels &models) const;
	/// Replaces `best`, which is not within the tolerance, with the cheapest code with curvature that is, if there is one.
	void search_curved(const BodyState &state, const SegmentCode &straight, const LeastSquares &sums, bool thorough, MotionModels &models, Candidate &best) const;

	using Row = SegmentErrorInput::Row;

	StreamGrid _grid;
	cga::Mode _mode;

	// All loaded samples.
	const MotionSample *_samples = nullptr;
	size_t _loaded = 0;
	size_t _available = 0;
	double _begin = 0.0;
	cga::Pose<double> _start;
	Row _target[6] = {}; // the rows of SegmentErrorInput; in the padding any numbers
	Row _to_body[9] = {};
	Row _jacobian[9] = {};
	Row _saved_target[6]; // _target before the base path was subtracted

	// The segment to be fitted.
	int _count = 0;
	int _padded = 0;
	Row _u;
	Row _w;
	int64_t _predicted[6];
	double _end_weight = 0.0; // weight of _end_target in the least squares, relative to a sample
	double _end_target[6]; // estimated end, in steps, for a segment that ends after its last sample
	float _tolerance = 0.0f; // in steps, reduced by the error of the scale
	int32_t _scale_change = 0;
};

} // namespace net
