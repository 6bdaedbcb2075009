#pragma once

#include "net/stream/stream_settings.hpp"

#include <cmath>

namespace net {

/// The steps in which a stream counts positions and rotations; sender and receivers derive them from the same floats.
///
/// A step of rotation moves a point at the distance `lever` as far as a step of position moves the body, so that one
/// bound holds for both: with d the error of the centre and r that of the rotation, |d| and |d + lever (r x e_i)| stay
/// within the position tolerance for the three axes e_i. As |r x e_i| >= sqrt(2/3) |r| for one of them,
/// lever = sqrt(3/2) position_tolerance / rotation_tolerance makes the rotation count as it is asked for.
struct StreamGrid {
	/// Steps between the values that the end of a segment usually takes; half of that where it must be finer.
	static constexpr int COARSE = 8;
	static constexpr int HALF = 4;
	/// Steps between values of a bend. It shows at a quarter of its size in the middle of a segment, less elsewhere.
	static constexpr int CURVATURE = 28;
	/// The tolerance in steps: with sqrt(3)/2 + sqrt(2)/2 of a half step as the largest rounding, it is never too coarse.
	static constexpr double TOLERANCE = COARSE / 0.9;

	double position = 0.0; ///< metres
	double rotation = 0.0; ///< radians
	double lever_arm = 0.0; ///< metres

	/// What the search may use of the tolerances; the rest is for the network, clocks and floats.
	static constexpr double USED = 0.95;

	StreamGrid() = default;
	StreamGrid(float position_tolerance, float rotation_tolerance) {
		const double radians = double(rotation_tolerance) * (3.14159265358979323846 / 180.0);
		lever_arm = std::sqrt(1.5) * double(position_tolerance) / radians;
		position = USED * double(position_tolerance) / TOLERANCE;
		rotation = position / lever_arm;
	}
};

} // namespace net
