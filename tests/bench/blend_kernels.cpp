// Blends of n pose pairs: ours beside what a C++ programmer would write with GLM.
//
// Every subject does the same job on the same input: n pairs of poses and one weight in, n rows of
// 12 floats (a MultiMesh's transforms) out, on one core, compiled with the same flags. Names read
// case/subject/n; tools/bench turns the medians into rows of ns/pose.

#include "cga/batch/pose_block.hpp"

#include <benchmark/benchmark.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/quaternion.hpp> // length2, which dual_quaternion.hpp uses and does not include

#include <glm/gtx/dual_quaternion.hpp>

#include <random>
#include <string>
#include <vector>

namespace {

using Posef = cga::Pose<float>;

struct PosePair {
	Posef from;
	Posef to;
};

std::vector<PosePair> random_pairs(size_t count) {
	std::mt19937 random(2026);
	std::normal_distribution<float> normal;
	std::uniform_real_distribution<float> place(-10.0f, 10.0f);
	std::uniform_real_distribution<float> log_scale(-0.7f, 0.7f);
	const auto pose = [&]() {
		Posef result;
		result.translation = { place(random), place(random), place(random) };
		result.rotation = glm::normalize(glm::quat(normal(random), normal(random), normal(random), normal(random)));
		result.scale = std::exp(log_scale(random));
		return result;
	};
	std::vector<PosePair> pairs(count);
	for (PosePair &pair : pairs) {
		pair.from = pose();
		pair.to = pose();
	}
	return pairs;
}

void write_row(const glm::mat3 &basis, float scale, const glm::vec3 &origin, float *row) {
	for (int r = 0; r < 3; ++r) {
		for (int c = 0; c < 3; ++c) {
			row[4 * r + c] = scale * basis[c][r];
		}
		row[4 * r + 3] = origin[r];
	}
}

/// What an engine does: position and scale mixed, rotation by slerp.
struct GlmSlerp {
	using Prepared = PosePair;
	static void blend(const Prepared &pair, float weight, float *row) {
		const auto &[from, to] = pair;
		write_row(glm::mat3_cast(glm::slerp(from.rotation, to.rotation, weight)), glm::mix(from.scale, to.scale, weight),
				glm::mix(from.translation, to.translation, weight), row);
	}
};

/// The cheapest correct blend of separate parts: normalised lerp the short way round.
struct GlmNlerp {
	using Prepared = PosePair;
	static void blend(const Prepared &pair, float weight, float *row) {
		const auto &[from, to] = pair;
		const glm::quat end = glm::dot(from.rotation, to.rotation) < 0.0f ? -to.rotation : to.rotation;
		write_row(glm::mat3_cast(glm::normalize(from.rotation * (1.0f - weight) + end * weight)), glm::mix(from.scale, to.scale, weight),
				glm::mix(from.translation, to.translation, weight), row);
	}
};

/// GLM's own coupled path: dual quaternions, made when the poses are set, blended linearly; scale by itself.
struct GlmDualQuaternion {
	struct Prepared {
		explicit Prepared(const PosePair &pair) :
				from(pair.from.rotation, pair.from.translation), to(pair.to.rotation, pair.to.translation), from_scale(pair.from.scale), to_scale(pair.to.scale) {}
		glm::dualquat from;
		glm::dualquat to;
		float from_scale;
		float to_scale;
	};
	static void blend(const Prepared &pair, float weight, float *row) {
		const glm::mat3x4 rows = glm::mat3x4_cast(glm::normalize(glm::lerp(pair.from, pair.to, weight)));
		const float scale = glm::mix(pair.from_scale, pair.to_scale, weight);
		for (int r = 0; r < 3; ++r) {
			row[4 * r + 0] = scale * rows[r][0];
			row[4 * r + 1] = scale * rows[r][1];
			row[4 * r + 2] = scale * rows[r][2];
			row[4 * r + 3] = rows[r][3];
		}
	}
};

template <class Subject>
void one_by_one(benchmark::State &state) {
	const size_t count = size_t(state.range(0));
	const std::vector<PosePair> pairs = random_pairs(count);
	const std::vector<typename Subject::Prepared> prepared(pairs.begin(), pairs.end());
	std::vector<float> rows(count * cga::ROW_FLOATS);
	float weight = 0.0f;
	for (auto _ : state) {
		weight = weight < 0.9f ? weight + 0.07f : 0.03f;
		for (size_t i = 0; i < count; ++i) {
			Subject::blend(prepared[i], weight, &rows[i * cga::ROW_FLOATS]);
		}
		benchmark::ClobberMemory();
	}
}

void in_blocks(benchmark::State &state, cga::Mode mode) {
	const size_t count = size_t(state.range(0));
	const std::vector<PosePair> pairs = random_pairs(count);
	std::vector<cga::PoseBlock> blocks(cga::block_count(count));
	for (size_t i = 0; i < count; ++i) {
		blocks[i / cga::PoseBlock::LANES].set(int(i % cga::PoseBlock::LANES), pairs[i].from, pairs[i].to);
	}
	std::vector<float> rows(count * cga::ROW_FLOATS);
	float weight = 0.0f;
	for (auto _ : state) {
		weight = weight < 0.9f ? weight + 0.07f : 0.03f;
		cga::interpolate_blocks(blocks.data(), count, nullptr, weight, mode, rows.data());
		benchmark::ClobberMemory();
	}
}

void one_to_a_million(benchmark::internal::Benchmark *benchmark) {
	benchmark->RangeMultiplier(10)->Range(1, 1000000);
}

const bool registered = [] {
	for (const char *const mode : { "interpolate_linear", "interpolate_screw" }) {
		const std::string name = mode;
		const cga::Mode blend = name == "interpolate_linear" ? cga::Mode::LINEAR : cga::Mode::SCREW;
		benchmark::RegisterBenchmark((name + "/ga_godot").c_str(), in_blocks, blend)->Apply(one_to_a_million);
		benchmark::RegisterBenchmark((name + "/glm_slerp").c_str(), one_by_one<GlmSlerp>)->Apply(one_to_a_million);
		benchmark::RegisterBenchmark((name + "/glm_nlerp").c_str(), one_by_one<GlmNlerp>)->Apply(one_to_a_million);
		benchmark::RegisterBenchmark((name + "/glm_dual_quaternion").c_str(), one_by_one<GlmDualQuaternion>)->Apply(one_to_a_million);
	}
	return true;
}();

} // namespace

BENCHMARK_MAIN();
