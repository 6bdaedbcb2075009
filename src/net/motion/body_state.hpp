#pragma once

#include "net/coding/lattice_rotation.hpp"
#include "net/coding/quantization.hpp"
#include "net/coding/residual_model.hpp"
#include "net/coding/stream_grid.hpp"
#include "net/motion/motion_segment.hpp"

#include <cstdint>

namespace net {

/// What is sent of one segment of a body's motion. Coordinates 0..2 are the translation in the world's axes, 3..5 the
/// rotation vector in the body's; all in steps of the grid.
struct SegmentCode {
	int ticks = 1;
	bool fine = false; ///< `end` counts half steps
	int32_t end[6] = { 0, 0, 0, 0, 0, 0 }; ///< what the prediction of the end is off by
	bool curved[2] = { false, false }; ///< whether `bend` has anything for translation, rotation
	int32_t curvature[6] = { 0, 0, 0, 0, 0, 0 };
	bool scaled = false;
	int32_t scale = 0; ///< change of the scale's level
};

/// A segment in steps: where it ends from where it begins, and how it bends.
struct SegmentSteps {
	int64_t displacement[6] = { 0, 0, 0, 0, 0, 0 };
	int64_t curvature[6] = { 0, 0, 0, 0, 0, 0 };

	SegmentSteps() = default;
	/// What a code stands for where these ends are predicted.
	SegmentSteps(const int64_t predicted[6], const SegmentCode &code) {
		for (int i = 0; i < 6; ++i) {
			displacement[i] = predicted[i] + int64_t(code.end[i]) * (code.fine ? StreamGrid::HALF : StreamGrid::COARSE);
			curvature[i] = code.curved[i / 3] ? int64_t(code.curvature[i]) * StreamGrid::CURVATURE : 0;
		}
	}
};

/// The probabilities of everything in a stream of motion.
struct MotionModels {
	static constexpr int MAX_BITS = 1024; ///< that `visit` visits

	ResidualModel end[2];
	ResidualModel curvature[2];
	ResidualModel scale;
	AdaptiveBit active[2][2];
	AdaptiveBit split[3];
	AdaptiveBit fine{ 60000 };
	AdaptiveBit curved[2][2];
	AdaptiveBit scaled[2] = { AdaptiveBit(65000), AdaptiveBit(10000) };
	AdaptiveBit settled{ 50000 };
	AdaptiveBit same_length{ 10000 };
	AdaptiveBit has_events{ 60000 };

	template <class Visit>
	void visit(Visit &&visit) {
		for (int group = 0; group < 2; ++group) {
			end[group].visit(visit);
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
		visit(settled);
		visit(same_length);
		visit(has_events);
	}
};

/// What sender and receiver both know of a body at the end of a window, in integers, so that both predict the same.
class BodyState {
public:
	static constexpr int64_t MAX_STEPS = int64_t(1) << 46; ///< of a position on an axis
	static constexpr int32_t MAX_SCALE = MAX_SCALE_LEVEL + 1;
	static constexpr double MIN_SCALE = 1.0 / 65536.0;
	static constexpr double SCALE_LEVELS = SCALE_LEVELS_PER_OCTAVE;

	/// True for finite poses within 2^46 steps of the origin, of a rotation that is not zero and a scale of 2^-16 to 2^16.
	[[nodiscard]] static bool can_hold(const cga::Pose<double> &pose, const StreamGrid &grid);
	/// The nearest state to a pose, at rest. False if the pose is out of range.
	[[nodiscard]] bool set_pose(const cga::Pose<double> &pose, const StreamGrid &grid);
	[[nodiscard]] cga::Pose<double> pose(const StreamGrid &grid) const;
	/// Forgets the motion: the body rests.
	void rest();

	/// Where the end of a segment is expected, in steps from its start.
	[[nodiscard]] int64_t predicted(int coordinate, int ticks) const;
	[[nodiscard]] SegmentSteps steps(const SegmentCode &code) const;
	/// The motion of a segment that begins here; the state is not changed.
	[[nodiscard]] MotionSegment segment(const SegmentCode &code, const SegmentSteps &steps, const StreamGrid &grid, double begin, cga::Mode mode) const;
	/// Moves on to the end of a segment. False if that is out of range.
	[[nodiscard]] bool apply(const SegmentCode &code, const SegmentSteps &steps, const StreamGrid &grid);
	/// Goes to a nearby pose without any motion, `offset` in steps: what is left of an error when a body has come to rest.
	[[nodiscard]] bool settle(const int32_t offset[6], const StreamGrid &grid);

	/// Codes a segment that begins here.
	template <class Coder>
	void code(Coder &coder, MotionModels &models, SegmentCode &code) const;

	/// All numbers of the state, for sending it; `visit(number, bits)` with signed numbers of so many bits.
	template <class Visit>
	void visit(Visit &&visit);
	[[nodiscard]] bool is_valid() const;
	[[nodiscard]] uint32_t hash() const;

	bool active = false; ///< moved in the last window
	bool settled = true; ///< rests where it was last seen, as near as the grid allows

private:
	enum Predictor {
		HOLD,
		STEADY,
		ACCELERATED,
		DAMPED,
		PREDICTORS
	};

	[[nodiscard]] int64_t predicted_by(int predictor, int coordinate, int ticks) const;
	[[nodiscard]] int best_predictor(int group) const;

	int64_t _position[3] = { 0, 0, 0 };
	LatticeRotation _rotation;
	int32_t _scale = 0; // log2 in 1 / SCALE_LEVELS
	int32_t _velocity[6] = { 0, 0, 0, 0, 0, 0 }; // 1/256 step a tick
	int32_t _curvature[6] = { 0, 0, 0, 0, 0, 0 }; // of the last segment, steps
	int32_t _ticks = 1; // of the last segment
	int32_t _score[2][PREDICTORS] = { { 0, 0, 0, 0 }, { 0, 0, 0, 0 } }; // recent error, 1/16 steps
	MeanMagnitude _end_mean[2] = { MeanMagnitude(512), MeanMagnitude(512) };
	MeanMagnitude _curvature_mean[2] = { MeanMagnitude(256), MeanMagnitude(256) };
	bool _curved[2] = { false, false };
	bool _scaled = false;
};

template <class Coder>
void BodyState::code(Coder &coder, MotionModels &models, SegmentCode &code) const {
	coder.bit(models.fine, code.fine);
	for (int group = 0; group < 2; ++group) {
		const int32_t mean = _end_mean[group].value() * (code.fine ? 2 : 1);
		int32_t before = 0;
		for (int i = 0; i < 3; ++i) {
			int32_t &value = code.end[3 * group + i];
			models.end[group].code(coder, value, i == 0 ? mean : (3 * mean + before * 256 / i) / 4);
			before += std::abs(value) < MeanMagnitude::MAX ? std::abs(value) : MeanMagnitude::MAX;
		}
	}
	for (int group = 0; group < 2; ++group) {
		coder.bit(models.curved[group][_curved[group] ? 1 : 0], code.curved[group]);
		for (int i = 3 * group; code.curved[group] && i < 3 * group + 3; ++i) {
			models.curvature[group].code(coder, code.curvature[i], _curvature_mean[group].value());
		}
	}
	coder.bit(models.scaled[_scaled ? 1 : 0], code.scaled);
	if (code.scaled) {
		models.scale.code(coder, code.scale, 4096);
	}
}

template <class Visit>
void BodyState::visit(Visit &&visit) {
	for (int64_t &value : _position) {
		visit(value, 48);
	}
	visit(_rotation.dropped, 3);
	for (int32_t &value : _rotation.level) {
		visit(value, LatticeRotation::BITS);
	}
	visit(_scale, 20);
	visit(active, 2);
	visit(settled, 2);
	if (!active) {
		return;
	}
	for (int i = 0; i < 6; ++i) {
		visit(_velocity[i], 32);
		visit(_curvature[i], 32);
	}
	visit(_ticks, 8);
	visit(_scaled, 2);
	for (int group = 0; group < 2; ++group) {
		for (int32_t &value : _score[group]) {
			visit(value, 20);
		}
		int32_t mean = _end_mean[group].value();
		visit(mean, 20);
		_end_mean[group].set_value(mean);
		mean = _curvature_mean[group].value();
		visit(mean, 20);
		_curvature_mean[group].set_value(mean);
		visit(_curved[group], 2);
	}
}

} // namespace net
