#pragma once

#include <cmath>

namespace net {

/// The quantization steps of a stream. Sender and receivers derive them from the same float32 tolerances.
///
/// A step of rotation moves a point at the lever arm as far as a step of position moves the body, so that one bound covers
/// both: if d is the error of the center and r that of the rotation vector, then |d|, |d + lever_arm (r x e_i)| for the three axes
/// e_i, and sqrt(2/3) lever_arm |r| stay within the position tolerance. With lever_arm = sqrt(3/2) position_tolerance /
/// rotation_tolerance, the last means that |r| stays within the rotation tolerance. It rarely matters: for d = 0 it follows from
/// the others, as |r x e_i| >= sqrt(2/3) |r| for at least one axis.
struct StreamGrid {
	/// Quantization of the end of a segment, in steps: COARSE by default, FINE in segments marked fine.
	static constexpr int COARSE = 8;
	static constexpr int FINE = 4;
	/// Quantization of a curvature, in steps. A curvature displaces the middle of its segment by a quarter of its value, other
	/// points by less.
	static constexpr int CURVATURE = 28;
	/// The tolerance in steps. The maximum rounding error of a fine end, (sqrt(3) + sqrt(2)) / 2 fine steps, is below it.
	static constexpr double TOLERANCE = COARSE / 0.9;
	/// Fraction of the tolerances that the encoder may use. The rest is reserved for clock error and float rounding.
	static constexpr double USABLE_SHARE = 0.95;

	double position_step = 0.0; ///< meters
	double rotation_step = 0.0; ///< radians
	double lever_arm = 0.0; ///< meters

	StreamGrid() = default;
	/// Tolerances in meters and degrees.
	StreamGrid(float position_tolerance, float rotation_tolerance) {
		const double radians = double(rotation_tolerance) * (3.14159265358979323846 / 180.0);
		lever_arm = std::sqrt(1.5) * double(position_tolerance) / radians;
		position_step = USABLE_SHARE * double(position_tolerance) / TOLERANCE;
		rotation_step = position_step / lever_arm;
	}
};

} // namespace net
