#pragma once

#include "../../harness/link_model.hpp"
#include "method_result.hpp"

#include "cga/motor/interpolate.hpp"

namespace bench {

/// A replication method of engines and papers: every body's pose at a fixed rate, each coded independently. The receiver
/// interpolates between the poses before and after its playback time.
struct Baseline {
	std::string subject;
	double rate = 0.0; ///< poses per second and body
	size_t pose_bytes = 0;
	cga::Mode path = cga::Mode::SEPARATE;
	cga::Pose<double> (*as_received)(const cga::Pose<double> &pose) = nullptr; ///< the pose after the rounding of the format sent
};

/// pqs_float32_5hz and so on: float32 position, quaternion and scale (40 bytes) with lerp and slerp at 5, 10, 15, 20, 30
/// and 60 Hz. paper_motor_float32_5hz and so on: the GA-Unity paper's scheme, the eight float32 of a motor and a float32
/// scale (36 bytes) with a linear blend, at half of 10, 20, 30 and 60 Hz.
[[nodiscard]] std::vector<Baseline> baselines();

/// Replicates the trace over a link with the baseline.
///
/// The sender sends a body's pose at the first sample at or after each multiple of 1 / rate (or up to a quarter of a
/// sample interval before it), in datagrams of at most 1,350 bytes, and the body's last pose. The cost is that of a fixed
/// rate: one pose at every multiple from the body's first to its last sample, at rest and in gaps of the recording too.
/// Headers, ids and times are not counted.
///
/// The playback delay is the shortest at which, without loss, the next sample is always there: one send interval plus the
/// link's delay and jitter. The receiver interpolates across samples that are lost or arrive after their playback time, as
/// if it had known in advance that they would be missing.
[[nodiscard]] MethodResult run_baseline(const Trace &trace, const Baseline &baseline, const harness::LinkSettings &link, uint64_t seed);

} // namespace bench
