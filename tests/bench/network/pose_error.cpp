#include "pose_error.hpp"

#include <algorithm>
#include <cmath>

namespace bench {

double lever_distance(const cga::Pose<double> &a, const cga::Pose<double> &b) {
	const glm::dvec3 center = a.translation - b.translation;
	const glm::dmat3 axes = glm::mat3_cast(a.rotation) * (LEVER_ARM * a.scale) - glm::mat3_cast(b.rotation) * (LEVER_ARM * b.scale);
	double squared = glm::dot(center, center);
	for (int axis = 0; axis < 3; ++axis) {
		const glm::dvec3 point = center + axes[axis];
		const double point_squared = glm::dot(point, point);
		squared = point_squared <= squared ? squared : point_squared; // keeps a NaN
	}
	return std::sqrt(squared);
}

std::vector<Motion> find_motion(const TraceBody &body) {
	std::vector<Motion> motion(body.samples.size(), Motion::UNKNOWN);
	for (size_t i = 1; i < motion.size(); ++i) {
		const TraceSample &before = body.samples[i - 1];
		const TraceSample &sample = body.samples[i];
		const bool moves = lever_distance(before.pose, sample.pose) > MOVING_SPEED * (sample.time - before.time);
		motion[i] = moves ? Motion::MOVING : Motion::RESTING;
	}
	return motion;
}

void ErrorSummary::add(double error, Motion motion) {
	if (motion != Motion::UNKNOWN) {
		(motion == Motion::MOVING ? _moving : _resting).push_back(std::isnan(error) ? std::numeric_limits<double>::infinity() : error);
	}
}

double percentile(std::vector<double> &values, double share) {
	if (values.empty()) {
		return std::numeric_limits<double>::quiet_NaN();
	}
	std::sort(values.begin(), values.end());
	const double place = share * double(values.size() - 1);
	const size_t below = size_t(place);
	const size_t above = std::min(below + 1, values.size() - 1);
	const double weight = place - double(below);
	// Does not subtract infinities, which would give NaN.
	return weight == 0.0 || values[above] == values[below] ? values[below] : values[below] + (values[above] - values[below]) * weight;
}

void ErrorSummary::add(const ErrorSummary &other) {
	_moving.insert(_moving.end(), other._moving.begin(), other._moving.end());
	_resting.insert(_resting.end(), other._resting.begin(), other._resting.end());
}

ErrorFigures ErrorSummary::figures() const {
	std::vector<double> moving = _moving;
	std::vector<double> resting = _resting;
	ErrorFigures figures;
	figures.moving_count = moving.size();
	figures.resting_count = resting.size();
	figures.p50 = percentile(moving, 0.5);
	figures.p99 = percentile(moving, 0.99);
	figures.max = percentile(moving, 1.0);
	figures.rest_p99 = percentile(resting, 0.99);
	figures.rest_max = percentile(resting, 1.0);
	return figures;
}

} // namespace bench
