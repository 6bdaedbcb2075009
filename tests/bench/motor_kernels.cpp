// Composition, extraction and point transforms of n motors, compared with GLM's matrices, dual quaternions and quaternions
// with vectors.

#include "kernel_input.hpp"

#include "cga/motor/motor.hpp"

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/quaternion.hpp>

#include <glm/gtx/dual_quaternion.hpp>
#include <glm/mat4x4.hpp>

#include <cstring>

namespace kernels_bench {

namespace {

using cga::InstructionSet;
using Motorf = cga::Motor<float>;

std::vector<Posef> random_poses(size_t count) {
	PoseSource source;
	std::vector<Posef> poses(count);
	for (Posef &pose : poses) {
		pose = source.pose();
	}
	return poses;
}

std::vector<glm::vec3> random_points(size_t count) {
	PoseSource source;
	std::vector<glm::vec3> points(count);
	for (glm::vec3 &point : points) {
		point = source.point();
	}
	return points;
}

// Form is a subject's representation of a pose.
struct GlmMatrix {
	using Form = glm::mat4;
	static Form make(const Posef &pose) {
		glm::mat4 matrix(glm::mat3_cast(pose.rotation) * pose.scale);
		matrix[3] = glm::vec4(pose.translation, 1.0f);
		return matrix;
	}
	static Form compose(const Form &first, const Form &second) { return first * second; }
	static glm::vec3 transform(const Form &form, const glm::vec3 &point) { return glm::vec3(form * glm::vec4(point, 1.0f)); }
	static void extract(const Form &form, float *row) { write_row(glm::mat3(form), 1.0f, glm::vec3(form[3]), row); }
};

// Rigid, without scale: less work.
struct GlmDualQuaternion {
	using Form = glm::dualquat;
	static Form make(const Posef &pose) { return Form(pose.rotation, pose.translation); }
	static Form compose(const Form &first, const Form &second) { return first * second; }
	static glm::vec3 transform(const Form &form, const glm::vec3 &point) { return form * point; }
	static void extract(const Form &form, float *row) {
		const glm::mat3x4 rows = glm::mat3x4_cast(form);
		std::memcpy(row, &rows, sizeof(rows));
	}
};

struct GlmQuaternionVector {
	using Form = Posef;
	static Form make(const Posef &pose) { return pose; }
	static Form compose(const Form &first, const Form &second) {
		return { transform(first, second.translation), first.rotation * second.rotation, first.scale * second.scale };
	}
	static glm::vec3 transform(const Form &form, const glm::vec3 &point) { return form.translation + form.scale * (form.rotation * point); }
	static void extract(const Form &form, float *row) { write_row(glm::mat3_cast(form.rotation), form.scale, form.translation, row); }
};

// This library's motors, one at a time.
struct OneMotor {
	using Form = Motorf;
	static Form make(const Posef &pose) { return Motorf::from_pose(pose); }
	static Form compose(const Form &first, const Form &second) { return cga::compose(first, second); }
	static glm::vec3 transform(const Form &form, const glm::vec3 &point) { return form.transform_point(point); }
	static void extract(const Form &form, float *row) {
		const Posef pose = *form.to_pose();
		write_row(glm::mat3_cast(pose.rotation), pose.scale, pose.translation, row);
	}
};

template <class Subject>
std::vector<typename Subject::Form> forms(const std::vector<Posef> &poses) {
	std::vector<typename Subject::Form> made;
	made.reserve(poses.size());
	for (const Posef &pose : poses) {
		made.push_back(Subject::make(pose));
	}
	return made;
}

std::vector<cga::MotorBlock> motor_blocks(const std::vector<Posef> &poses) {
	std::vector<cga::MotorBlock> blocks(cga::block_count(poses.size()));
	for (size_t i = 0; i < poses.size(); ++i) {
		blocks[i / cga::MotorBlock::LANES].set(int(i % cga::MotorBlock::LANES), Motorf::from_pose(poses[i]));
	}
	return blocks;
}

template <class Subject>
void compose_each(benchmark::State &state) {
	const size_t count = size_t(state.range(0));
	const auto first = forms<Subject>(random_poses(count));
	const std::vector<typename Subject::Form> second(first.rbegin(), first.rend());
	std::vector<typename Subject::Form> products(first);
	measure(state, count, 3 * sizeof(typename Subject::Form), [&] {
		for (size_t i = 0; i < count; ++i) {
			products[i] = Subject::compose(first[i], second[i]);
		}
	});
}

void compose_in_blocks(benchmark::State &state, InstructionSet set) {
	const size_t count = size_t(state.range(0));
	const std::vector<cga::MotorBlock> first = motor_blocks(random_poses(count));
	const std::vector<cga::MotorBlock> second(first.rbegin(), first.rend());
	std::vector<cga::MotorBlock> products(first.size());
	measure(state, count, 3 * sizeof(Motorf), [&] { cga::compose_blocks(first.data(), second.data(), first.size(), products.data(), set); });
}

template <class Subject>
void extract_each(benchmark::State &state) {
	const size_t count = size_t(state.range(0));
	const auto made = forms<Subject>(random_poses(count));
	std::vector<float> rows(count * cga::ROW_FLOATS);
	measure(state, count, sizeof(typename Subject::Form) + sizeof(float) * cga::ROW_FLOATS, [&] {
		for (size_t i = 0; i < count; ++i) {
			Subject::extract(made[i], &rows[i * cga::ROW_FLOATS]);
		}
	});
}

void extract_in_blocks(benchmark::State &state, InstructionSet set) {
	const size_t count = size_t(state.range(0));
	const std::vector<cga::MotorBlock> motors = motor_blocks(random_poses(count));
	std::vector<float> rows(count * cga::ROW_FLOATS);
	measure(state, count, sizeof(Motorf) + sizeof(float) * cga::ROW_FLOATS, [&] { cga::extract_blocks(motors.data(), count, rows.data(), set); });
}

void motors_of_rows(benchmark::State &state) {
	const size_t count = size_t(state.range(0));
	std::vector<cga::MotorBlock> motors = motor_blocks(random_poses(count));
	std::vector<float> rows(count * cga::ROW_FLOATS);
	cga::extract_blocks(motors.data(), count, rows.data());
	measure(state, count, sizeof(Motorf) + sizeof(float) * cga::ROW_FLOATS, [&] { cga::motors_from_rows(rows.data(), count, motors.data()); });
}

// The same from matrices, with GLM's quaternion of a matrix.
void quaternions_of_rows(benchmark::State &state) {
	const size_t count = size_t(state.range(0));
	const auto matrices = forms<GlmMatrix>(random_poses(count));
	std::vector<Posef> poses(count);
	measure(state, count, sizeof(glm::mat4) + sizeof(Posef), [&] {
		for (size_t i = 0; i < count; ++i) {
			const glm::mat3 basis(matrices[i]);
			const float scale = glm::length(basis[0]);
			poses[i] = { glm::vec3(matrices[i][3]), glm::quat_cast(basis / scale), scale };
		}
	});
}

template <class Subject>
void transform_each(benchmark::State &state) {
	const size_t count = size_t(state.range(0));
	const auto made = forms<Subject>(random_poses(count));
	const std::vector<glm::vec3> points = random_points(count);
	std::vector<glm::vec3> images(count);
	measure(state, count, sizeof(typename Subject::Form) + 2 * sizeof(glm::vec3), [&] {
		for (size_t i = 0; i < count; ++i) {
			images[i] = Subject::transform(made[i], points[i]);
		}
	});
}

void transform_in_blocks(benchmark::State &state, InstructionSet set) {
	const size_t count = size_t(state.range(0));
	const std::vector<cga::MotorBlock> motors = motor_blocks(random_poses(count));
	const std::vector<glm::vec3> points = random_points(count);
	std::vector<glm::vec3> images(count);
	measure(state, count, sizeof(Motorf) + 2 * sizeof(glm::vec3), [&] { cga::transform_points(motors.data(), &points[0].x, count, &images[0].x, set); });
}

template <class Subject>
void transform_all(benchmark::State &state) {
	const size_t count = size_t(state.range(0));
	const auto form = Subject::make(PoseSource().pose());
	const std::vector<glm::vec3> points = random_points(count);
	std::vector<glm::vec3> images(count);
	measure(state, count, 2 * sizeof(glm::vec3), [&] {
		for (size_t i = 0; i < count; ++i) {
			images[i] = Subject::transform(form, points[i]);
		}
	});
}

void transform_all_at_once(benchmark::State &state, InstructionSet set) {
	const size_t count = size_t(state.range(0));
	const Motorf motor = Motorf::from_pose(PoseSource().pose());
	const std::vector<glm::vec3> points = random_points(count);
	std::vector<glm::vec3> images(count);
	measure(state, count, 2 * sizeof(glm::vec3), [&] { cga::transform_points(motor, &points[0].x, count, &images[0].x, set); });
}

// Memory bandwidth: reads 48 bytes and writes 48 for each item.
void copy_memory(benchmark::State &state) {
	const size_t count = size_t(state.range(0));
	const std::vector<float> source(count * cga::ROW_FLOATS, 1.0f);
	std::vector<float> destination(source);
	measure(state, count, 2 * sizeof(float) * cga::ROW_FLOATS, [&] { std::memcpy(destination.data(), source.data(), source.size() * sizeof(float)); });
}

// a[i] = b[i] + f c[i]: 16 floats read and 8 written of each item.
void triad(benchmark::State &state) {
	const size_t floats = size_t(state.range(0)) * 8;
	const std::vector<float> left(floats, 1.0f), right(floats, 2.0f);
	std::vector<float> sum(floats);
	measure(state, floats, 3 * sizeof(float), [&] {
		for (size_t i = 0; i < floats; ++i) {
			sum[i] = left[i] + 0.5f * right[i];
		}
	});
}

const bool REGISTERED = [] {
	const InstructionSet best = cga::best_instruction_set();
	add("compose", "ga_godot", compose_in_blocks, best);
	add("compose", "ga_godot_baseline", compose_in_blocks, InstructionSet::BASELINE);
	add("compose", "ga_godot_one_motor", compose_each<OneMotor>);
	add("compose", "glm_mat4", compose_each<GlmMatrix>);
	add("compose", "glm_dual_quaternion", compose_each<GlmDualQuaternion>);
	add("compose", "glm_quaternion_vector", compose_each<GlmQuaternionVector>);
	add("extract", "ga_godot", extract_in_blocks, best);
	add("extract", "ga_godot_baseline", extract_in_blocks, InstructionSet::BASELINE);
	add("extract", "ga_godot_one_motor", extract_each<OneMotor>);
	add("extract", "glm_mat4", extract_each<GlmMatrix>);
	add("extract", "glm_dual_quaternion", extract_each<GlmDualQuaternion>);
	add("extract", "glm_quaternion_vector", extract_each<GlmQuaternionVector>);
	add("motors_from_rows", "ga_godot", motors_of_rows);
	add("motors_from_rows", "glm_quat_cast", quaternions_of_rows);
	add("transform_points", "ga_godot", transform_in_blocks, best);
	add("transform_points", "ga_godot_baseline", transform_in_blocks, InstructionSet::BASELINE);
	add("transform_points", "ga_godot_one_motor", transform_each<OneMotor>);
	add("transform_points", "glm_mat4", transform_each<GlmMatrix>);
	add("transform_points", "glm_dual_quaternion", transform_each<GlmDualQuaternion>);
	add("transform_points", "glm_quaternion_vector", transform_each<GlmQuaternionVector>);
	add("transform_points_by_one", "ga_godot", transform_all_at_once, best);
	add("transform_points_by_one", "ga_godot_baseline", transform_all_at_once, InstructionSet::BASELINE);
	add("transform_points_by_one", "glm_mat4", transform_all<GlmMatrix>);
	add("transform_points_by_one", "glm_quaternion_vector", transform_all<GlmQuaternionVector>);
	add("memory", "copy", copy_memory);
	add("memory", "triad", triad);
	return true;
}();

} // namespace

} // namespace kernels_bench
