#include "trace.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <unordered_map>

namespace bench {

namespace {

constexpr std::array<const char *, 9> FIELDS = { "t", "id", "x", "y", "z", "qw", "qx", "qy", "qz" };
// Recordings have quaternions of four digits or more.
constexpr double MAX_NORM_ERROR = 0.01;
// Intervals within this part of the median are averaged.
constexpr double MAX_INTERVAL_DEVIATION = 0.1;
constexpr uint32_t MAX_ID = 0x7fffffffu;

struct Line {
	double time = 0.0;
	uint32_t id = 0;
	cga::Pose<double> pose;
};

std::string_view trim(std::string_view text) {
	constexpr const char *WHITESPACE = " \t\r";
	const size_t first = text.find_first_not_of(WHITESPACE);
	return first == std::string_view::npos ? std::string_view() : text.substr(first, text.find_last_not_of(WHITESPACE) - first + 1);
}

// Part of a line for a message: at most 40 characters, control characters replaced.
std::string quoted(std::string_view text) {
	std::string result = "'";
	for (const char c : text.substr(0, 40)) {
		result += c >= ' ' && c <= '~' ? c : '?';
	}
	return result + (text.size() > 40 ? "...'" : "'");
}

template <class Number>
bool parse_number(std::string_view text, Number &number) {
	const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), number);
	return result.ec == std::errc() && result.ptr == text.data() + text.size();
}

// An error; empty on success.
std::string parse_line(std::string_view text, Line &line) {
	std::array<double, 9> values{};
	for (size_t i = 0; i < FIELDS.size(); ++i) {
		const size_t comma = text.find(',');
		if ((comma == std::string_view::npos) != (i + 1 == FIELDS.size())) {
			return comma == std::string_view::npos ? "ends before the field " + std::string(FIELDS[i + 1]) : "has more than 9 fields";
		}
		const std::string_view field = trim(text.substr(0, comma));
		text = comma == std::string_view::npos ? std::string_view() : text.substr(comma + 1);
		const bool is_id = i == 1;
		if (is_id ? !parse_number(field, line.id) || line.id > MAX_ID : !parse_number(field, values[i]) || !std::isfinite(values[i])) {
			return std::string(FIELDS[i]) + " is " + quoted(field) + (is_id ? ", not an integer from 0 to 2147483647" : ", not a finite number");
		}
	}
	line.time = values[0];
	line.pose.translation = { values[2], values[3], values[4] };
	line.pose.rotation = glm::dquat(values[5], values[6], values[7], values[8]);
	const double norm = glm::length(line.pose.rotation);
	if (!(std::abs(norm - 1.0) <= MAX_NORM_ERROR)) {
		return "the quaternion's length is " + std::to_string(norm) + ", not 1";
	}
	line.pose.rotation /= norm;
	return {};
}

// Adds lines by ascending time; sorts the bodies at the end.
class TraceBuilder {
public:
	explicit TraceBuilder(Trace &trace) :
			_trace(trace) {}

	std::string add(const Line &line) {
		std::vector<TraceFrame> &frames = _trace.frames;
		if (!frames.empty() && line.time < frames.back().time) {
			return "time decreases from " + std::to_string(frames.back().time) + " to " + std::to_string(line.time) + "; sort the lines by time";
		}
		const auto [entry, is_new] = _index.try_emplace(line.id, uint32_t(_trace.bodies.size()));
		if (is_new) {
			_trace.bodies.push_back({ line.id, {} });
		}
		std::vector<TraceSample> &samples = _trace.bodies[entry->second].samples;
		if (!samples.empty() && samples.back().time == line.time) {
			samples.back().pose = line.pose;
			return {};
		}
		if (frames.empty() || frames.back().time != line.time) {
			frames.push_back({ line.time, _trace.order.size(), _trace.order.size() });
		}
		_trace.order.push_back({ entry->second, uint32_t(samples.size()) });
		frames.back().end = _trace.order.size();
		samples.push_back({ line.time, line.pose });
		return {};
	}

	void sort_bodies() {
		std::vector<uint32_t> by_id(_trace.bodies.size());
		for (size_t i = 0; i < by_id.size(); ++i) {
			by_id[i] = uint32_t(i);
		}
		std::sort(by_id.begin(), by_id.end(), [this](uint32_t a, uint32_t b) { return _trace.bodies[a].id < _trace.bodies[b].id; });
		std::vector<TraceBody> sorted(by_id.size());
		std::vector<uint32_t> new_index(by_id.size());
		for (size_t i = 0; i < by_id.size(); ++i) {
			sorted[i] = std::move(_trace.bodies[by_id[i]]);
			new_index[by_id[i]] = uint32_t(i);
		}
		_trace.bodies = std::move(sorted);
		for (SampleIndex &index : _trace.order) {
			index.body = new_index[index.body];
		}
	}

private:
	Trace &_trace;
	std::unordered_map<uint32_t, uint32_t> _index; // of bodies, by id
};

double median(std::vector<double> &values) {
	const auto middle = values.begin() + ptrdiff_t(values.size() / 2);
	std::nth_element(values.begin(), middle, values.end());
	return *middle;
}

} // namespace

double Trace::sample_interval() const {
	std::vector<double> intervals;
	for (const TraceBody &body : bodies) {
		for (size_t i = 1; i < body.samples.size(); ++i) {
			intervals.push_back(body.samples[i].time - body.samples[i - 1].time);
		}
	}
	for (size_t i = 1; intervals.empty() && i < frames.size(); ++i) {
		intervals.push_back(frames[i].time - frames[i - 1].time);
	}
	// Recorded times are rounded, which the mean of intervals near the median removes.
	const double middle = median(intervals);
	double sum = 0.0;
	size_t count = 0;
	for (const double interval : intervals) {
		if (std::abs(interval - middle) <= MAX_INTERVAL_DEVIATION * middle) {
			sum += interval;
			++count;
		}
	}
	return sum / double(count);
}

std::string parse_trace(std::string_view text, const std::string &name, Trace &trace) {
	trace = Trace();
	TraceBuilder builder(trace);
	size_t number = 0;
	bool may_be_header = true;
	constexpr std::string_view BYTE_ORDER_MARK = "\xef\xbb\xbf";
	if (text.substr(0, BYTE_ORDER_MARK.size()) == BYTE_ORDER_MARK) {
		text.remove_prefix(BYTE_ORDER_MARK.size());
	}
	while (!text.empty()) {
		const size_t end = text.find('\n');
		const std::string_view content = trim(text.substr(0, end));
		text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
		++number;
		if (content.empty()) {
			continue;
		}
		if (may_be_header && content.substr(0, 2) == "t,") {
			may_be_header = false;
			continue;
		}
		may_be_header = false;
		Line line;
		std::string problem = parse_line(content, line);
		if (problem.empty()) {
			problem = builder.add(line);
		}
		if (!problem.empty()) {
			return name + ":" + std::to_string(number) + ": " + problem;
		}
	}
	if (trace.frames.size() < 2) {
		return name + (trace.frames.empty() ? ": no samples" : ": all samples have the same time") + "; expected lines of t,id,x,y,z,qw,qx,qy,qz";
	}
	builder.sort_bodies();
	return {};
}

std::string read_trace(const std::string &path, Trace &trace) {
	const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
	std::string text;
	if (file) {
		std::array<char, 65536> block;
		errno = 0;
		while (const size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
			text.append(block.data(), count);
		}
	}
	if (!file || std::ferror(file.get())) {
		return path + ": cannot read the file: " + std::strerror(errno);
	}
	return parse_trace(text, path, trace);
}

} // namespace bench
