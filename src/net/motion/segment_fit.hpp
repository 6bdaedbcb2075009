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
/// The right Jacobian at each sample linearizes the path in its coefficients. Least squares gives the coefficients, rounding
/// them gives a code, and single quantization steps then bring it within the tolerance and make it cheaper.
class SegmentFit {
public:
	static constexpr size_t MAX_SAMPLES = SegmentErrorInput::MAX_SAMPLES;

	SegmentFit(const StreamGrid &grid, cga::Mode mode) :
			_grid(grid), _mode(mode) {}

	/// Loads the samples for segments that start in `state` at `begin`: `count` to pass, and look-ahead up to `available`.
	/// Keeps the pointer: `samples` must stay unchanged until the last call of fit() or reach() for them.
	void begin(const BodyState &state, double begin, const MotionSample *samples, size_t count, size_t available);
	/// Finds a code that passes the first `count` samples, at times in (begin, begin + ticks], within the tolerance; std::nullopt
	/// if there is none. A search that is not `thorough` is faster, succeeds less often, and does not minimize the cost.
	std::optional<SegmentCode> fit(const BodyState &state, int ticks, size_t count, bool thorough, MotionModels &models);
	/// Returns the code that ends nearest to sample `index`, ignoring all other samples; std::nullopt if the end is out of
	/// range.
	std::optional<SegmentCode> reach(const BodyState &state, int ticks, size_t index);

private:
	struct Candidate {
		SegmentCode code;
		float error; // in steps
	};
	struct LeastSquares;

	/// True if the segment is at most the tolerance, and a bit for rounding, from all samples.
	[[nodiscard]] bool passes_samples(const BodyState &state, const SegmentCode &code) const;
	void set_end_target(int ticks);
	/// False if the segment rotates too far.
	bool set_length(const BodyState &state, int ticks, size_t count);
	void subtract_base_path(const BodyState &state, int ticks, const SegmentSteps &steps);
	/// The code of the predicted motion with the change of scale.
	[[nodiscard]] SegmentCode blank_code(int ticks) const;
	void round_end(const double end[6], SegmentCode &code) const;
	[[nodiscard]] Candidate evaluate(const SegmentCode &code, float limit) const;
	[[nodiscard]] bool is_within(const Candidate &candidate) const { return candidate.error <= _tolerance; }
	/// True if changes by single quantization steps may bring the error within the tolerance.
	[[nodiscard]] bool is_nearly_within(const Candidate &candidate) const { return !is_within(candidate) && candidate.error < 1.15f * _tolerance; }
	/// The coding cost, in units of 1/256 bit.
	static uint32_t cost_of(const BodyState &state, MotionModels &models, const SegmentCode &code);
	void improve_error(Candidate &best) const;
	void improve_cost(Candidate &best) const;
	std::optional<SegmentCode> search(const BodyState &state, int ticks, bool thorough, MotionModels &models) const;
	/// Replaces `best`, which exceeds the tolerance, with the cheapest curved code within the tolerance, if there is one.
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
	bool _planar = false;
	Row _target[6] = {}; // the rows of SegmentErrorInput; the padding is arbitrary
	Row _to_body[9] = {};
	Row _jacobian[9] = {};
	Row _saved_target[6]; // _target before the base path was subtracted

	// The segment being fitted.
	int _count = 0;
	int _padded = 0;
	Row _u;
	Row _w;
	int64_t _predicted[6];
	double _end_weight = 0.0; // weight of _end_target in the least squares, relative to a sample
	double _end_target[6]; // estimated end, in steps, for a segment that ends after its last sample
	int _coarseness = 0;
	float _tolerance = 0.0f; // in steps, reduced by the error of the scale
	int32_t _scale_change = 0;
};

} // namespace net
