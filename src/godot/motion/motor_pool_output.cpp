#include "godot/motion/motor_pool.hpp"

#include "cga/motor/motor_multivector.hpp"
#include "godot/algebra/conversions.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/godot.hpp>
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
using godot::Variant;
using godot::vformat;

static constexpr int64_t ROW_FLOATS = int64_t(cga::ROW_FLOATS);

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
	_is_shared = true;
	return _buffer;
}

// get_validated_object's work, for a node that is not the one this row had: the array may hold a freed node.
Node3D *MotorPool::find_node(const Variant &p_node, int64_t p_row) {
	Node3D *node = Object::cast_to<Node3D>(p_node.get_validated_object());
	_nodes[size_t(p_row)] = { node != nullptr ? node->get_instance_id() : 0, node };
	return node;
}

void MotorPool::apply_to_nodes(const TypedArray<Node3D> &p_nodes) {
	namespace interface = godot::gdextension_interface;
	close_gaps();
	const int64_t count = p_nodes.size();
	ERR_FAIL_COND_MSG(count != get_count(), vformat("MotorPool.apply_to_nodes: %d nodes for %d bodies; give one for each, in the order in which they were acquired.", count, get_count()));
	if (count == 0) {
		return;
	}
	_nodes.resize(size_t(count));
	const Variant *nodes = &p_nodes[0];
	for (int64_t i = 0; i < count; i++) {
		const uint64_t id = interface::variant_get_object_instance_id(nodes[i]._native_ptr());
		const KnownNode &known = _nodes[size_t(i)];
		const bool is_known = id != 0 && id == known.id && interface::object_get_instance_from_id(id) != nullptr;
		ERR_FAIL_COND_MSG(!is_known && find_node(nodes[i], i) == nullptr, vformat("MotorPool.apply_to_nodes: the node at index %d is null or was freed. No node was moved.", i));
	}
	const float *row = _buffer.ptr();
	for (const KnownNode &known : _nodes) {
		known.node->set_transform(transform_from_row(row));
		row += ROW_FLOATS;
	}
}

void MotorPool::apply_to_multimesh(const Ref<MultiMesh> &p_multimesh, const PackedFloat32Array &p_instance_data) {
	close_gaps();
	ERR_FAIL_COND_MSG(p_multimesh.is_null(), "MotorPool.apply_to_multimesh: the multimesh is null.");
	ERR_FAIL_COND_MSG(p_multimesh->get_transform_format() != MultiMesh::TRANSFORM_3D, "MotorPool.apply_to_multimesh: set the multimesh's transform_format to TRANSFORM_3D (before its instance_count).");
	const int64_t instances = p_multimesh->get_instance_count();
	const int64_t count = get_count();
	ERR_FAIL_COND_MSG(instances < count, vformat("MotorPool.apply_to_multimesh: %d instances cannot show %d bodies; set instance_count to at least that.", instances, count));
	const int64_t extra = 4 * int64_t(p_multimesh->is_using_colors()) + 4 * int64_t(p_multimesh->is_using_custom_data());
	const int64_t given = p_instance_data.size();
	ERR_FAIL_COND_MSG(given != 0 && given != instances * extra, vformat("MotorPool.apply_to_multimesh: %d floats of instance data for %d instances with %d each (4 for a color, 4 for custom data).", given, instances, extra));
	if (instances == 0) {
		return;
	}
	if (extra == 0 && instances == count) {
		_is_shared = true;
		p_multimesh->set_buffer(_buffer);
		return;
	}
	// Surplus instances get transforms of zero, which show nothing. Colors and custom data are those that were given, else
	// those the multimesh has; without a display the engine keeps no buffer to read back.
	const int64_t stride = ROW_FLOATS + extra;
	const bool reads_back = extra != 0 && given == 0;
	PackedFloat32Array old = reads_back ? p_multimesh->get_buffer() : PackedFloat32Array();
	PackedFloat32Array &buffer = reads_back ? old : _instances;
	buffer.resize(instances * stride);
	float *instance = buffer.ptrw();
	const float *row = _buffer.ptr();
	const float *data = p_instance_data.ptr();
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
	p_multimesh->set_buffer(buffer);
}

} // namespace ga_godot
