#pragma once

#include "cga/batch/motor_block.hpp"
#include "cga/batch/pose_block.hpp"

#include <benchmark/benchmark.h>

#include <glm/gtc/quaternion.hpp>

#include <random>
#include <string>
#include <vector>

// The input of the kernel benchmarks, and the measurement of a subject.
//
// All subjects of a case do the same work on the same input on one core, compiled with the same flags. A name is
// case/subject/n; tools/bench writes the medians as rows.

namespace kernels_bench {

using Posef = cga::Pose<float>;

struct PosePair {
	Posef from;
	Posef to;
};

class PoseSource {
public:
	Posef pose() {
		Posef result;
		result.translation = point();
		result.rotation = glm::normalize(glm::quat(_normal(_random), _normal(_random), _normal(_random), _normal(_random)));
		result.scale = std::exp(_log_scale(_random));
		return result;
	}
	glm::vec3 point() { return { _coordinate(_random), _coordinate(_random), _coordinate(_random) }; }

private:
	std::mt19937 _random{ 2026 };
	std::normal_distribution<float> _normal;
	std::uniform_real_distribution<float> _coordinate{ -10.0f, 10.0f };
	std::uniform_real_distribution<float> _log_scale{ -0.7f, 0.7f };
};

inline std::vector<PosePair> random_pairs(size_t count) {
	PoseSource source;
	std::vector<PosePair> pairs(count);
	for (PosePair &pair : pairs) {
		pair.from = source.pose();
		pair.to = source.pose();
	}
	return pairs;
}

// Row-major basis times scale with the origin: a MultiMesh's transform.
inline void write_row(const glm::mat3 &basis, float scale, const glm::vec3 &origin, float *row) {
	for (int r = 0; r < 3; ++r) {
		for (int c = 0; c < 3; ++c) {
			row[4 * r + c] = scale * basis[c][r];
		}
		row[4 * r + 3] = origin[r];
	}
}

// Measures `run()`, a pass over `count` items that moves `bytes` each.
template <class Run>
void measure(benchmark::State &state, size_t count, size_t bytes, Run run) {
	for (auto _ : state) {
		run();
		benchmark::ClobberMemory();
	}
	state.SetBytesProcessed(int64_t(state.iterations()) * int64_t(count * bytes));
}

inline void one_to_a_million(benchmark::internal::Benchmark *benchmark) {
	benchmark->RangeMultiplier(10)->Range(1, 1000000);
}

template <class Function, class... Arguments>
void add(const std::string &case_name, const std::string &subject, Function function, Arguments... arguments) {
	benchmark::RegisterBenchmark((case_name + "/" + subject).c_str(), function, arguments...)->Apply(one_to_a_million);
}

} // namespace kernels_bench
