#include "net/motion/segment_fit.hpp"

#include "net/coding/rotation_vector.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace net {

namespace {

/// A segment that ends more ticks than this after its last sample is drawn to where the body will be then: by the next
/// sample, or, more weakly, to where it was last.
constexpr double PINNED_BEYOND = 0.25;
constexpr double LAST_SEEN_WEIGHT = 0.2;
constexpr double MAX_TURN = 6.0; // radians in a segment
/// Codes whose error is at most so many times the tolerance are worth single steps towards it.
constexpr float NEARLY = 1.15f;
constexpr float NO_LIMIT = 1e18f;
constexpr int32_t MAX_END = ResidualModel::LIMIT / 2;

/// Rows of the rotation matrix of the inverse of q.
void inverse_matrix(const cga::Quaternion<double> &q, double m[9]) {
	const glm::dmat3 columns = glm::mat3_cast(q);
	for (int row = 0; row < 3; ++row) {
		for (int column = 0; column < 3; ++column) {
			m[3 * row + column] = columns[row][column];
		}
	}
}

} // namespace

void SegmentFit::begin(const BodyState &state, double begin, const MotionSample *samples, size_t count, size_t available) {
	_samples = samples;
	_loaded = std::min(count, MAX_SAMPLES);
	_known = available;
	_begin = begin;
	_start = state.pose(_grid);
	const cga::Quaternion<double> back = glm::conjugate(_start.rotation);
	cga::Vector3<double> before(0.0);
	if (_loaded > 0) {
		const int ticks = std::max(1, int(std::ceil(samples[0].time - begin)));
		for (int i = 0; i < 3; ++i) {
			before[i] = double(state.predicted(3 + i, ticks)) * _grid.rotation;
		}
	}
	for (size_t k = 0; k < _loaded; ++k) {
		const cga::Pose<double> &pose = samples[k].pose;
		const cga::Vector3<double> displacement = (pose.translation - _start.translation) / _grid.position;
		const cga::Vector3<double> turn = unwrapped(log_rotation(back * pose.rotation), before);
		before = turn;
		double jacobian[9];
		double to_body[9];
		right_jacobian(turn, jacobian);
		inverse_matrix(pose.rotation, to_body);
		for (size_t i = 0; i < 3; ++i) {
			_target[i][k] = float(displacement[int(i)]);
			_target[3 + i][k] = float(turn[int(i)] / _grid.rotation);
		}
		for (size_t i = 0; i < 9; ++i) {
			_to_body[i][k] = float(to_body[i]);
			_jacobian[i][k] = float(jacobian[i]);
		}
	}
	// Blocks of 8 are computed whole: what is behind the last sample must be a number.
	for (size_t k = _loaded; k < (_loaded + 7) / 8 * 8; ++k) {
		for (Row &row : _target) {
			row[k] = 0.0f;
		}
		for (size_t i = 0; i < 9; ++i) {
			_to_body[i][k] = 0.0f;
			_jacobian[i][k] = 0.0f;
		}
	}
}

void SegmentFit::pin_end(int ticks) {
	const double end = _begin + ticks;
	const size_t k = size_t(_count - 1);
	const MotionSample &last = _samples[k];
	for (size_t i = 0; i < 6; ++i) {
		_pin[i] = double(_target[i][k]);
	}
	_pin_weight = end - last.time > PINNED_BEYOND ? LAST_SEEN_WEIGHT : 0.0;
	if (_pin_weight > 0.0 && k + 1 < _known) {
		const MotionSample &next = _samples[k + 1];
		const double share = (end - last.time) / (next.time - last.time);
		const cga::Vector3<double> displacement = (next.pose.translation - _start.translation) / _grid.position;
		const cga::Vector3<double> before = cga::Vector3<double>(_pin[3], _pin[4], _pin[5]) * _grid.rotation;
		const cga::Vector3<double> turn = unwrapped(log_rotation(glm::conjugate(_start.rotation) * next.pose.rotation), before) / _grid.rotation;
		for (int i = 0; i < 3; ++i) {
			_pin[i] += share * (displacement[i] - _pin[i]);
			_pin[3 + i] += share * (turn[i] - _pin[3 + i]);
		}
		_pin_weight = 1.0;
	}
}

bool SegmentFit::set_length(const BodyState &state, int ticks, size_t count) {
	_count = int(std::min(count, _loaded));
	_padded = (_count + 7) / 8 * 8;
	const double ratio = _samples[_count - 1].pose.scale / _start.scale;
	const double level = ratio == 1.0 ? 0.0 : std::log2(ratio) * BodyState::SCALE_LEVELS;
	_scale_change = std::fabs(level) < 1.0 ? 0 : int32_t(std::round(std::clamp(level, -1e6, 1e6)));
	double scale_error = 0.0;
	for (size_t k = 0; k < size_t(_count); ++k) {
		const double u = (_samples[k].time - _begin) / ticks;
		_u[k] = float(u);
		_w[k] = float(u * (1.0 - u));
		const double scale = _start.scale * (_scale_change == 0 ? 1.0 : std::exp2(u * _scale_change / BodyState::SCALE_LEVELS));
		scale_error = std::max(scale_error, std::fabs(scale - _samples[k].pose.scale));
	}
	std::fill(_u + _count, _u + _padded, 0.0f);
	std::fill(_w + _count, _w + _padded, 0.0f);
	for (int i = 0; i < 6; ++i) {
		_predicted[i] = state.predicted(i, ticks);
	}
	pin_end(ticks);
	_tolerance = float(StreamGrid::TOLERANCE - scale_error * _grid.lever_arm / _grid.position);
	const size_t last = size_t(_count - 1);
	const double turn = double(std::max({ std::fabs(_target[3][last]), std::fabs(_target[4][last]), std::fabs(_target[5][last]) })) * _grid.rotation;
	return turn < MAX_TURN;
}

void SegmentFit::subtract_base_path(const BodyState &state, int ticks, const SegmentSteps &steps) {
	// What the mode's path does besides u times its end; an estimate, as it is taken at an estimated end.
	SegmentCode code;
	code.ticks = ticks;
	const MotionSegment path = state.segment(code, steps, _grid, 0.0, _mode);
	for (size_t k = 0; k < size_t(_count); ++k) {
		const cga::Pose<double> pose = path.pose_at(double(_u[k]) * ticks);
		const cga::Vector3<double> displacement = (pose.translation - path.from.translation - path.displacement * double(_u[k])) / _grid.position;
		const cga::Vector3<double> turn = log_rotation(glm::conjugate(path.from.rotation * exp_rotation(path.turn * double(_u[k]))) * pose.rotation) / _grid.rotation;
		for (size_t i = 0; i < 3; ++i) {
			_target[i][k] -= float(displacement[int(i)]);
			_target[3 + i][k] -= float(turn[int(i)]);
		}
	}
}

float SegmentFit::error_of(const SegmentSteps &steps, float limit) const {
	SegmentErrorInput input = { _target, _to_body, _jacobian, _u, _w, size_t(_padded), {}, {} };
	for (int i = 0; i < 6; ++i) {
		input.displacement[i] = float(steps.displacement[i]);
		input.curvature[i] = float(steps.curvature[i]);
	}
	return segment_error(input, limit);
}

void SegmentFit::round_end(const double displacement[6], SegmentCode &code) const {
	const double step = code.fine ? StreamGrid::HALF : StreamGrid::COARSE;
	for (int i = 0; i < 6; ++i) {
		const double value = (displacement[i] - double(_predicted[i])) / step;
		code.end[i] = int32_t(std::clamp(std::nearbyint(value), double(-MAX_END - 1), double(MAX_END + 1)));
	}
}

bool SegmentFit::try_code(const SegmentCode &code, float limit, Result &result) const {
	result.code = code;
	for (int group = 0; group < 2; ++group) {
		const int32_t *curvature = code.curvature + ptrdiff_t(3) * group;
		result.code.curved[group] = (curvature[0] | curvature[1] | curvature[2]) != 0;
	}
	result.error = error_of(SegmentSteps(_predicted, result.code), limit);
	return result.error <= _tolerance;
}

uint32_t SegmentFit::cost_of(const BodyState &state, MotionModels &models, const SegmentCode &code) {
	CostMeter meter;
	SegmentCode counted = code;
	state.code(meter, models, counted);
	return meter.cost();
}

bool SegmentFit::improve_error(Result &result) const {
	for (int i = 0; i < 12; ++i) {
		if (i >= 6 && !result.code.curved[(i - 6) / 3]) {
			continue;
		}
		for (const int32_t step : { -1, 1 }) {
			SegmentCode code = result.code;
			(i < 6 ? code.end[i] : code.curvature[i - 6]) += step;
			Result other;
			if (try_code(code, result.error, other)) {
				result = other;
				return true;
			}
			if (other.error < result.error) {
				result = other;
				break;
			}
		}
	}
	return false;
}

void SegmentFit::improve_cost(Result &result) const {
	// A number nearer to zero is cheaper: what the models say would not change the choice often enough to ask them.
	for (int i = 0; i < 12; ++i) {
		const int32_t value = i < 6 ? result.code.end[i] : result.code.curvature[i - 6];
		if (value == 0) {
			continue;
		}
		SegmentCode code = result.code;
		(i < 6 ? code.end[i] : code.curvature[i - 6]) += value > 0 ? -1 : 1;
		Result other;
		if (try_code(code, _tolerance, other)) {
			result = other;
		}
	}
}

bool SegmentFit::search(const BodyState &state, int ticks, bool thoroughly, MotionModels &models, Result &result) {
	SegmentCode straight;
	straight.ticks = ticks;
	straight.scaled = _scale_change != 0;
	straight.scale = _scale_change;
	double uu = 0.0;
	double uw = 0.0;
	double ww = 0.0;
	double uy[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
	double wy[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
	for (size_t k = 0; k < size_t(_count); ++k) {
		const double u = _u[k];
		const double w = _w[k];
		uu += u * u;
		uw += u * w;
		ww += w * w;
		for (int i = 0; i < 6; ++i) {
			uy[i] += u * double(_target[i][k]);
			wy[i] += w * double(_target[i][k]);
		}
	}
	uu += _pin_weight;
	for (int i = 0; i < 6; ++i) {
		uy[i] += _pin_weight * _pin[i];
	}
	double straight_way[6];
	for (int i = 0; i < 6; ++i) {
		straight_way[i] = uy[i] / uu;
	}
	round_end(straight_way, straight);
	bool found = try_code(straight, NO_LIMIT, result);
	if (!found && thoroughly && result.error < NEARLY * _tolerance) {
		found = improve_error(result);
	}
	// With bends: of the translation, the rotation, both.
	const double determinant = uu * ww - uw * uw;
	if (!found && _count >= 3 && determinant > 1e-3 * uu * ww) {
		SegmentCode curved = straight;
		double displacement[6];
		for (int i = 0; i < 6; ++i) {
			displacement[i] = (uy[i] * ww - wy[i] * uw) / determinant;
		}
		round_end(displacement, curved);
		const SegmentSteps steps(_predicted, curved);
		for (int i = 0; i < 6; ++i) {
			const double curvature = (wy[i] - double(steps.displacement[i]) * uw) / ww;
			curved.curvature[i] = int32_t(std::clamp(std::nearbyint(curvature / StreamGrid::CURVATURE), double(-MAX_END), double(MAX_END)));
		}
		uint32_t least_cost = 0;
		for (int groups = thoroughly ? 1 : 3; groups <= 3; ++groups) {
			SegmentCode code = straight;
			for (int i = 0; i < 6; ++i) {
				if (((groups >> (i / 3)) & 1) != 0) {
					code.end[i] = curved.end[i];
					code.curvature[i] = curved.curvature[i];
				}
			}
			Result other;
			bool within = try_code(code, NO_LIMIT, other);
			if (!within && thoroughly && groups == 3 && !found && other.error < NEARLY * _tolerance) {
				within = improve_error(other);
			}
			if (within) {
				const uint32_t cost = cost_of(state, models, other.code);
				if (!found || cost < least_cost) {
					result = other;
					least_cost = cost;
					found = true;
				}
			}
		}
	}
	if (!found && _count <= 2) {
		SegmentCode fine = straight;
		fine.fine = true;
		round_end(straight_way, fine);
		found = try_code(fine, NO_LIMIT, result) || improve_error(result);
	}
	if (found && thoroughly) {
		improve_cost(result);
	}
	return found;
}

bool SegmentFit::fit(const BodyState &state, int ticks, size_t count, bool thoroughly, MotionModels &models, Result &result) {
	if (count == 0) {
		// Nothing was seen: the motion goes on as predicted.
		result = Result();
		result.code.ticks = ticks;
		return true;
	}
	if (count > _loaded || !set_length(state, ticks, count) || !(_tolerance > 0.0f)) {
		return false;
	}
	if (_mode == cga::Mode::SEPARATE) {
		return search(state, ticks, thoroughly, models, result);
	}
	// The path depends on its end: take what the mode adds at the end of the separate path, then look at the result.
	SegmentSteps straight;
	for (size_t i = 0; i < 6; ++i) {
		straight.displacement[i] = int64_t(_target[i][size_t(_count - 1)] / _u[size_t(_count - 1)]);
	}
	std::memcpy(_base_target, _target, sizeof(_target));
	subtract_base_path(state, ticks, straight);
	const bool found = search(state, ticks, thoroughly, models, result);
	std::memcpy(_target, _base_target, sizeof(_target));
	if (!found) {
		return false;
	}
	const MotionSegment segment = state.segment(result.code, state.steps(result.code), _grid, _begin, _mode);
	const double most = StreamGrid::TOLERANCE * _grid.position * 1.02;
	return std::all_of(_samples, _samples + _count, [&](const MotionSample &sample) { return pose_distance(segment.pose_at(sample.time), sample.pose, _grid.lever_arm) <= most; });
}

bool SegmentFit::reach(const BodyState &state, int ticks, size_t index, Result &result) {
	if (index >= _loaded || !set_length(state, ticks, index + 1)) {
		return false;
	}
	result = Result();
	SegmentCode &code = result.code;
	code.ticks = ticks;
	code.fine = true;
	code.scaled = _scale_change != 0;
	code.scale = _scale_change;
	double displacement[6];
	for (size_t i = 0; i < 6; ++i) {
		// Where the next sample is known, the end lies on the way to it.
		displacement[i] = _pin_weight == 1.0 ? _pin[i] : double(_target[i][index]);
	}
	round_end(displacement, code);
	return std::all_of(code.end, code.end + 6, [](int32_t value) { return std::abs(value) <= MAX_END; });
}

} // namespace net
