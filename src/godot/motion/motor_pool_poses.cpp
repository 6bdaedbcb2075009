#include "godot/motion/motor_pool.hpp"

#include "cga/motor/motor_multivector.hpp"
#include "godot/algebra/conversions.hpp"
#include "godot/motion/freed_nodes.hpp"
#include "godot/motion/row_split.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/godot.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

// Reads poses into the pool and writes results to single bodies, arrays, buffers, nodes and multimeshes.

namespace ga_godot {

using godot::MultiMesh;
using godot::Node3D;
using godot::Object;
using godot::PackedFloat32Array;
using godot::Ref;
using godot::Transform3D;
using godot::TypedArray;
using godot::Variant;
using godot::vformat;

static constexpr int64_t ROW_FLOATS = int64_t(cga::ROW_FLOATS);
// Converting a transform takes about 80 times as long as interpolating a pose, so threading pays off with fewer rows.
static constexpr uint32_t MIN_SHARED = 4096;

void MotorPool::put_end(End end, uint32_t row, const cga::Pose<float> &pose) {
	cga::PoseBlock &block = block_of(row);
	if (end == End::FROM) {
		block.set_from(lane_of(row), pose);
	} else {
		block.set_to(lane_of(row), pose);
	}
}

void MotorPool::set_end(End end, const char *method, int64_t index, const Transform3D &transform) {
	const Slot *slot = find_slot(method, index);
	if (slot == nullptr) {
		return;
	}
	const PoseResult pose = pose_from_transform(transform);
	ERR_FAIL_COND_MSG(!pose, vformat("MotorPool.%s: the transform for index %d %s.", method, index, cga::describe(pose.error())));
	put_end(end, slot->row, cga::pose_cast<float>(*pose));
}

// read(row) returns the transform of a row. Checks all transforms first, so that an error changes no pose.
template <class Read>
void MotorPool::put_end_all(End end, const char *method, const char *elements, int64_t count, const Read &read) {
	ERR_FAIL_COND_MSG(count != get_count(), vformat("MotorPool.%s: got %d %s for %d bodies; pass one per body, in the order of acquire().", method, count, elements, get_count()));
	if (count == 0) {
		return;
	}
	_poses.resize(size_t(count));
	cga::Pose<float> *poses = _poses.data();
	constexpr uint32_t NONE = std::numeric_limits<uint32_t>::max();
	std::atomic<uint32_t> first_invalid = NONE;
	RowSplit::run(uint32_t(count), MIN_SHARED, [&](uint32_t first, uint32_t rows) {
		for (uint32_t row = first; row < first + rows; row++) {
			const PoseResult pose = pose_from_transform(read(row));
			if (!pose) {
				uint32_t known = first_invalid.load();
				while (row < known && !first_invalid.compare_exchange_weak(known, row)) {
				}
				return;
			}
			poses[row] = cga::pose_cast<float>(*pose);
		}
	});
	const uint32_t invalid = first_invalid.load();
	if (invalid != NONE) {
		const cga::MatrixError error = pose_from_transform(read(invalid)).error();
		ERR_FAIL_MSG(vformat("MotorPool.%s: the transform at index %d %s. No pose was changed.", method, int64_t(invalid), cga::describe(error)));
	}
	RowSplit::run(uint32_t(count), MIN_SHARED, [&](uint32_t first, uint32_t rows) {
		for (uint32_t row = first; row < first + rows; row++) {
			put_end(end, row, poses[row]);
		}
	});
}

void MotorPool::set_end_all(End end, const char *method, const TypedArray<Transform3D> &transforms) {
	close_gaps();
	const Variant *elements = transforms.is_empty() ? nullptr : &transforms[0];
	put_end_all(end, method, "transforms", transforms.size(), [&](uint32_t row) { return Transform3D(elements[row]); });
}

void MotorPool::set_end_buffer(End end, const char *method, const PackedFloat32Array &buffer) {
	close_gaps();
	const int64_t size = buffer.size();
	ERR_FAIL_COND_MSG(size % ROW_FLOATS != 0, vformat("MotorPool.%s: the buffer has %d floats, which is not a multiple of 12; pass 12 floats per body.", method, size));
	const float *rows = buffer.ptr();
	put_end_all(end, method, "rows", size / ROW_FLOATS, [&](uint32_t row) { return transform_from_row(rows + row * ROW_FLOATS); });
}

void MotorPool::advance() {
	close_gaps();
	RowSplit::run(uint32_t(_slot_of_row.size()), MIN_SHARED, [&](uint32_t first, uint32_t rows) {
		for (uint32_t row = first; row < first + rows; row++) {
			put_end(End::FROM, row, block_of(row).get_to(lane_of(row)));
		}
	});
}

Transform3D MotorPool::get_transform(int64_t index) {
	const Slot *slot = find_slot("get_transform", index);
	if (slot == nullptr) {
		return Transform3D();
	}
	return transform_from_row(_buffer.ptr() + slot->row * ROW_FLOATS);
}

Ref<Multivector> MotorPool::get_motor(int64_t index) {
	const Slot *slot = find_slot("get_motor", index);
	if (slot == nullptr) {
		return Ref<Multivector>();
	}
	const cga::Pose<float> pose = cga::pose_from_row(_buffer.ptr() + slot->row * ROW_FLOATS);
	return Multivector::make(cga::to_multivector(cga::Motor<double>::from_pose(cga::pose_cast<double>(pose))));
}

PackedFloat32Array MotorPool::get_buffer() {
	close_gaps();
	_is_shared = true;
	return _buffer;
}

void MotorPool::apply_to_nodes(const TypedArray<Node3D> &nodes) {
	// Moving a node runs callbacks, which may free nodes, change this pool, call this method again or release the pool.
	const Ref<MotorPool> self(this);
	close_gaps();
	const int64_t count = nodes.size();
	ERR_FAIL_COND_MSG(count != get_count(), vformat("MotorPool.apply_to_nodes: got %d nodes for %d bodies; pass one per body, in the order of acquire().", count, get_count()));
	if (count == 0) {
		return;
	}
	const uint64_t freed = FreedNodes::count();
	const bool are_alive = freed == _freed_nodes;
	_nodes.resize(size_t(count));
	const Variant *elements = &nodes[0];
	for (int64_t i = 0; i < count; i++) {
		WeakNode<Node3D> &node = _nodes[size_t(i)];
		bool is_alive = node.id() != 0 && node.id() == godot::gdextension_interface::variant_get_object_instance_id(elements[i]._native_ptr());
		if (!is_alive) {
			node = WeakNode<Node3D>(Object::cast_to<Node3D>(elements[i].get_validated_object()));
			is_alive = node.id() != 0;
			FreedNodes::watch(node.id());
		} else if (!are_alive) {
			is_alive = node.get() != nullptr;
		}
		ERR_FAIL_COND_MSG(!is_alive, vformat("MotorPool.apply_to_nodes: the node at index %d is null or freed. No node was moved.", i));
	}
	std::vector<WeakNode<Node3D>> moved = std::exchange(_nodes, {});
	const PackedFloat32Array buffer = _buffer;
	const float *row = buffer.ptr();
	for (const WeakNode<Node3D> &weak : moved) {
		if (Node3D *node = FreedNodes::count() == freed ? weak.known() : weak.get()) {
			node->set_transform(transform_from_row(row));
		}
		row += ROW_FLOATS;
	}
	moved.swap(_nodes);
	_freed_nodes = freed;
}

void MotorPool::apply_to_multimesh(const Ref<MultiMesh> &multimesh, const PackedFloat32Array &instance_data) {
	const Ref<MotorPool> self(this);
	close_gaps();
	ERR_FAIL_COND_MSG(multimesh.is_null(), "MotorPool.apply_to_multimesh: the multimesh is null.");
	ERR_FAIL_COND_MSG(multimesh->get_transform_format() != MultiMesh::TRANSFORM_3D, "MotorPool.apply_to_multimesh: set the multimesh's transform_format to TRANSFORM_3D, before its instance_count.");
	const int64_t instances = multimesh->get_instance_count();
	const int64_t count = get_count();
	ERR_FAIL_COND_MSG(instances < count, vformat("MotorPool.apply_to_multimesh: instance_count is %d, less than the %d bodies; set it to at least that number.", instances, count));
	const int64_t extra = 4 * int64_t(multimesh->is_using_colors()) + 4 * int64_t(multimesh->is_using_custom_data());
	const int64_t given = instance_data.size();
	ERR_FAIL_COND_MSG(given != 0 && given != instances * extra, vformat("MotorPool.apply_to_multimesh: instance_data has %d floats, but %d instances with %d floats each (4 for color, 4 for custom data) need %d.", given, instances, extra, instances * extra));
	if (instances == 0) {
		return;
	}
	if (extra == 0 && instances == count) {
		_is_shared = true;
		const PackedFloat32Array shared = _buffer;
		multimesh->set_buffer(shared);
		return;
	}
	// Surplus instances get zero transforms, which draw nothing. Without instance_data, colors and custom data are read back
	// from the multimesh; a headless engine has no such buffer.
	const int64_t stride = ROW_FLOATS + extra;
	const bool reads_back = extra != 0 && given == 0;
	const PackedFloat32Array rows = _buffer;
	PackedFloat32Array buffer = reads_back ? multimesh->get_buffer() : std::exchange(_instances, PackedFloat32Array());
	buffer.resize(instances * stride);
	float *instance = buffer.ptrw();
	const float *row = rows.ptr();
	const float *data = instance_data.ptr();
	for (int64_t i = 0; i < instances; i++, instance += stride) {
		if (i < count) {
			std::copy_n(row + i * ROW_FLOATS, ROW_FLOATS, instance);
		} else {
			std::fill_n(instance, ROW_FLOATS, 0.0f);
		}
		if (data != nullptr) {
			std::copy_n(data + i * extra, extra, instance + ROW_FLOATS);
		}
	}
	multimesh->set_buffer(buffer);
	if (!reads_back) {
		_instances = buffer;
	}
}

} // namespace ga_godot
