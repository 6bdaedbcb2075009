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

/// One sample of one body, by place: Trace::bodies[body].samples[sample].
struct SampleIndex {
	uint32_t body = 0;
	uint32_t sample = 0;
};

/// What was recorded at one time: Trace::order[begin] up to, not including, Trace::order[end].
struct TraceFrame {
	double time = 0.0; ///< seconds
	size_t begin = 0;
	size_t end = 0;
};

/// Recorded motion of many bodies. They may begin late, end early, have gaps and be sampled at different times.
struct Trace {
	std::vector<TraceBody> bodies; ///< by ascending id; each has a sample
	std::vector<SampleIndex> order; ///< all samples by ascending time
	std::vector<TraceFrame> frames; ///< by ascending time; at least two

	[[nodiscard]] const TraceSample &sample(const SampleIndex &index) const { return bodies[index.body].samples[index.sample]; }
	[[nodiscard]] double begin() const { return frames.front().time; }
	[[nodiscard]] double end() const { return frames.back().time; }
	/// Seconds from the first sample to the last; greater than 0.
	[[nodiscard]] double duration() const { return end() - begin(); }
	/// The time between a body's consecutive samples, in seconds: the mean of those within 10 % of their median. Between
	/// frames if no body has two samples.
	[[nodiscard]] double usual_interval() const;
};

/// Reads text of the lines `t,id,x,y,z,qw,qx,qy,qz`: seconds, a whole number, metres, a unit quaternion. A first line of
/// names is skipped, and so are empty lines. Times never go back; of several samples of a body at one time, the last
/// counts. Empty, or what is wrong, beginning with `name` and the line's number; then `trace` is not to be used.
[[nodiscard]] std::string parse_trace(std::string_view text, const std::string &name, Trace &trace);

/// The same of a file.
[[nodiscard]] std::string read_trace(const std::string &path, Trace &trace);

} // namespace bench
