#include "cga/batch/motor_block.hpp"

#include "cga/batch/motor_kernel.hpp"
#include "cga/batch/row_kernel.hpp"

namespace cga {

namespace {

using kernel::BLOCK_LANES;

constexpr size_t POINT_FLOATS = 3;

struct Composition {
	const MotorBlock *first;
	const MotorBlock *second;
	size_t block_count;
	MotorBlock *products;

	CGA_FLATTEN void run() const noexcept {
		for (size_t block = 0; block < block_count; ++block) {
			kernel::compose_block(first[block], second[block], products[block]);
		}
	}
};

// Its inputs are a matrix: images = linear * points + offset.
struct OneMotorManyPoints {
	float rows[ROW_FLOATS];
	const float *points;
	size_t count;
	float *images;

	CGA_FLATTEN void run() const noexcept {
		CGA_LANES_APART
		for (size_t i = 0; i < count; ++i) {
			const float x = points[POINT_FLOATS * i];
			const float y = points[POINT_FLOATS * i + 1];
			const float z = points[POINT_FLOATS * i + 2];
			images[POINT_FLOATS * i] = (rows[0] * x + rows[1] * y) + (rows[2] * z + rows[3]);
			images[POINT_FLOATS * i + 1] = (rows[4] * x + rows[5] * y) + (rows[6] * z + rows[7]);
			images[POINT_FLOATS * i + 2] = (rows[8] * x + rows[9] * y) + (rows[10] * z + rows[11]);
		}
	}
};

struct MotorAPoint {
	const MotorBlock *motors;
	const float *points;
	size_t count;
	float *images;

	// `rest` 1..8 points.
	CGA_FLATTEN void transform_some(size_t block, size_t rest) const noexcept {
		alignas(64) kernel::PointColumns columns = {};
		const float *source = points + block * BLOCK_LANES * POINT_FLOATS;
		for (size_t lane = 0; lane < rest; ++lane) {
			for (size_t axis = 0; axis < POINT_FLOATS; ++axis) {
				columns[axis][lane] = source[lane * POINT_FLOATS + axis];
			}
		}
		kernel::transform_block(motors[block], columns);
		float *destination = images + block * BLOCK_LANES * POINT_FLOATS;
		for (size_t lane = 0; lane < rest; ++lane) {
			for (size_t axis = 0; axis < POINT_FLOATS; ++axis) {
				destination[lane * POINT_FLOATS + axis] = columns[axis][lane];
			}
		}
	}

	CGA_FLATTEN void run() const noexcept {
		const size_t whole = count / BLOCK_LANES;
		for (size_t block = 0; block < whole; ++block) {
			transform_some(block, BLOCK_LANES);
		}
		if (const size_t rest = count % BLOCK_LANES; rest > 0) {
			transform_some(whole, rest);
		}
	}
};

struct Extraction {
	const MotorBlock *motors;

	CGA_FLATTEN void compute(size_t block, size_t, kernel::RowColumns &columns) const noexcept {
		kernel::extract_block(motors[block], columns);
	}
};

struct MotorsFromRows {
	MotorBlock *motors;

	CGA_FLATTEN void compute(size_t block, size_t, const kernel::RowColumns &columns) const noexcept {
		kernel::motors_from_columns(columns, motors[block]);
	}
};

} // namespace

MotorBlock::MotorBlock() noexcept {
	for (int lane = 0; lane < LANES; ++lane) {
		set(lane, Motor<float>());
	}
}

void MotorBlock::set(int lane, const Motor<float> &motor) noexcept {
	kernel::store_lane(a, lane, { motor.a.w, motor.a.x, motor.a.y, motor.a.z });
	kernel::store_lane(b, lane, { motor.b.w, motor.b.x, motor.b.y, motor.b.z });
	kernel::store_lane(v, lane, { motor.v.w, motor.v.x, motor.v.y, motor.v.z });
}

Motor<float> MotorBlock::get(int lane) const noexcept {
	const auto quaternion = [lane](const Row(&rows)[4]) {
		return Quaternion<float>(rows[0][lane], rows[1][lane], rows[2][lane], rows[3][lane]);
	};
	return { quaternion(a), quaternion(b), quaternion(v) };
}

void compose_blocks(const MotorBlock *first, const MotorBlock *second, size_t block_count, MotorBlock *products, InstructionSet set) noexcept {
	kernel::run_kernel(set, Composition{ first, second, block_count, products });
}

void transform_points(const Motor<float> &motor, const float *points, size_t count, float *images, InstructionSet set) noexcept {
	MotorBlock block;
	block.set(0, motor);
	OneMotorManyPoints transformation{ {}, points, count, images };
	extract_blocks(&block, 1, transformation.rows, InstructionSet::SCALAR);
	kernel::run_kernel(set, transformation);
}

void transform_points(const MotorBlock *motors, const float *points, size_t count, float *images, InstructionSet set) noexcept {
	kernel::run_kernel(set, MotorAPoint{ motors, points, count, images });
}

void extract_blocks(const MotorBlock *motors, size_t body_count, float *rows, InstructionSet set) noexcept {
	kernel::write_rows_of(set, Extraction{ motors }, body_count, rows);
}

void motors_from_rows(const float *rows, size_t body_count, MotorBlock *motors, InstructionSet set) noexcept {
	kernel::read_rows_into(set, MotorsFromRows{ motors }, body_count, rows);
}

} // namespace cga
