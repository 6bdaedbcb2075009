#include "cga/motor/deviation.hpp"

#include "cga/motor/axis_angle.hpp"
#include "cga/motor/pose_motion.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace cga {

namespace {

constexpr int BISECTIONS = 30;
// The deviation has few maxima: with this many samples, the golden-section search starts near the largest.
constexpr int SAMPLES = 64;
constexpr int SECTIONS = 32;
constexpr double GOLDEN = 0.61803398874989485;
// Paths are often symmetric: a later maximum replaces an equal one only if it is larger beyond rounding.
constexpr double MIN_RATIO = 1.0 + 1e-9;

// The largest length of (along + flat c, across + round s) with c^2 + s^2 = 1; all nonnegative, flat <= round.
// With c > 0 the derivative is, up to the factor 2 c, concave in the angle and nonnegative at s = 0, so that it has
// one zero.
double farthest(double along, double across, double flat, double round) {
	double low_c = 1.0, low_s = 0.0; // where the length still grows
	double high_c = 0.0, high_s = 1.0;
	const bool always_grows = !(along * flat > 0.0);
	for (int i = 0; i < BISECTIONS && !always_grows; ++i) {
		const double size = std::hypot(low_c + high_c, low_s + high_s);
		const double c = (low_c + high_c) / size;
		const double s = (low_s + high_s) / size;
		const bool grows = c * (across + round * s) * round > s * (along + flat * c) * flat;
		(grows ? low_c : high_c) = c;
		(grows ? low_s : high_s) = s;
	}
	return std::hypot(along + flat * high_c, across + round * high_s);
}

// Finds the maximum of a function over 0..1 and its argument. `largest` and `largest_at` hold those found so far.
template <class Function>
void find_maximum(Function function, double &largest, double &largest_at) {
	for (int sample = 1; sample < SAMPLES; ++sample) {
		const double weight = double(sample) / SAMPLES;
		const double value = function(weight);
		if (value > largest * MIN_RATIO) {
			largest = value;
			largest_at = weight;
		}
	}
	double low = largest_at - 1.0 / SAMPLES;
	double high = largest_at + 1.0 / SAMPLES;
	if (!(largest > 0.0)) {
		return;
	}
	double left = high - GOLDEN * (high - low);
	double right = low + GOLDEN * (high - low);
	double at_left = function(left);
	double at_right = function(right);
	for (int section = 0; section < SECTIONS; ++section) {
		if (at_left >= at_right) {
			high = right;
			right = left;
			at_right = at_left;
			left = high - GOLDEN * (high - low);
			at_left = function(left);
		} else {
			low = left;
			left = right;
			at_left = at_right;
			right = low + GOLDEN * (high - low);
			at_right = function(right);
		}
	}
	const double best = std::max(at_left, at_right);
	if (best > largest) {
		largest = best;
		largest_at = at_left >= at_right ? left : right;
	}
}

} // namespace

// A point u of the body goes to t1 + s1 R1 u and t2 + s2 R2 u. With R1^-1 R2 a rotation by theta about n, s1 R1 - s2 R2 takes
// n to (s1 - s2) R1 n, and every unit vector across n to one of length |s1 - s2 exp(i theta)| across R1 n, in a direction
// that rotates with it: the sphere of lever arms becomes an ellipsoid of revolution about R1 n.
Deviation deviation(const Pose<double> &first, const Pose<double> &second, double lever_arm) noexcept {
	const Quaternion<double> first_rotation = unit_rotation(first.rotation);
	const AxisAngle<double> turn = short_axis_angle(glm::conjugate(first_rotation) * unit_rotation(second.rotation));
	const Vector3<double> offset = first.translation - second.translation;
	const Vector3<double> axis = turn.angle > 0.0 ? first_rotation * turn.axis : Vector3<double>(1.0, 0.0, 0.0);
	const double reach = std::max(lever_arm, 0.0);
	const double growth = std::abs(first.scale - second.scale);
	const double half_chord = std::sin(0.5 * turn.angle);
	const double round = std::sqrt(growth * growth + 4.0 * first.scale * second.scale * half_chord * half_chord);
	const double along = glm::dot(offset, axis);

	Deviation found;
	found.distance = farthest(std::abs(along), detail::length(offset - axis * along), growth * reach, round * reach);
	found.angle = turn.angle;
	return found;
}

PathDeviation path_deviation(const Pose<double> &from, const Pose<double> &to, Mode first, Mode second, double lever_arm) noexcept {
	const auto at = [&](double weight) {
		return deviation(interpolate(from, to, weight, first), interpolate(from, to, weight, second), lever_arm);
	};
	PathDeviation found;
	find_maximum([&at](double weight) { return at(weight).distance; }, found.distance, found.distance_weight);
	find_maximum([&at](double weight) { return at(weight).angle; }, found.angle, found.angle_weight);
	return found;
}

} // namespace cga
