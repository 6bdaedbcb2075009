#pragma once

#include "net/coding/lattice_rotation.hpp"
#include "net/coding/quantization.hpp"
#include "net/coding/residual_model.hpp"
#include "net/coding/stream_grid.hpp"
#include "net/motion/motion_segment.hpp"

#include <algorithm>
#include <cstdint>

namespace net {

/// The coded form of one segment. Coordinates 0 to 2 are the translation in world axes, 3 to 5 the rotation vector in the
/// body's axes at the start of the segment; they form the groups 0 and 1. Of a planar body, 2, 3 and 4 are zero and not coded.
struct SegmentCode {
	int ticks = 1;
	bool fine = false; ///< the residuals are in units of StreamGrid::FINE instead of COARSE; see also BodyState::coarseness
	int32_t residual[6] = { 0, 0, 0, 0, 0, 0 }; ///< actual end minus predicted end
	bool curved[2] = { false, false }; ///< per group: the curvature is not zero
	int32_t curvature[6] = { 0, 0, 0, 0, 0, 0 }; ///< in units of StreamGrid::CURVATURE
	bool scaled = false; ///< the scale changes
	int32_t scale_change = 0; ///< in levels
};

/// The coefficients of a segment, in grid steps: its end relative to its start, and its curvature.
struct SegmentSteps {
	int64_t end[6] = { 0, 0, 0, 0, 0, 0 };
	int64_t curvature[6] = { 0, 0, 0, 0, 0, 0 };

	SegmentSteps() = default;
	/// Decodes a code, given the predicted end and BodyState::coarseness.
	SegmentSteps(const int64_t predicted[6], const SegmentCode &code, int coarseness) {
		const int64_t step = int64_t(code.fine ? StreamGrid::FINE : StreamGrid::COARSE) << coarseness;
		const int64_t curvature_step = int64_t(StreamGrid::CURVATURE) << coarseness;
		for (int i = 0; i < 6; ++i) {
			end[i] = predicted[i] + code.residual[i] * step;
			curvature[i] = code.curved[i / 3] ? code.curvature[i] * curvature_step : 0;
		}
	}
};

/// The adaptive models of a stream of motion.
struct MotionModels {
	static constexpr int MAX_BITS = 1024; ///< upper bound of the number of adaptive bits

	ResidualModel residual[2];
	ResidualModel curvature[2];
	ResidualModel scale;
	AdaptiveBit active[2][2];
	AdaptiveBit split[3]; // another segment follows
	AdaptiveBit fine{ 60000 };
	AdaptiveBit curved[2][2];
	AdaptiveBit scaled[2] = { AdaptiveBit(65000), AdaptiveBit(10000) };
	AdaptiveBit rest_correction{ 50000 };
	AdaptiveBit same_length{ 10000 };
	AdaptiveBit same_coarseness{ 2000 };
	AdaptiveBit same_finer{ 2000 };
	AdaptiveBit has_events{ 60000 };

	template <class Visit>
	void visit(Visit &&visit) {
		for (int group = 0; group < 2; ++group) {
			residual[group].visit(visit);
			curvature[group].visit(visit);
			for (int i = 0; i < 2; ++i) {
				visit(active[group][i]);
				visit(curved[group][i]);
			}
			visit(scaled[group]);
		}
		scale.visit(visit);
		for (AdaptiveBit &bit : split) {
			visit(bit);
		}
		visit(fine);
		visit(rest_correction);
		visit(same_length);
		visit(same_coarseness);
		visit(same_finer);
		visit(has_events);
	}
};

/// The state of a body between two windows, from which sender and receivers predict the next segment. It uses only integers,
/// so that all of them predict the same segment.
class BodyState {
public:
	static constexpr int64_t MAX_STEPS = int64_t(1) << 46; ///< bound of each position coordinate
	static constexpr int32_t MAX_SCALE = MAX_SCALE_LEVEL + 1;
	static constexpr double MIN_SCALE = 1.0 / 65536.0;
	static constexpr double SCALE_LEVELS = SCALE_LEVELS_PER_OCTAVE;

	/// True if a pose is finite and at most 2^46 steps from the origin, with a non-zero rotation and a scale from 2^-16 to 2^16.
	[[nodiscard]] static bool is_in_range(const cga::Pose<double> &pose, const StreamGrid &grid);
	/// The pose of a planar body: `pose` projected onto the plane z = 0, with only the rotation about z.
	[[nodiscard]] static cga::Pose<double> planar_part(const cga::Pose<double> &pose) {
		return { cga::Vector3<double>(pose.translation.x, pose.translation.y, 0.0), cga::Quaternion<double>(pose.rotation.w, 0.0, 0.0, pose.rotation.z), pose.scale };
	}
	/// Quantizes a pose and puts the body at rest there. The pose of a planar body must be its own planar_part(). Returns
	/// false and changes nothing if the pose is out of range.
	[[nodiscard]] bool set_pose(const cga::Pose<double> &pose, const StreamGrid &grid);
	[[nodiscard]] cga::Pose<double> pose(const StreamGrid &grid) const;
	/// Resets velocity, curvature and the predictors' statistics: the body is at rest.
	void reset_motion();

	/// The predicted end of a segment of `ticks`, in steps from its start.
	[[nodiscard]] int64_t predicted(int coordinate, int ticks) const { return predicted_by(best_predictor(coordinate / 3), coordinate, ticks); }
	[[nodiscard]] SegmentSteps steps(const SegmentCode &code) const;
	/// The segment that starts in this state.
	[[nodiscard]] MotionSegment segment(const SegmentCode &code, const SegmentSteps &steps, const StreamGrid &grid, double begin, cga::Mode mode) const;
	/// Advances to the end of a segment. Returns false and changes nothing if the end is out of range.
	[[nodiscard]] bool apply(const SegmentCode &code, const SegmentSteps &steps, const StreamGrid &grid);
	/// Sets `coarseness` and `finer` for a window of `window_coarseness`, in which this body's steps are 2^octaves_finer times smaller.
	void set_coarseness(int window_coarseness, int octaves_finer) {
		finer = uint8_t(octaves_finer);
		coarseness = uint8_t(std::max(window_coarseness - octaves_finer, 0));
	}
	/// Adds `correction`, the remaining quantization error in steps, to the pose of a body at rest. Returns false and
	/// changes nothing if the result is out of range.
	[[nodiscard]] bool correct_rest(const int32_t correction[6], const StreamGrid &grid);

	/// Encodes, decodes or measures a segment that starts in this state, depending on `Coder`.
	template <class Coder>
	void code(Coder &coder, MotionModels &models, SegmentCode &code) const;

	/// Calls visit(number, bits) for each number of the state; `number` is signed and fits in `bits`.
	template <class Visit>
	void visit(Visit &&visit);
	[[nodiscard]] bool is_valid() const;
	[[nodiscard]] uint32_t hash() const;

	/// True if a coordinate of a segment is coded: all six, or of a planar body x, y and the rotation about z.
	[[nodiscard]] bool is_coded(int coordinate) const { return !planar || coordinate < 2 || coordinate == 5; }

	bool planar = false; ///< moves in the plane z = 0 and rotates about z only
	bool active = false; ///< moved in the last window
	bool rest_corrected = true; ///< at rest, and its last sample is matched to within a step
	uint8_t coarseness = 0; ///< of its last segment: the steps of its code were 2^coarseness times larger
	uint8_t finer = 0; ///< in the last coarse window, its steps were 2^finer times smaller than those of other bodies

	static constexpr int MAX_COARSENESS = 8;
	static constexpr int COARSENESS_BITS = 4; ///< of a coarseness, and of `finer`

private:
	enum Predictor {
		HOLD,
		CONSTANT_VELOCITY,
		CONSTANT_ACCELERATION,
		DAMPED,
		PREDICTOR_COUNT
	};

	template <bool PLANAR, class Coder>
	void code_coordinates(Coder &coder, MotionModels &models, SegmentCode &code) const;
	[[nodiscard]] int64_t predicted_by(int predictor, int coordinate, int ticks) const;
	[[nodiscard]] int best_predictor(int group) const;

	int64_t _position[3] = { 0, 0, 0 };
	LatticeRotation _rotation;
	int32_t _scale = 0; // log2 of the scale, in units of 1 / SCALE_LEVELS
	int32_t _velocity[6] = { 0, 0, 0, 0, 0, 0 }; // 1/256 step per tick
	int32_t _curvature[6] = { 0, 0, 0, 0, 0, 0 }; // of the last segment, in steps
	int32_t _ticks = 1; // of the last segment
	int32_t _running_error[2][PREDICTOR_COUNT] = { { 0, 0, 0, 0 }, { 0, 0, 0, 0 } }; // of each predictor, in units of 1/16 step
	MeanMagnitude _residual_mean[2] = { MeanMagnitude(512), MeanMagnitude(512) };
	MeanMagnitude _curvature_mean[2] = { MeanMagnitude(256), MeanMagnitude(256) };
	bool _curved[2] = { false, false }; // whether the last segment was curved, per group
	bool _scaled = false; // whether the last segment was scaled
};

template <class Coder>
void BodyState::code(Coder &coder, MotionModels &models, SegmentCode &code) const {
	if (planar) {
		code_coordinates<true>(coder, models, code);
	} else {
		code_coordinates<false>(coder, models, code);
	}
	coder.bit(models.scaled[_scaled ? 1 : 0], code.scaled);
	if (code.scaled) {
		models.scale.code(coder, code.scale_change, 4096);
	}
}

template <bool PLANAR, class Coder>
void BodyState::code_coordinates(Coder &coder, MotionModels &models, SegmentCode &code) const {
	constexpr int BEGIN[2] = { 0, PLANAR ? 5 : 3 };
	constexpr int END[2] = { PLANAR ? 2 : 3, 6 };
	coder.bit(models.fine, code.fine);
	for (int group = 0; group < 2; ++group) {
		const int32_t mean = _residual_mean[group].value() * (code.fine ? 2 : 1);
		int32_t magnitudes = 0; // sum over the preceding coordinates
		for (int i = 0; i < END[group] - BEGIN[group]; ++i) {
			int32_t &value = code.residual[BEGIN[group] + i];
			models.residual[group].code(coder, value, i == 0 ? mean : (3 * mean + magnitudes * 256 / i) / 4);
			magnitudes += std::min(std::abs(value), MeanMagnitude::MAX);
		}
	}
	for (int group = 0; group < 2; ++group) {
		coder.bit(models.curved[group][_curved[group] ? 1 : 0], code.curved[group]);
		for (int i = BEGIN[group]; code.curved[group] && i < END[group]; ++i) {
			models.curvature[group].code(coder, code.curvature[i], _curvature_mean[group].value());
		}
	}
	for (int i = END[0]; i < BEGIN[1]; ++i) {
		code.residual[i] = code.curvature[i] = 0;
	}
}

template <class Visit>
void BodyState::visit(Visit &&visit) {
	for (int64_t &value : _position) {
		visit(value, 48);
	}
	// The dropped component is negative if the body is planar.
	int32_t dropped = int32_t(_rotation.dropped) - (planar ? 4 : 0);
	visit(dropped, 3);
	planar = dropped < 0;
	_rotation.dropped = uint8_t(dropped + (planar ? 4 : 0));
	for (int i = planar ? 2 : 0; i < 3; ++i) {
		visit(_rotation.level[i], LatticeRotation::BITS);
	}
	visit(_scale, 20);
	visit(active, 2);
	visit(rest_corrected, 2);
	if (!rest_corrected) {
		visit(coarseness, COARSENESS_BITS + 1); // signed
	}
	if (!active) {
		return;
	}
	for (int i = 0; i < 6; ++i) {
		if (is_coded(i)) {
			visit(_velocity[i], 32);
			visit(_curvature[i], 32);
		}
	}
	visit(_ticks, 8);
	visit(finer, COARSENESS_BITS + 1);
	visit(_scaled, 2);
	for (int group = 0; group < 2; ++group) {
		for (int32_t &value : _running_error[group]) {
			visit(value, 20);
		}
		int32_t mean = _residual_mean[group].value();
		visit(mean, 20);
		_residual_mean[group].set_value(mean);
		mean = _curvature_mean[group].value();
		visit(mean, 20);
		_curvature_mean[group].set_value(mean);
		visit(_curved[group], 2);
	}
}

} // namespace net
