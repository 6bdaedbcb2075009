// The algebra behind a C interface, for the oracles in Python. Arrays hold `count` elements one after the other:
// a multivector is 32 doubles, a pose t1 t2 t3 qw qx qy qz s, a logarithm w1 w2 w3 v1 v2 v3 sigma.

#include "cga/motor/interpolate.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "cga/algebra/multivector.hpp"
#include "cga/batch/pose_block.hpp"

#include <algorithm>
#include <vector>

using namespace cga;

namespace {

constexpr size_t POSE_NUMBERS = 8;
constexpr size_t LOG_NUMBERS = 7;

Multivector load_multivector(const double *numbers) {
	Multivector result;
	for (int index = 0; index < BLADE_COUNT; ++index) {
		result[index] = numbers[index];
	}
	return result;
}

void store_multivector(const Multivector &multivector, double *numbers) {
	std::copy(multivector.coefficients().begin(), multivector.coefficients().end(), numbers);
}

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

#define ORACLE extern "C" __attribute__((visibility("default")))

// `product` in the order of PRODUCTS in library.py.
ORACLE void oracle_product(int product, const double *left, const double *right, double *result, size_t count) {
	for (size_t i = 0; i < count; ++i) {
		const Multivector a = load_multivector(left + i * BLADE_COUNT);
		const Multivector b = load_multivector(right + i * BLADE_COUNT);
		const Multivector products[] = { a.geometric_product(b), a.outer_product(b), a.inner_product(b), a.left_contraction(b), a.right_contraction(b), Multivector::scalar(a.scalar_product(b)) };
		store_multivector(products[product], result + i * BLADE_COUNT);
	}
}

// `operation` in the order of OPERATIONS in library.py.
ORACLE void oracle_operation(int operation, const double *operands, double *result, size_t count) {
	for (size_t i = 0; i < count; ++i) {
		const Multivector x = load_multivector(operands + i * BLADE_COUNT);
		const Multivector results[] = { x.reverse(), x.grade_involution(), x.clifford_conjugate(), x.dual(), x.undual(), Multivector::scalar(x.norm_squared()), x.inverse_of_versor().value_or(Multivector()) };
		store_multivector(results[operation], result + i * BLADE_COUNT);
	}
}

ORACLE void oracle_sandwich(const double *versors, const double *operands, double *result, size_t count) {
	for (size_t i = 0; i < count; ++i) {
		const Multivector versor = load_multivector(versors + i * BLADE_COUNT);
		const Multivector x = load_multivector(operands + i * BLADE_COUNT);
		store_multivector(versor.sandwich(x).value_or(Multivector()), result + i * BLADE_COUNT);
	}
}

ORACLE void oracle_motor(const double *poses, double *result, size_t count) {
	for (size_t i = 0; i < count; ++i) {
		store_multivector(to_multivector(Motor<double>::from_pose(load_pose(poses + i * POSE_NUMBERS))), result + i * BLADE_COUNT);
	}
}

// The poses of motors; zeros where there is none.
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

// By the batch kernels; 12 floats a body, as a MultiMesh has them.
ORACLE void oracle_interpolate_blocks(int mode, const float *from, const float *to, const float *weights, float *rows, size_t count) {
	std::vector<PoseBlock> blocks(block_count(count));
	for (size_t i = 0; i < count; ++i) {
		blocks[i / PoseBlock::LANES].set(int(i % PoseBlock::LANES), load_pose(from + i * POSE_NUMBERS), load_pose(to + i * POSE_NUMBERS));
	}
	interpolate_blocks(blocks.data(), count, weights, 0.0f, Mode(mode), rows);
}
