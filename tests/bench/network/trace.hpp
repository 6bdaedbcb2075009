#pragma once

#include "cga/motor/pose.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bench {

struct TraceSample {
	double time = 0.0; ///< seconds
	cga::Pose<double> pose;
};

struct TraceBody {
	uint32_t id = 0;
	std::vector<TraceSample> samples; ///< at strictly ascending times
};

/// One sample of one body: Trace::bodies[body].samples[sample].
struct SampleIndex {
	uint32_t body = 0;
	uint32_t sample = 0;
};

/// The samples of one time: Trace::order[begin] up to, not including, Trace::order[end].
struct TraceFrame {
	double time = 0.0; ///< seconds
	size_t begin = 0;
	size_t end = 0;
};

/// Recorded motion of bodies, which may begin late, end early, have gaps and be sampled at different times.
struct Trace {
	std::vector<TraceBody> bodies; ///< by ascending id; each has at least one sample
	std::vector<SampleIndex> order; ///< all samples by ascending time
	std::vector<TraceFrame> frames; ///< by ascending time; at least two

	[[nodiscard]] const TraceSample &sample(const SampleIndex &index) const { return bodies[index.body].samples[index.sample]; }
	[[nodiscard]] double begin() const { return frames.front().time; }
	[[nodiscard]] double end() const { return frames.back().time; }
	/// Seconds from the first sample to the last; greater than 0.
	[[nodiscard]] double duration() const { return end() - begin(); }
	/// The typical interval between a body's samples, in seconds: the mean of the intervals within 10 % of their median; of
	/// intervals between frames if no body has two samples.
	[[nodiscard]] double sample_interval() const;
};

/// Parses lines of `t,id,x,y,z,qw,qx,qy,qz`: seconds, integer, meters, unit quaternion. A header line and empty lines are
/// skipped. Times must not decrease; the last of several samples of a body at one time counts. Returns an error that begins
/// with `name` and the line number, after which `trace` must not be used; empty on success.
[[nodiscard]] std::string parse_trace(std::string_view text, const std::string &name, Trace &trace);

/// Parses a file.
[[nodiscard]] std::string read_trace(const std::string &path, Trace &trace);

} // namespace bench
