#include "net/motion/segment_fit.hpp"

#include "net/coding/portable_math.hpp"
#include "net/coding/rotation_vector.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace net {

namespace {

/// If a segment ends more ticks than this after its last sample, its end gets a target: a pose interpolated between the last
/// sample and the next one or, without a next one, the last sample, with LAST_SAMPLE_WEIGHT.
constexpr double MAX_UNOBSERVED_END = 0.25;
constexpr double LAST_SAMPLE_WEIGHT = 0.2;
/// Share of the tolerance that a verified path may have: it is computed in double precision, the search in single.
constexpr double VERIFIED = 1.02;
constexpr double MAX_ROTATION = 6.0; // of a segment, in radians
constexpr float NO_LIMIT = 1e18f;
constexpr int32_t MAX_CODE = ResidualModel::MAX_MAGNITUDE / 2;
constexpr int COEFFICIENTS = 12;

int32_t &coefficient(SegmentCode &code, int index) {
	return index < 6 ? code.residual[index] : code.curvature[index - 6];
}

/// Coefficients that are not coded for planar bodies.
constexpr bool is_spatial(int index) {
	return index % 6 >= 2 && index % 6 <= 4;
}

} // namespace

/// Sums over the samples (u, w, y) for the normal equations of the least-squares problem y = end u + curvature w.
struct SegmentFit::LeastSquares {
	double uu = 0.0;
	double uw = 0.0;
	double ww = 0.0;
	double uy[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
	double wy[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };

	LeastSquares(const Row *target, const float *u_row, const float *w_row, size_t count) {
		for (size_t k = 0; k < count; ++k) {
			const double u = u_row[k];
			const double w = w_row[k];
			uu += u * u;
			uw += u * w;
			ww += w * w;
			for (int i = 0; i < 6; ++i) {
				uy[i] += u * double(target[i][k]);
				wy[i] += w * double(target[i][k]);
			}
		}
	}
};

void SegmentFit::begin(const BodyState &state, double begin, const MotionSample *samples, size_t count, size_t available) {
	_samples = samples;
	_loaded = std::min(count, MAX_SAMPLES);
	_available = available;
	_begin = begin;
	_start = state.pose(_grid);
	_planar = state.planar;
	const cga::Quaternion<double> inverse_start = glm::conjugate(_start.rotation);
	cga::Vector3<double> previous(0.0);
	if (_loaded > 0) {
		const int ticks = std::max(1, int(std::ceil(samples[0].time - begin)));
		for (int i = 0; i < 3; ++i) {
			previous[i] = double(state.predicted(3 + i, ticks)) * _grid.rotation_step;
		}
	}
	for (size_t k = 0; k < _loaded; ++k) {
		const cga::Pose<double> &pose = samples[k].pose;
		const cga::Vector3<double> translation = (pose.translation - _start.translation) / _grid.position_step;
		const cga::Vector3<double> rotation = unwrapped(log_rotation(inverse_start * pose.rotation), previous);
		previous = rotation;
		const glm::dmat3 body_axes = glm::mat3_cast(pose.rotation); // its columns are the rows of the inverse
		double jacobian[9];
		right_jacobian(rotation, jacobian);
		for (size_t i = 0; i < 3; ++i) {
			_target[i][k] = float(translation[int(i)]);
			_target[3 + i][k] = float(rotation[int(i)] / _grid.rotation_step);
		}
		for (int i = 0; i < 9; ++i) {
			_to_body[i][k] = float(body_axes[i / 3][i % 3]);
			_jacobian[i][k] = float(jacobian[i]);
		}
	}
}

void SegmentFit::set_end_target(int ticks) {
	const double end = _begin + ticks;
	const size_t k = size_t(_count - 1);
	const MotionSample &last = _samples[k];
	for (size_t i = 0; i < 6; ++i) {
		_end_target[i] = double(_target[i][k]);
	}
	_end_weight = end - last.time > MAX_UNOBSERVED_END ? LAST_SAMPLE_WEIGHT : 0.0;
	if (_end_weight > 0.0 && k + 1 < _available) {
		const MotionSample &next = _samples[k + 1];
		const double fraction = (end - last.time) / (next.time - last.time);
		const cga::Vector3<double> translation = (next.pose.translation - _start.translation) / _grid.position_step;
		const cga::Vector3<double> previous = cga::Vector3<double>(_end_target[3], _end_target[4], _end_target[5]) * _grid.rotation_step;
		const cga::Vector3<double> rotation = unwrapped(log_rotation(glm::conjugate(_start.rotation) * next.pose.rotation), previous) / _grid.rotation_step;
		for (int i = 0; i < 3; ++i) {
			_end_target[i] += fraction * (translation[i] - _end_target[i]);
			_end_target[3 + i] += fraction * (rotation[i] - _end_target[3 + i]);
		}
		_end_weight = 1.0;
	}
}

bool SegmentFit::set_length(const BodyState &state, int ticks, size_t count) {
	_coarseness = state.coarseness;
	_count = int(std::min(count, _loaded));
	_padded = (_count + 7) / 8 * 8;
	const double ratio = _samples[_count - 1].pose.scale / _start.scale;
	const double level = ratio == 1.0 ? 0.0 : portable_log2(ratio) * BodyState::SCALE_LEVELS;
	_scale_change = std::fabs(level) < 1.0 ? 0 : int32_t(std::round(std::clamp(level, -1e6, 1e6)));
	double scale_error = 0.0;
	for (size_t k = 0; k < size_t(_count); ++k) {
		const double u = (_samples[k].time - _begin) / ticks;
		_u[k] = float(u);
		_w[k] = float(u * (1.0 - u));
		const double scale = _start.scale * (_scale_change == 0 ? 1.0 : portable_exp2(u * _scale_change / BodyState::SCALE_LEVELS));
		scale_error = std::max(scale_error, std::fabs(scale - _samples[k].pose.scale));
	}
	std::fill(_u + _count, _u + _padded, 0.0f);
	std::fill(_w + _count, _w + _padded, 0.0f);
	for (int i = 0; i < 6; ++i) {
		_predicted[i] = state.predicted(i, ticks);
	}
	set_end_target(ticks);
	_tolerance = float(StreamGrid::TOLERANCE * (1 << _coarseness) - scale_error * _grid.lever_arm / _grid.position_step);
	const size_t last = size_t(_count - 1);
	const double max_component = double(std::max({ std::fabs(_target[3][last]), std::fabs(_target[4][last]), std::fabs(_target[5][last]) })) * _grid.rotation_step;
	return max_component < MAX_ROTATION;
}

void SegmentFit::subtract_base_path(const BodyState &state, int ticks, const SegmentSteps &steps) {
	// Subtract the deviation of the mode's path from u times its end. It is approximate, as `steps` only estimates the end.
	const MotionSegment path = state.segment(SegmentCode{ ticks }, steps, _grid, 0.0, _mode);
	for (size_t k = 0; k < size_t(_count); ++k) {
		const double u = double(_u[k]);
		const cga::Pose<double> pose = path.pose_at(u * ticks);
		const cga::Vector3<double> translation = (pose.translation - path.start.translation - path.displacement * u) / _grid.position_step;
		const cga::Vector3<double> rotation = log_rotation(glm::conjugate(path.start.rotation * exp_rotation(path.rotation * u)) * pose.rotation) / _grid.rotation_step;
		for (size_t i = 0; i < 3; ++i) {
			_target[i][k] -= float(translation[int(i)]);
			_target[3 + i][k] -= float(rotation[int(i)]);
		}
	}
}

SegmentCode SegmentFit::blank_code(int ticks) const {
	SegmentCode code{ ticks };
	code.scaled = _scale_change != 0;
	code.scale_change = _scale_change;
	return code;
}

void SegmentFit::round_end(const double end[6], SegmentCode &code) const {
	const double step = (code.fine ? StreamGrid::FINE : StreamGrid::COARSE) << _coarseness;
	for (int i = 0; i < 6; ++i) {
		const double value = (end[i] - double(_predicted[i])) / step;
		code.residual[i] = int32_t(std::clamp(std::nearbyint(value), double(-MAX_CODE - 1), double(MAX_CODE + 1)));
	}
}

SegmentFit::Candidate SegmentFit::evaluate(const SegmentCode &code, float limit) const {
	Candidate candidate{ code, 0.0f };
	for (int group = 0; group < 2; ++group) {
		const int32_t *curvature = code.curvature + ptrdiff_t(3) * group;
		candidate.code.curved[group] = (curvature[0] | curvature[1] | curvature[2]) != 0;
	}
	const SegmentSteps steps(_predicted, candidate.code, _coarseness);
	SegmentErrorInput input = { _target, _to_body, _jacobian, _u, _w, size_t(_padded), {}, {} };
	for (int i = 0; i < 6; ++i) {
		input.end[i] = float(steps.end[i]);
		input.curvature[i] = float(steps.curvature[i]);
	}
	candidate.error = segment_error(input, limit);
	return candidate;
}

uint32_t SegmentFit::cost_of(const BodyState &state, MotionModels &models, const SegmentCode &code) {
	CostMeter meter;
	SegmentCode counted = code;
	state.code(meter, models, counted);
	return meter.cost();
}

void SegmentFit::improve_error(Candidate &best) const {
	for (int i = 0; i < COEFFICIENTS; ++i) {
		if ((i >= 6 && !best.code.curved[(i - 6) / 3]) || (_planar && is_spatial(i))) {
			continue;
		}
		for (const int32_t step : { -1, 1 }) {
			SegmentCode code = best.code;
			coefficient(code, i) += step;
			const Candidate candidate = evaluate(code, best.error);
			if (candidate.error < best.error) {
				best = candidate;
				break;
			}
		}
		if (is_within(best)) {
			return;
		}
	}
}

void SegmentFit::improve_cost(Candidate &best) const {
	// Assume that a coefficient nearer to zero is cheaper. Computing the cost would rarely change the choice.
	for (int i = 0; i < COEFFICIENTS; ++i) {
		const int32_t value = coefficient(best.code, i);
		if (value == 0) {
			continue;
		}
		SegmentCode code = best.code;
		coefficient(code, i) += value > 0 ? -1 : 1;
		const Candidate candidate = evaluate(code, _tolerance);
		if (is_within(candidate)) {
			best = candidate;
		}
	}
}

std::optional<SegmentCode> SegmentFit::search(const BodyState &state, int ticks, bool thorough, MotionModels &models) const {
	LeastSquares sums(_target, _u, _w, size_t(_count));
	sums.uu += _end_weight;
	double end[6];
	for (int i = 0; i < 6; ++i) {
		sums.uy[i] += _end_weight * _end_target[i];
		end[i] = sums.uy[i] / sums.uu;
	}
	SegmentCode straight = blank_code(ticks);
	round_end(end, straight);
	Candidate best = evaluate(straight, NO_LIMIT);
	if (thorough && is_nearly_within(best)) {
		improve_error(best);
	}
	if (!is_within(best) && _count <= 2) {
		SegmentCode fine = straight;
		fine.fine = true;
		round_end(end, fine);
		best = evaluate(fine, NO_LIMIT);
		if (!is_within(best)) {
			improve_error(best);
		}
	} else if (!is_within(best)) {
		search_curved(state, straight, sums, thorough, models, best);
	}
	if (!is_within(best)) {
		return std::nullopt;
	}
	if (thorough) {
		improve_cost(best);
	}
	return best.code;
}

void SegmentFit::search_curved(const BodyState &state, const SegmentCode &straight, const LeastSquares &sums, bool thorough, MotionModels &models, Candidate &best) const {
	const double determinant = sums.uu * sums.ww - sums.uw * sums.uw;
	if (!(determinant > 1e-3 * sums.uu * sums.ww)) {
		return;
	}
	SegmentCode curved = straight;
	double end[6];
	for (int i = 0; i < 6; ++i) {
		end[i] = (sums.uy[i] * sums.ww - sums.wy[i] * sums.uw) / determinant;
	}
	round_end(end, curved);
	const SegmentSteps steps(_predicted, curved, _coarseness);
	for (int i = 0; i < 6; ++i) {
		const double curvature = (sums.wy[i] - double(steps.end[i]) * sums.uw) / sums.ww;
		curved.curvature[i] = int32_t(std::clamp(std::nearbyint(curvature / (StreamGrid::CURVATURE << _coarseness)), double(-MAX_CODE), double(MAX_CODE)));
	}
	uint32_t min_cost = 0;
	// Bits of `groups`: 1 for curvature of the translation, 2 for curvature of the rotation.
	for (int groups = thorough ? 1 : 3; groups <= 3; ++groups) {
		SegmentCode code = straight;
		for (int i = 0; i < 6; ++i) {
			if (((groups >> (i / 3)) & 1) != 0) {
				code.residual[i] = curved.residual[i];
				code.curvature[i] = curved.curvature[i];
			}
		}
		Candidate candidate = evaluate(code, NO_LIMIT);
		if (thorough && groups == 3 && !is_within(best) && is_nearly_within(candidate)) {
			improve_error(candidate);
		}
		if (!is_within(candidate)) {
			continue;
		}
		// The cost matters only if there is a choice.
		const bool is_only = groups == 3 && !is_within(best);
		const uint32_t cost = is_only ? 0 : cost_of(state, models, candidate.code);
		if (!is_within(best) || cost < min_cost) {
			best = candidate;
			min_cost = cost;
		}
	}
}

std::optional<SegmentCode> SegmentFit::fit(const BodyState &state, int ticks, size_t count, bool thorough, MotionModels &models) {
	if (count == 0) {
		// Without samples, the predicted motion continues.
		return SegmentCode{ ticks };
	}
	if (count > _loaded || !set_length(state, ticks, count) || !(_tolerance > 0.0f)) {
		return std::nullopt;
	}
	if (_mode == cga::Mode::SEPARATE) {
		return search(state, ticks, thorough, models);
	}
	// In these modes the path depends on its end, which the search is to find. Search with an estimate, then verify the result.
	SegmentSteps straight;
	for (size_t i = 0; i < 6; ++i) {
		straight.end[i] = int64_t(_target[i][size_t(_count - 1)] / _u[size_t(_count - 1)]);
	}
	std::memcpy(_saved_target, _target, sizeof(_target));
	subtract_base_path(state, ticks, straight);
	std::optional<SegmentCode> code = search(state, ticks, thorough, models);
	std::memcpy(_target, _saved_target, sizeof(_target));
	return code && passes_samples(state, *code) ? code : std::nullopt;
}

bool SegmentFit::passes_samples(const BodyState &state, const SegmentCode &code) const {
	const MotionSegment segment = state.segment(code, state.steps(code), _grid, _begin, _mode);
	const double max_error = VERIFIED * StreamGrid::TOLERANCE * _grid.position_step * (1 << _coarseness);
	return std::all_of(_samples, _samples + _count, [&](const MotionSample &sample) { return pose_distance(segment.pose_at(sample.time), sample.pose, _grid.lever_arm) <= max_error; });
}

std::optional<SegmentCode> SegmentFit::reach(const BodyState &state, int ticks, size_t index) {
	if (index >= _loaded || !set_length(state, ticks, index + 1)) {
		return std::nullopt;
	}
	SegmentCode code = blank_code(ticks);
	code.fine = true;
	double end[6];
	for (size_t i = 0; i < 6; ++i) {
		// With look-ahead, the end is interpolated.
		end[i] = _end_weight == 1.0 ? _end_target[i] : double(_target[i][index]);
	}
	round_end(end, code);
	if (!std::all_of(code.residual, code.residual + 6, [](int32_t value) { return std::abs(value) <= MAX_CODE; })) {
		return std::nullopt;
	}
	return code;
}

} // namespace net
