// Blends of n pose pairs, compared with typical code that uses GLM or Eigen. Input: n pose pairs and one weight; output: n rows of 12
// floats (a MultiMesh's transforms).

#include "kernel_input.hpp"
#include "load_and_store_avx2.hpp"

#include "cga/platform/compiler.hpp"

#if __has_include(<eigen3/Eigen/Geometry>)
#include <eigen3/Eigen/Geometry>
#define HAS_EIGEN 1
#endif

#include <glm/gtc/matrix_transform.hpp>
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/quaternion.hpp> // length2, which dual_quaternion.hpp uses and does not include

#include <glm/gtx/dual_quaternion.hpp>

#include <cmath>

namespace kernels_bench {

namespace {

// The method of engines: lerp of position and scale, slerp of rotation.
struct GlmSlerp {
	using Prepared = PosePair;
	static void blend(const Prepared &pair, float weight, float *row) {
		const auto &[from, to] = pair;
		write_row(glm::mat3_cast(glm::slerp(from.rotation, to.rotation, weight)), glm::mix(from.scale, to.scale, weight),
				glm::mix(from.translation, to.translation, weight), row);
	}
};

// The cheapest correct blend of separate parts: normalized lerp along the shorter rotation.
struct GlmNlerp {
	using Prepared = PosePair;
	static void blend(const Prepared &pair, float weight, float *row) {
		const auto &[from, to] = pair;
		const glm::quat end = glm::dot(from.rotation, to.rotation) < 0.0f ? -to.rotation : to.rotation;
		write_row(glm::mat3_cast(glm::normalize(from.rotation * (1.0f - weight) + end * weight)), glm::mix(from.scale, to.scale, weight),
				glm::mix(from.translation, to.translation, weight), row);
	}
};

void write_row(const glm::dualquat &pose, float scale, float *row) {
	const glm::mat3x4 rows = glm::mat3x4_cast(pose);
	for (int r = 0; r < 3; ++r) {
		row[4 * r + 0] = scale * rows[r][0];
		row[4 * r + 1] = scale * rows[r][1];
		row[4 * r + 2] = scale * rows[r][2];
		row[4 * r + 3] = rows[r][3];
	}
}

// GLM's coupled path: dual quaternions, computed when the poses are set, blended linearly; the scale separately.
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
		write_row(glm::normalize(glm::lerp(pair.from, pair.to, weight)), glm::mix(pair.from_scale, pair.to_scale, weight), row);
	}
};

// Screw interpolation with GLM's dual quaternions: from exp(a log(from^-1 to)), which GLM itself lacks. The logarithm (the
// half angle and pitch, axis and moment of the screw) is computed when the poses are set, as in this library. The scale is
// interpolated separately, geometrically.
struct GlmDualQuaternionScrew {
	struct Prepared {
		explicit Prepared(const PosePair &pair) :
				from(pair.from.rotation, pair.from.translation), from_scale(pair.from.scale), log_ratio(std::log(pair.to.scale / pair.from.scale)) {
			glm::dualquat motion = glm::inverse(from) * glm::dualquat(pair.to.rotation, pair.to.translation);
			motion = motion.real.w < 0.0f ? motion * -1.0f : motion;
			const glm::vec3 real(motion.real.x, motion.real.y, motion.real.z);
			const glm::vec3 dual(motion.dual.x, motion.dual.y, motion.dual.z);
			const float sine = glm::length(real);
			half_angle = std::atan2(sine, motion.real.w);
			axis = real / sine;
			half_pitch = -motion.dual.w / sine;
			moment = (dual - axis * half_pitch * motion.real.w) / sine;
		}
		glm::dualquat from;
		float from_scale;
		float log_ratio;
		float half_angle;
		float half_pitch;
		glm::vec3 axis;
		glm::vec3 moment;
	};
	static void blend(const Prepared &pair, float weight, float *row) {
		const float sine = std::sin(weight * pair.half_angle);
		const float cosine = std::cos(weight * pair.half_angle);
		const float pitch = weight * pair.half_pitch;
		glm::dualquat power;
		power.real = glm::quat(cosine, pair.axis * sine);
		power.dual = glm::quat(-pitch * sine, pair.moment * sine + pair.axis * (pitch * cosine));
		write_row(pair.from * power, pair.from_scale * std::exp(weight * pair.log_ratio), row);
	}
};

#if defined(HAS_EIGEN)
struct EigenSlerp {
	struct Prepared {
		explicit Prepared(const PosePair &pair) :
				from(rotation_of(pair.from)), to(rotation_of(pair.to)), from_position(position_of(pair.from)), to_position(position_of(pair.to)), from_scale(pair.from.scale), to_scale(pair.to.scale) {}
		static Eigen::Quaternionf rotation_of(const Posef &pose) { return { pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z }; }
		static Eigen::Vector3f position_of(const Posef &pose) { return { pose.translation.x, pose.translation.y, pose.translation.z }; }
		Eigen::Quaternionf from, to;
		Eigen::Vector3f from_position, to_position;
		float from_scale, to_scale;
	};
	static void blend(const Prepared &pair, float weight, float *row) {
		Eigen::Map<Eigen::Matrix<float, 3, 4, Eigen::RowMajor>> out(row);
		const float scale = glm::mix(pair.from_scale, pair.to_scale, weight);
		out.leftCols<3>() = scale * pair.from.slerp(weight, pair.to).toRotationMatrix();
		out.col(3) = (1.0f - weight) * pair.from_position + weight * pair.to_position;
	}
};
#endif

float next_weight(float weight) {
	return weight < 0.9f ? weight + 0.07f : 0.03f;
}

template <class Subject>
void one_by_one(benchmark::State &state) {
	const size_t count = size_t(state.range(0));
	const std::vector<PosePair> pairs = random_pairs(count);
	std::vector<typename Subject::Prepared> prepared;
	prepared.reserve(count);
	for (const PosePair &pair : pairs) {
		prepared.emplace_back(pair);
	}
	std::vector<float> rows(count * cga::ROW_FLOATS);
	float weight = 0.0f;
	measure(state, count, sizeof(typename Subject::Prepared) + sizeof(float) * cga::ROW_FLOATS, [&] {
		weight = next_weight(weight);
		for (size_t i = 0; i < count; ++i) {
			Subject::blend(prepared[i], weight, &rows[i * cga::ROW_FLOATS]);
		}
	});
}

// The bytes of a pose that a mode reads: the rows of its block.
size_t bytes_read(cga::Mode mode) {
	return mode == cga::Mode::LINEAR ? 20 * sizeof(float) : 28 * sizeof(float);
}

std::vector<cga::PoseBlock> random_blocks(size_t count) {
	const std::vector<PosePair> pairs = random_pairs(count);
	std::vector<cga::PoseBlock> blocks(cga::block_count(count));
	for (size_t i = 0; i < count; ++i) {
		blocks[i / cga::PoseBlock::LANES].set(int(i % cga::PoseBlock::LANES), pairs[i].from, pairs[i].to);
	}
	return blocks;
}

void in_blocks(benchmark::State &state, cga::Mode mode, cga::InstructionSet set) {
	const size_t count = size_t(state.range(0));
	const std::vector<cga::PoseBlock> blocks = random_blocks(count);
	std::vector<float> rows(count * cga::ROW_FLOATS);
	float weight = 0.0f;
	measure(state, count, bytes_read(mode) + sizeof(float) * cga::ROW_FLOATS, [&] {
		weight = next_weight(weight);
		cga::interpolate_blocks(blocks.data(), count, nullptr, weight, mode, rows.data(), set);
	});
}

#if CGA_X86_64
void loads_and_stores(benchmark::State &state) {
	const size_t count = size_t(state.range(0));
	const std::vector<cga::PoseBlock> blocks = random_blocks(count);
	std::vector<float> rows(blocks.size() * cga::PoseBlock::LANES * cga::ROW_FLOATS);
	measure(state, count, bytes_read(cga::Mode::LINEAR) + sizeof(float) * cga::ROW_FLOATS, [&] { load_and_store(blocks.data(), blocks.size(), rows.data()); });
}
#endif

const bool REGISTERED = [] {
	for (const char *const name : { "interpolate_linear", "interpolate_screw" }) {
		const std::string mode = name;
		const cga::Mode blend = mode == "interpolate_linear" ? cga::Mode::LINEAR : cga::Mode::SCREW;
		add(mode, "ga_godot", in_blocks, blend, cga::best_instruction_set());
		add(mode, "ga_godot_baseline", in_blocks, blend, cga::InstructionSet::BASELINE);
		add(mode, "ga_godot_scalar", in_blocks, blend, cga::InstructionSet::SCALAR);
		add(mode, "glm_slerp", one_by_one<GlmSlerp>);
		add(mode, "glm_nlerp", one_by_one<GlmNlerp>);
		add(mode, "glm_dual_quaternion", one_by_one<GlmDualQuaternion>);
#if defined(HAS_EIGEN)
		add(mode, "eigen_slerp", one_by_one<EigenSlerp>);
#endif
	}
	add("interpolate_screw", "glm_dual_quaternion_screw", one_by_one<GlmDualQuaternionScrew>);
#if CGA_X86_64
	if (cga::best_instruction_set() == cga::InstructionSet::AVX2_FMA) {
		add("interpolate_linear", "loads_and_stores", loads_and_stores);
	}
#endif
	return true;
}();

} // namespace

} // namespace kernels_bench

BENCHMARK_MAIN();
