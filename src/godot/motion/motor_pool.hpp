#pragma once

#include "cga/batch/pose_block.hpp"
#include "godot/algebra/multivector.hpp"
#include "godot/motion/multivector_lerp.hpp"

#include <godot_cpp/classes/multi_mesh.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <cstdint>
#include <vector>

namespace ga_godot {

/// Poses of many bodies, interpolated together; doc_classes/MotorPool.xml documents it.
///
/// A body's index, as scripts see it, names a slot and the slot's generation; the slot knows the body's row. Rows are
/// dense and in the order in which bodies were acquired: row r is lane r % 8 of block r / 8 and floats 12 r .. 12 r + 11
/// of the buffer. Releasing marks the row; the rows behind it move up when the rows are next looked at, once for all
/// bodies released until then.
class MotorPool : public godot::RefCounted {
	GDCLASS(MotorPool, godot::RefCounted)

public:
	int64_t acquire();
	void release(int64_t p_index);
	void reserve(int64_t p_count);
	int64_t get_count() const;
	void clear();

	void set_from(int64_t p_index, const godot::Transform3D &p_transform);
	void set_to(int64_t p_index, const godot::Transform3D &p_transform);
	void set_from_all(const godot::TypedArray<godot::Transform3D> &p_transforms);
	void set_to_all(const godot::TypedArray<godot::Transform3D> &p_transforms);

	void set_from_buffer(const godot::PackedFloat32Array &p_buffer);
	void set_to_buffer(const godot::PackedFloat32Array &p_buffer);
	void advance();

	void interpolate(double p_weight, MultivectorLerp::Mode p_mode);
	void interpolate_each(const godot::PackedFloat32Array &p_weights, MultivectorLerp::Mode p_mode);

	godot::Transform3D get_transform(int64_t p_index);
	godot::Ref<Multivector> get_motor(int64_t p_index);
	godot::PackedFloat32Array get_buffer();
	void apply_to_nodes(const godot::TypedArray<godot::Node3D> &p_nodes);
	void apply_to_multimesh(const godot::Ref<godot::MultiMesh> &p_multimesh, const godot::PackedFloat32Array &p_instance_data);

protected:
	static void _bind_methods();

private:
	static constexpr uint32_t NO_ROW = 0xffffffffu;

	struct Slot {
		uint32_t generation = 0;
		uint32_t row = NO_ROW;
	};

	enum class End {
		FROM,
		TO,
	};

	Slot *find_slot(int64_t p_index);
	void report_index(const char *p_method, int64_t p_index) const;
	void close_gaps();
	cga::PoseBlock &block_of(uint32_t p_row) { return _blocks[p_row / cga::PoseBlock::LANES]; }
	static int lane_of(uint32_t p_row) { return int(p_row % cga::PoseBlock::LANES); }
	void put_end(End p_end, uint32_t p_row, const cga::Pose<float> &p_pose);
	template <class Read>
	void put_end_all(End p_end, const char *p_method, const char *p_what, int64_t p_count, const Read &p_read);
	void set_end(End p_end, const char *p_method, int64_t p_index, const godot::Transform3D &p_transform);
	void set_end_all(End p_end, const char *p_method, const godot::TypedArray<godot::Transform3D> &p_transforms);
	void set_end_buffer(End p_end, const char *p_method, const godot::PackedFloat32Array &p_buffer);
	godot::Node3D *find_node(const godot::Variant &p_node, int64_t p_row);
	void run(const float *p_weights, float p_weight, MultivectorLerp::Mode p_mode);

	std::vector<cga::PoseBlock> _blocks;
	godot::PackedFloat32Array _buffer; // 12 floats a row
	godot::PackedFloat32Array _spare_buffer; // the next one, where _buffer was given to somebody
	bool _is_shared = false;
	std::vector<uint32_t> _slot_of_row; // NO_ROW where the body was released
	std::vector<Slot> _slots;
	std::vector<uint32_t> _free_slots;
	uint32_t _gaps = 0;

	// Kept between calls so that a frame allocates nothing.
	std::vector<cga::Pose<float>> _poses;
	/// The node that was last given for a row: finding the C++ side of a node costs as much as moving it.
	struct KnownNode {
		uint64_t id = 0;
		godot::Node3D *node = nullptr;
	};
	std::vector<KnownNode> _nodes;
	godot::PackedFloat32Array _instances;
};

} // namespace ga_godot
