#pragma once

#include "../../harness/link_model.hpp"
#include "method_result.hpp"

#include "cga/motor/interpolate.hpp"

namespace bench {

/// A way to send poses that engines and papers use: every body, at a fixed rate, each pose by itself; the receiver
/// interpolates between the last pose before and the first after the time it shows.
struct Baseline {
	std::string subject;
	double rate = 0.0; ///< poses a second of each body
	size_t pose_bytes = 0;
	cga::Mode path = cga::Mode::SEPARATE;
	cga::Pose<double> (*as_received)(const cga::Pose<double> &pose) = nullptr; ///< a pose after rounding to what is sent
};

/// Float32 position, quaternion and scale (40 bytes) with lerp and slerp at 5, 10, 15, 20, 30 and 60 Hz:
/// pqs_float32_5hz and so on. The GA-Unity paper's scheme at half of 10, 20, 30 and 60 Hz: eight float32 of a motor
/// and a float32 scale (36 bytes) with a linear blend: paper_motor_float32_5hz and so on.
[[nodiscard]] std::vector<Baseline> baselines();

/// Sends the trace by the method through a link.
///
/// A body's pose is sent at the first source time at or after each multiple of 1 / rate (or a quarter of a source
/// interval before it), with that time, in datagrams of at most 1,350 bytes; the body's last pose is sent too. The cost
/// is that of a fixed rate: a pose at every multiple for as long as the body is there, at rest and in gaps of the
/// recording as well. Headers, ids and times cost nothing.
///
/// The receiver plays the shortest delay behind at which, without loss, the sample after the time shown is always there:
/// one send interval, the delay and the jitter. A sample that is lost, or comes later than the playback delay after its
/// time, is missing; the receiver then interpolates between the samples around it, as if it had known that.
[[nodiscard]] MethodResult run_baseline(const Trace &trace, const Baseline &baseline, const harness::LinkSettings &link, uint64_t seed);

} // namespace bench
