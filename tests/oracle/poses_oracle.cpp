// C interface of poses and their interpolation. A pose is t1 t2 t3 qw qx qy qz s, a logarithm
// w1 w2 w3 v1 v2 v3 sigma.

#include "elements.hpp"

#include "cga/batch/pose_block.hpp"
#include "cga/motor/interpolate.hpp"
#include "cga/motor/motor_multivector.hpp"

#include <vector>

using namespace cga;
using namespace oracle;

namespace {

constexpr size_t POSE_NUMBERS = 8;
constexpr size_t LOG_NUMBERS = 7;

template <class T>
Pose<T> load_pose(const T *n) {
	return { { n[0], n[1], n[2] }, { n[3], n[4], n[5], n[6] }, n[7] };
}

template <class T>
void store_pose(const Pose<T> &pose, T *n) {
	const T numbers[POSE_NUMBERS] = { pose.translation.x, pose.translation.y, pose.translation.z, pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z, pose.scale };
	std::copy_n(numbers, POSE_NUMBERS, n);
}

template <class T>
void exp_all(const T *logs, T *poses, size_t count) {
	for (size_t i = 0; i < count; ++i) {
		const T *n = logs + i * LOG_NUMBERS;
		const MotorLog<T> log{ { n[0], n[1], n[2] }, { n[3], n[4], n[5] }, n[6] };
		store_pose(exp_to_pose(log), poses + i * POSE_NUMBERS);
	}
}

template <class T>
void log_all(const T *poses, T *logs, size_t count) {
	for (size_t i = 0; i < count; ++i) {
		const MotorLog<T> log = log_of_pose(load_pose(poses + i * POSE_NUMBERS));
		const T numbers[LOG_NUMBERS] = { log.rotation.x, log.rotation.y, log.rotation.z, log.velocity.x, log.velocity.y, log.velocity.z, log.dilation };
		std::copy_n(numbers, LOG_NUMBERS, logs + i * LOG_NUMBERS);
	}
}

template <class T>
void power_all(const T *poses, const T *exponents, T *powers, size_t count) {
	for (size_t i = 0; i < count; ++i) {
		store_pose(power_of_pose(load_pose(poses + i * POSE_NUMBERS), exponents[i]), powers + i * POSE_NUMBERS);
	}
}

template <class T>
void interpolate_all(int mode, const T *from, const T *to, const T *weights, T *poses, size_t count) {
	for (size_t i = 0; i < count; ++i) {
		const Pose<T> pose = interpolate(load_pose(from + i * POSE_NUMBERS), load_pose(to + i * POSE_NUMBERS), weights[i], Mode(mode));
		store_pose(pose, poses + i * POSE_NUMBERS);
	}
}

} // namespace

ORACLE void oracle_motor(const double *poses, double *result, size_t count) {
	for (size_t i = 0; i < count; ++i) {
		store_multivector(to_multivector(Motor<double>::from_pose(load_pose(poses + i * POSE_NUMBERS))), result + i * BLADE_COUNT);
	}
}

// The poses of motors; zeros for elements that are not motors.
ORACLE void oracle_extract(const double *motors, double *poses, size_t count) {
	std::fill_n(poses, count * POSE_NUMBERS, 0.0);
	for (size_t i = 0; i < count; ++i) {
		const auto motor = to_motor(load_multivector(motors + i * BLADE_COUNT));
		const auto pose = motor ? motor->to_pose() : std::nullopt;
		if (pose) {
			store_pose(*pose, poses + i * POSE_NUMBERS);
		}
	}
}

ORACLE void oracle_exp_double(const double *logs, double *poses, size_t count) {
	exp_all(logs, poses, count);
}

ORACLE void oracle_exp_float(const float *logs, float *poses, size_t count) {
	exp_all(logs, poses, count);
}

ORACLE void oracle_log_double(const double *poses, double *logs, size_t count) {
	log_all(poses, logs, count);
}

ORACLE void oracle_log_float(const float *poses, float *logs, size_t count) {
	log_all(poses, logs, count);
}

ORACLE void oracle_power_double(const double *poses, const double *exponents, double *powers, size_t count) {
	power_all(poses, exponents, powers, count);
}

ORACLE void oracle_power_float(const float *poses, const float *exponents, float *powers, size_t count) {
	power_all(poses, exponents, powers, count);
}

// `mode` as cga::Mode: LINEAR, SCREW, SEPARATE.
ORACLE void oracle_interpolate_double(int mode, const double *from, const double *to, const double *weights, double *poses, size_t count) {
	interpolate_all(mode, from, to, weights, poses, count);
}

ORACLE void oracle_interpolate_float(int mode, const float *from, const float *to, const float *weights, float *poses, size_t count) {
	interpolate_all(mode, from, to, weights, poses, count);
}

// By the batch kernels; 12 floats per body, in the layout of MultiMesh.
ORACLE void oracle_interpolate_blocks(int mode, const float *from, const float *to, const float *weights, float *rows, size_t count) {
	std::vector<PoseBlock> blocks(block_count(count));
	for (size_t i = 0; i < count; ++i) {
		blocks[i / PoseBlock::LANES].set(int(i % PoseBlock::LANES), load_pose(from + i * POSE_NUMBERS), load_pose(to + i * POSE_NUMBERS));
	}
	interpolate_blocks(blocks.data(), count, weights, 0.0f, Mode(mode), rows);
}
