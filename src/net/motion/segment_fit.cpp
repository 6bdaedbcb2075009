#include "net/motion/segment_fit.hpp"

#include "net/coding/rotation_vector.hpp"

#include <algorithm>
#include <cmath>

// Where the processor has wider registers, the search uses them. (It might even round differently from machine to machine,
// as only its result is sent.)
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define NET_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define NET_WIDE
#endif

namespace net {

namespace {

/// A segment that ends more ticks than this after its last sample is drawn to where the body will be then: by the next
/// sample, or, more weakly, to where it was last.
constexpr double PINNED_BEYOND = 0.25;
constexpr double LAST_SEEN_WEIGHT = 0.2;
constexpr double LONGEST_TURN = 6.0; // radians in a segment
/// Codes whose error is at most so many times the tolerance are worth single steps towards it.
constexpr float NEARLY = 1.15f;
constexpr float NO_LIMIT = 1e18f;
constexpr std::int32_t MOST_END = ResidualModel::LIMIT / 2;

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

void SegmentFit::begin(const BodyState &state, double begin, const MotionSample *samples, std::size_t count, std::size_t available) {
	samples_ = samples;
	loaded_ = std::min(count, MOST_SAMPLES);
	known_ = available;
	begin_ = begin;
	start_ = state.pose(grid_);
	const cga::Quaternion<double> back = glm::conjugate(start_.rotation);
	cga::Vector3<double> before(0.0);
	if (loaded_ > 0) {
		const int ticks = std::max(1, int(std::ceil(samples[0].time - begin)));
		for (int i = 0; i < 3; ++i) {
			before[i] = double(state.predicted(3 + i, ticks)) * grid_.rotation;
		}
	}
	for (std::size_t k = 0; k < loaded_; ++k) {
		const cga::Pose<double> &pose = samples[k].pose;
		const cga::Vector3<double> way = (pose.translation - start_.translation) / grid_.position;
		const cga::Vector3<double> turn = unwrapped(log_rotation(back * pose.rotation), before);
		before = turn;
		double jacobian[9];
		double to_body[9];
		right_jacobian(turn, jacobian);
		inverse_matrix(pose.rotation, to_body);
		for (std::size_t i = 0; i < 3; ++i) {
			target_[i][k] = float(way[int(i)]);
			target_[3 + i][k] = float(turn[int(i)] / grid_.rotation);
		}
		for (std::size_t i = 0; i < 9; ++i) {
			to_body_[i][k] = float(to_body[i]);
			jacobian_[i][k] = float(jacobian[i]);
		}
	}
	// Blocks of 8 are computed whole: what is behind the last sample must be a number.
	for (std::size_t k = loaded_; k < (loaded_ + 7) / 8 * 8; ++k) {
		for (Row &row : target_) {
			row[k] = 0.0f;
		}
		for (std::size_t i = 0; i < 9; ++i) {
			to_body_[i][k] = 0.0f;
			jacobian_[i][k] = 0.0f;
		}
	}
}

void SegmentFit::pin_end(int ticks) {
	const double end = begin_ + ticks;
	const std::size_t k = std::size_t(count_ - 1);
	const MotionSample &last = samples_[k];
	for (std::size_t i = 0; i < 6; ++i) {
		pin_[i] = double(target_[i][k]);
	}
	pin_weight_ = end - last.time > PINNED_BEYOND ? LAST_SEEN_WEIGHT : 0.0;
	if (pin_weight_ > 0.0 && k + 1 < known_) {
		const MotionSample &next = samples_[k + 1];
		const double share = (end - last.time) / (next.time - last.time);
		const cga::Vector3<double> way = (next.pose.translation - start_.translation) / grid_.position;
		const cga::Vector3<double> before = cga::Vector3<double>(pin_[3], pin_[4], pin_[5]) * grid_.rotation;
		const cga::Vector3<double> turn = unwrapped(log_rotation(glm::conjugate(start_.rotation) * next.pose.rotation), before) / grid_.rotation;
		for (int i = 0; i < 3; ++i) {
			pin_[i] += share * (way[i] - pin_[i]);
			pin_[3 + i] += share * (turn[i] - pin_[3 + i]);
		}
		pin_weight_ = 1.0;
	}
}

bool SegmentFit::set_length(const BodyState &state, int ticks, std::size_t count) {
	count_ = int(std::min(count, loaded_));
	padded_ = (count_ + 7) / 8 * 8;
	const double ratio = samples_[count_ - 1].pose.scale / start_.scale;
	const double level = ratio == 1.0 ? 0.0 : std::log2(ratio) * BodyState::SCALE_LEVELS;
	scale_change_ = std::fabs(level) < 1.0 ? 0 : std::int32_t(std::round(std::clamp(level, -1e6, 1e6)));
	double scale_error = 0.0;
	for (std::size_t k = 0; k < std::size_t(count_); ++k) {
		const double u = (samples_[k].time - begin_) / ticks;
		u_[k] = float(u);
		w_[k] = float(u * (1.0 - u));
		const double scale = start_.scale * (scale_change_ == 0 ? 1.0 : std::exp2(u * scale_change_ / BodyState::SCALE_LEVELS));
		scale_error = std::max(scale_error, std::fabs(scale - samples_[k].pose.scale));
	}
	std::fill(u_.begin() + count_, u_.begin() + padded_, 0.0f);
	std::fill(w_.begin() + count_, w_.begin() + padded_, 0.0f);
	for (int i = 0; i < 6; ++i) {
		predicted_[i] = state.predicted(i, ticks);
	}
	pin_end(ticks);
	tolerance_ = float(StreamGrid::TOLERANCE - scale_error * grid_.lever / grid_.position);
	const std::size_t last = std::size_t(count_ - 1);
	const double turn = double(std::max({ std::fabs(target_[3][last]), std::fabs(target_[4][last]), std::fabs(target_[5][last]) })) * grid_.rotation;
	return turn < LONGEST_TURN;
}

void SegmentFit::subtract_base_path(const BodyState &state, int ticks, const SegmentSteps &steps) {
	// What the mode's path does besides u times its end; an estimate, as it is taken at an estimated end.
	SegmentCode code;
	code.ticks = ticks;
	const MotionSegment path = state.segment(code, steps, grid_, 0.0, mode_);
	for (std::size_t k = 0; k < std::size_t(count_); ++k) {
		const cga::Pose<double> pose = path.pose_at(double(u_[k]) * ticks);
		const cga::Vector3<double> way = (pose.translation - path.from.translation - path.way * double(u_[k])) / grid_.position;
		const cga::Vector3<double> turn = log_rotation(glm::conjugate(path.from.rotation * exp_rotation(path.turn * double(u_[k]))) * pose.rotation) / grid_.rotation;
		for (std::size_t i = 0; i < 3; ++i) {
			target_[i][k] -= float(way[int(i)]);
			target_[3 + i][k] -= float(turn[int(i)]);
		}
	}
}

NET_WIDE float SegmentFit::error_of(const SegmentSteps &steps, float limit) const {
	float way[6];
	float bend[6];
	for (int i = 0; i < 6; ++i) {
		way[i] = float(steps.way[i]);
		bend[i] = float(steps.bend[i]);
	}
	float worst[8] = { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f };
	for (std::size_t block = 0; block < std::size_t(padded_); block += 8) {
		for (std::size_t lane = 0; lane < 8; ++lane) {
			const std::size_t k = block + lane;
			const float u = u_[k];
			const float w = w_[k];
			const float x = target_[0][k] - way[0] * u - bend[0] * w;
			const float y = target_[1][k] - way[1] * u - bend[1] * w;
			const float z = target_[2][k] - way[2] * u - bend[2] * w;
			const float a = target_[3][k] - way[3] * u - bend[3] * w;
			const float b = target_[4][k] - way[4] * u - bend[4] * w;
			const float c = target_[5][k] - way[5] * u - bend[5] * w;
			const float bx = to_body_[0][k] * x + to_body_[1][k] * y + to_body_[2][k] * z;
			const float by = to_body_[3][k] * x + to_body_[4][k] * y + to_body_[5][k] * z;
			const float bz = to_body_[6][k] * x + to_body_[7][k] * y + to_body_[8][k] * z;
			const float ra = jacobian_[0][k] * a + jacobian_[1][k] * b + jacobian_[2][k] * c;
			const float rb = jacobian_[3][k] * a + jacobian_[4][k] * b + jacobian_[5][k] * c;
			const float rc = jacobian_[6][k] * a + jacobian_[7][k] * b + jacobian_[8][k] * c;
			// The centre, and the centre plus r x e_i: a lever turns a step of rotation into one of position.
			const float xx = bx * bx;
			const float yy = by * by;
			const float zz = bz * bz;
			const float e0 = xx + yy + zz;
			const float e1 = xx + (by + rc) * (by + rc) + (bz - rb) * (bz - rb);
			const float e2 = (bx - rc) * (bx - rc) + yy + (bz + ra) * (bz + ra);
			const float e3 = (bx + rb) * (bx + rb) + (by - ra) * (by - ra) + zz;
			const float m1 = e0 > e1 ? e0 : e1;
			const float m2 = e2 > e3 ? e2 : e3;
			const float m = m1 > m2 ? m1 : m2;
			const float counted = u > 0.0f ? m : 0.0f; // beyond the segment u is 0
			worst[lane] = worst[lane] > counted ? worst[lane] : counted;
		}
		const float most = *std::max_element(worst, worst + 8);
		if (most > limit * limit || block + 8 >= std::size_t(padded_)) {
			return std::sqrt(most);
		}
	}
	return 0.0f;
}

void SegmentFit::round_end(const double way[6], SegmentCode &code) const {
	const double step = code.fine ? StreamGrid::HALF : StreamGrid::COARSE;
	for (int i = 0; i < 6; ++i) {
		const double value = (way[i] - double(predicted_[i])) / step;
		code.end[i] = std::int32_t(std::clamp(std::nearbyint(value), double(-MOST_END - 1), double(MOST_END + 1)));
	}
}

bool SegmentFit::try_code(const SegmentCode &code, float limit, Result &result) const {
	result.code = code;
	for (int group = 0; group < 2; ++group) {
		const std::int32_t *bend = code.bend + 3 * group;
		result.code.bent[group] = (bend[0] | bend[1] | bend[2]) != 0;
	}
	result.error = error_of(SegmentSteps(predicted_, result.code), limit);
	return result.error <= tolerance_;
}

std::uint32_t SegmentFit::cost_of(const BodyState &state, MotionModels &models, const SegmentCode &code) {
	CostMeter meter;
	SegmentCode counted = code;
	state.code(meter, models, counted);
	return meter.cost();
}

bool SegmentFit::improve_error(Result &result) const {
	for (int i = 0; i < 12; ++i) {
		if (i >= 6 && !result.code.bent[(i - 6) / 3]) {
			continue;
		}
		for (const std::int32_t step : { -1, 1 }) {
			SegmentCode code = result.code;
			(i < 6 ? code.end[i] : code.bend[i - 6]) += step;
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
		const std::int32_t value = i < 6 ? result.code.end[i] : result.code.bend[i - 6];
		if (value == 0) {
			continue;
		}
		SegmentCode code = result.code;
		(i < 6 ? code.end[i] : code.bend[i - 6]) += value > 0 ? -1 : 1;
		Result other;
		if (try_code(code, tolerance_, other)) {
			result = other;
		}
	}
}

bool SegmentFit::search(const BodyState &state, int ticks, bool thoroughly, MotionModels &models, Result &result) {
	SegmentCode straight;
	straight.ticks = ticks;
	straight.scaled = scale_change_ != 0;
	straight.scale = scale_change_;
	double uu = 0.0;
	double uw = 0.0;
	double ww = 0.0;
	double uy[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
	double wy[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
	for (std::size_t k = 0; k < std::size_t(count_); ++k) {
		const double u = u_[k];
		const double w = w_[k];
		uu += u * u;
		uw += u * w;
		ww += w * w;
		for (int i = 0; i < 6; ++i) {
			uy[i] += u * double(target_[i][k]);
			wy[i] += w * double(target_[i][k]);
		}
	}
	uu += pin_weight_;
	for (int i = 0; i < 6; ++i) {
		uy[i] += pin_weight_ * pin_[i];
	}
	double straight_way[6];
	for (int i = 0; i < 6; ++i) {
		straight_way[i] = uy[i] / uu;
	}
	round_end(straight_way, straight);
	bool found = try_code(straight, NO_LIMIT, result);
	if (!found && thoroughly && result.error < NEARLY * tolerance_) {
		found = improve_error(result);
	}
	// With bends: of the translation, the rotation, both.
	const double determinant = uu * ww - uw * uw;
	if (!found && count_ >= 3 && determinant > 1e-3 * uu * ww) {
		SegmentCode bent = straight;
		double way[6];
		for (int i = 0; i < 6; ++i) {
			way[i] = (uy[i] * ww - wy[i] * uw) / determinant;
		}
		round_end(way, bent);
		const SegmentSteps steps(predicted_, bent);
		for (int i = 0; i < 6; ++i) {
			const double bend = (wy[i] - double(steps.way[i]) * uw) / ww;
			bent.bend[i] = std::int32_t(std::clamp(std::nearbyint(bend / StreamGrid::BEND), double(-MOST_END), double(MOST_END)));
		}
		std::uint32_t least_cost = 0;
		for (int groups = thoroughly ? 1 : 3; groups <= 3; ++groups) {
			SegmentCode code = straight;
			for (int i = 0; i < 6; ++i) {
				if (((groups >> (i / 3)) & 1) != 0) {
					code.end[i] = bent.end[i];
					code.bend[i] = bent.bend[i];
				}
			}
			Result other;
			bool within = try_code(code, NO_LIMIT, other);
			if (!within && thoroughly && groups == 3 && !found && other.error < NEARLY * tolerance_) {
				within = improve_error(other);
			}
			if (within) {
				const std::uint32_t cost = cost_of(state, models, other.code);
				if (!found || cost < least_cost) {
					result = other;
					least_cost = cost;
					found = true;
				}
			}
		}
	}
	if (!found && count_ <= 2) {
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

bool SegmentFit::fit(const BodyState &state, int ticks, std::size_t count, bool thoroughly, MotionModels &models, Result &result) {
	if (count == 0) {
		// Nothing was seen: the motion goes on as predicted.
		result = Result();
		result.code.ticks = ticks;
		return true;
	}
	if (count > loaded_ || !set_length(state, ticks, count) || !(tolerance_ > 0.0f)) {
		return false;
	}
	if (mode_ == cga::Mode::SEPARATE) {
		return search(state, ticks, thoroughly, models, result);
	}
	// The path depends on its end: take what the mode adds at the end of the separate path, then look at the result.
	SegmentSteps straight;
	for (std::size_t i = 0; i < 6; ++i) {
		straight.way[i] = std::int64_t(target_[i][std::size_t(count_ - 1)] / u_[std::size_t(count_ - 1)]);
	}
	std::copy(target_, target_ + 6, base_target_);
	subtract_base_path(state, ticks, straight);
	const bool found = search(state, ticks, thoroughly, models, result);
	std::copy(base_target_, base_target_ + 6, target_);
	if (!found) {
		return false;
	}
	const MotionSegment segment = state.segment(result.code, state.steps(result.code), grid_, begin_, mode_);
	const double most = StreamGrid::TOLERANCE * grid_.position * 1.02;
	return std::all_of(samples_, samples_ + count_, [&](const MotionSample &sample) { return pose_distance(segment.pose_at(sample.time), sample.pose, grid_.lever) <= most; });
}

bool SegmentFit::reach(const BodyState &state, int ticks, std::size_t index, Result &result) {
	if (index >= loaded_ || !set_length(state, ticks, index + 1)) {
		return false;
	}
	result = Result();
	SegmentCode &code = result.code;
	code.ticks = ticks;
	code.fine = true;
	code.scaled = scale_change_ != 0;
	code.scale = scale_change_;
	double way[6];
	for (std::size_t i = 0; i < 6; ++i) {
		// Where the next sample is known, the end lies on the way to it.
		way[i] = pin_weight_ == 1.0 ? pin_[i] : double(target_[i][index]);
	}
	round_end(way, code);
	return std::all_of(code.end, code.end + 6, [](std::int32_t value) { return std::abs(value) <= MOST_END; });
}

} // namespace net
