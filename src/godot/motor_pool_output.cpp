#include "godot/motor_pool.hpp"

#include "cga/motor/motor_multivector.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <algorithm>

// Where the interpolated poses go: scripts, nodes, multimeshes.

namespace ga_godot {

using godot::MultiMesh;
using godot::Node3D;
using godot::Object;
using godot::PackedFloat32Array;
using godot::Ref;
using godot::Transform3D;
using godot::TypedArray;
using godot::vformat;

static constexpr int64_t ROW_FLOATS = int64_t(cga::ROW_FLOATS);

static Transform3D transform_from_row(const float *p_row) {
	Transform3D transform;
	for (int i = 0; i < 3; i++) {
		transform.basis.rows[i] = godot::Vector3(p_row[4 * i], p_row[4 * i + 1], p_row[4 * i + 2]);
		transform.origin[i] = p_row[4 * i + 3];
	}
	return transform;
}

Transform3D MotorPool::get_transform(int64_t p_index) {
	const Slot *slot = find_slot(p_index);
	if (slot == nullptr) {
		report_index("get_transform", p_index);
		return Transform3D();
	}
	return transform_from_row(_buffer.ptr() + slot->row * ROW_FLOATS);
}

Ref<Multivector> MotorPool::get_motor(int64_t p_index) {
	const Slot *slot = find_slot(p_index);
	if (slot == nullptr) {
		report_index("get_motor", p_index);
		return Ref<Multivector>();
	}
	const cga::Pose<float> pose = cga::pose_from_row(_buffer.ptr() + slot->row * ROW_FLOATS);
	return Multivector::make(cga::to_multivector(cga::Motor<double>::from_pose(cga::pose_cast<double>(pose))));
}

PackedFloat32Array MotorPool::get_buffer() {
	close_gaps();
	return _buffer;
}

void MotorPool::apply_to_nodes(const TypedArray<Node3D> &p_nodes) {
	close_gaps();
	const int64_t count = p_nodes.size();
	ERR_FAIL_COND_MSG(count != get_count(), vformat("MotorPool.apply_to_nodes: %d nodes for %d bodies; give one for each, in the order in which they were acquired.", count, get_count()));
	_nodes.resize(size_t(count));
	for (int64_t i = 0; i < count; i++) {
		// get_validated_object, because the array may hold a freed node.
		Node3D *node = Object::cast_to<Node3D>(p_nodes[i].get_validated_object());
		ERR_FAIL_NULL_MSG(node, vformat("MotorPool.apply_to_nodes: the node at index %d is null or was freed. No node was moved.", i));
		_nodes[size_t(i)] = node;
	}
	const float *row = _buffer.ptr();
	for (Node3D *node : _nodes) {
		node->set_transform(transform_from_row(row));
		row += ROW_FLOATS;
	}
}

void MotorPool::apply_to_multimesh(const Ref<MultiMesh> &p_multimesh) {
	close_gaps();
	ERR_FAIL_COND_MSG(p_multimesh.is_null(), "MotorPool.apply_to_multimesh: the multimesh is null.");
	ERR_FAIL_COND_MSG(p_multimesh->get_transform_format() != MultiMesh::TRANSFORM_3D, "MotorPool.apply_to_multimesh: set the multimesh's transform_format to TRANSFORM_3D (before its instance_count).");
	const int64_t instances = p_multimesh->get_instance_count();
	ERR_FAIL_COND_MSG(instances < get_count(), vformat("MotorPool.apply_to_multimesh: %d instances cannot show %d bodies; set instance_count to at least that.", instances, get_count()));
	const bool is_plain = !p_multimesh->is_using_colors() && !p_multimesh->is_using_custom_data();
	if (instances == 0) {
		return;
	}
	if (is_plain && instances == get_count()) {
		p_multimesh->set_buffer(_buffer);
		return;
	}
	// Colors, custom data and surplus instances: their floats stay or, for transforms of surplus instances, are zero,
	// which shows nothing.
	const int64_t stride = ROW_FLOATS + 4 * int64_t(p_multimesh->is_using_colors()) + 4 * int64_t(p_multimesh->is_using_custom_data());
	PackedFloat32Array colored = is_plain ? PackedFloat32Array() : p_multimesh->get_buffer();
	PackedFloat32Array &buffer = is_plain ? _instances : colored;
	// Without a display the engine keeps no buffer to read back.
	buffer.resize(instances * stride);
	float *instance = buffer.ptrw();
	const float *row = _buffer.ptr();
	for (int64_t i = 0; i < instances; i++, instance += stride) {
		if (i < get_count()) {
			std::copy_n(row + i * ROW_FLOATS, ROW_FLOATS, instance);
		} else {
			std::fill_n(instance, ROW_FLOATS, 0.0f);
		}
	}
	p_multimesh->set_buffer(buffer);
}

} // namespace ga_godot
