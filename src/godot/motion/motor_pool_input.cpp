#include "godot/motion/motor_pool.hpp"

#include "godot/algebra/conversions.hpp"
#include "godot/motion/row_split.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <atomic>
#include <limits>

// Where the poses come from: scripts, one by one or all at once. All or none: a fault changes no pose.

namespace ga_godot {

using godot::PackedFloat32Array;
using godot::Transform3D;
using godot::TypedArray;
using godot::Variant;
using godot::vformat;

static constexpr int64_t ROW_FLOATS = int64_t(cga::ROW_FLOATS);
// Setting a pose costs about eighty times what blending it does.
static constexpr uint32_t MIN_SHARED = 4096;

void MotorPool::put_end(End p_end, uint32_t p_row, const cga::Pose<float> &p_pose) {
	cga::PoseBlock &block = block_of(p_row);
	if (p_end == End::FROM) {
		block.set_from(lane_of(p_row), p_pose);
	} else {
		block.set_to(lane_of(p_row), p_pose);
	}
}

void MotorPool::set_end(End p_end, const char *p_method, int64_t p_index, const Transform3D &p_transform) {
	const Slot *slot = find_slot(p_index);
	if (slot == nullptr) {
		report_index(p_method, p_index);
		return;
	}
	cga::Pose<double> pose;
	const char *fault = pose_from_transform(p_transform, pose);
	ERR_FAIL_COND_MSG(fault != nullptr, vformat("MotorPool.%s: the transform for index %d %s.", p_method, p_index, fault));
	put_end(p_end, slot->row, cga::pose_cast<float>(pose));
}

// p_read(row) is a row's transform. First all are checked, then all are set.
template <class Read>
void MotorPool::put_end_all(End p_end, const char *p_method, const char *p_what, int64_t p_count, const Read &p_read) {
	ERR_FAIL_COND_MSG(p_count != get_count(), vformat("MotorPool.%s: %d %s for %d bodies; give one for each, in the order in which they were acquired.", p_method, p_count, p_what, get_count()));
	if (p_count == 0) {
		return;
	}
	_poses.resize(size_t(p_count));
	cga::Pose<float> *poses = _poses.data();
	constexpr uint32_t NONE = std::numeric_limits<uint32_t>::max();
	std::atomic<uint32_t> first_faulty = NONE;
	RowSplit::run(uint32_t(p_count), MIN_SHARED, [&](uint32_t p_first, uint32_t p_rows) {
		for (uint32_t row = p_first; row < p_first + p_rows; row++) {
			cga::Pose<double> pose;
			if (pose_from_transform(p_read(row), pose) != nullptr) {
				uint32_t known = first_faulty.load();
				while (row < known && !first_faulty.compare_exchange_weak(known, row)) {
				}
				return;
			}
			poses[row] = cga::pose_cast<float>(pose);
		}
	});
	const uint32_t faulty = first_faulty.load();
	if (faulty != NONE) {
		cga::Pose<double> pose;
		const char *fault = pose_from_transform(p_read(faulty), pose);
		ERR_FAIL_MSG(vformat("MotorPool.%s: the transform at index %d %s. No pose was changed.", p_method, int64_t(faulty), fault));
	}
	RowSplit::run(uint32_t(p_count), MIN_SHARED, [&](uint32_t p_first, uint32_t p_rows) {
		for (uint32_t row = p_first; row < p_first + p_rows; row++) {
			put_end(p_end, row, poses[row]);
		}
	});
}

void MotorPool::set_end_all(End p_end, const char *p_method, const TypedArray<Transform3D> &p_transforms) {
	close_gaps();
	const Variant *transforms = p_transforms.is_empty() ? nullptr : &p_transforms[0];
	put_end_all(p_end, p_method, "transforms", p_transforms.size(), [&](uint32_t p_row) { return Transform3D(transforms[p_row]); });
}

void MotorPool::set_end_buffer(End p_end, const char *p_method, const PackedFloat32Array &p_buffer) {
	close_gaps();
	const int64_t size = p_buffer.size();
	ERR_FAIL_COND_MSG(size % ROW_FLOATS != 0, vformat("MotorPool.%s: %d floats are no whole number of rows; give 12 for each body.", p_method, size));
	const float *rows = p_buffer.ptr();
	put_end_all(p_end, p_method, "rows", size / ROW_FLOATS, [&](uint32_t p_row) { return transform_from_row(rows + p_row * ROW_FLOATS); });
}

void MotorPool::set_from(int64_t p_index, const Transform3D &p_transform) {
	set_end(End::FROM, "set_from", p_index, p_transform);
}

void MotorPool::set_to(int64_t p_index, const Transform3D &p_transform) {
	set_end(End::TO, "set_to", p_index, p_transform);
}

void MotorPool::set_from_all(const TypedArray<Transform3D> &p_transforms) {
	set_end_all(End::FROM, "set_from_all", p_transforms);
}

void MotorPool::set_to_all(const TypedArray<Transform3D> &p_transforms) {
	set_end_all(End::TO, "set_to_all", p_transforms);
}

void MotorPool::set_from_buffer(const PackedFloat32Array &p_buffer) {
	set_end_buffer(End::FROM, "set_from_buffer", p_buffer);
}

void MotorPool::set_to_buffer(const PackedFloat32Array &p_buffer) {
	set_end_buffer(End::TO, "set_to_buffer", p_buffer);
}

void MotorPool::advance() {
	close_gaps();
	RowSplit::run(uint32_t(_slot_of_row.size()), MIN_SHARED, [&](uint32_t p_first, uint32_t p_rows) {
		for (uint32_t row = p_first; row < p_first + p_rows; row++) {
			put_end(End::FROM, row, block_of(row).get_to(lane_of(row)));
		}
	});
}

} // namespace ga_godot
