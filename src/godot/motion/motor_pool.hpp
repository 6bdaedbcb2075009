#pragma once

#include "cga/batch/pose_block.hpp"
#include "godot/algebra/multivector.hpp"
#include "godot/motion/multivector_lerp.hpp"
#include "godot/thread_guard.hpp"
#include "godot/weak_node.hpp"

#include <godot_cpp/classes/multi_mesh.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <cstdint>
#include <vector>

namespace ga_godot {

/// Interpolates the poses of many bodies together. Documented in doc_classes/MotorPool.xml.
///
/// The index that acquire() returns consists of a slot (low 32 bits) and the slot's generation. A slot stores the body's row.
/// Rows are dense and in the order of acquire(): row r is lane r % 8 of block r / 8 and floats 12 r .. 12 r + 11 of the
/// buffer. release() only marks the row as a gap; the next call that uses the order of rows closes all gaps.
class MotorPool : public godot::RefCounted, public OneThread<MotorPool> {
	GDCLASS(MotorPool, godot::RefCounted)

public:
	int64_t acquire();
	void release(int64_t index);
	void reserve(int64_t count);
	int64_t get_count() const;
	void clear();

	void set_from(int64_t index, const godot::Transform3D &transform) { set_end(End::FROM, "set_from", index, transform); }
	void set_to(int64_t index, const godot::Transform3D &transform) { set_end(End::TO, "set_to", index, transform); }
	void set_from_all(const godot::TypedArray<godot::Transform3D> &transforms) { set_end_all(End::FROM, "set_from_all", transforms); }
	void set_to_all(const godot::TypedArray<godot::Transform3D> &transforms) { set_end_all(End::TO, "set_to_all", transforms); }

	void set_from_buffer(const godot::PackedFloat32Array &buffer) { set_end_buffer(End::FROM, "set_from_buffer", buffer); }
	void set_to_buffer(const godot::PackedFloat32Array &buffer) { set_end_buffer(End::TO, "set_to_buffer", buffer); }
	void advance();

	void interpolate(double weight, MultivectorLerp::Mode mode);
	void interpolate_each(const godot::PackedFloat32Array &weights, MultivectorLerp::Mode mode);

	godot::Transform3D get_transform(int64_t index);
	godot::Ref<Multivector> get_motor(int64_t index);
	godot::PackedFloat32Array get_buffer();
	void apply_to_nodes(const godot::TypedArray<godot::Node3D> &nodes);
	void apply_to_multimesh(const godot::Ref<godot::MultiMesh> &multimesh, const godot::PackedFloat32Array &instance_data);

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

	/// Returns null and prints an error if acquire() has not returned the index or its body was released.
	const Slot *find_slot(const char *method, int64_t index) const;
	void free_slot(uint32_t slot);
	void close_gaps();
	cga::PoseBlock &block_of(uint32_t row) { return _blocks[row / cga::PoseBlock::LANES]; }
	static int lane_of(uint32_t row) { return int(row % cga::PoseBlock::LANES); }
	void put_end(End end, uint32_t row, const cga::Pose<float> &pose);
	template <class Read>
	void put_end_all(End end, const char *method, const char *elements, int64_t count, const Read &read);
	void set_end(End end, const char *method, int64_t index, const godot::Transform3D &transform);
	void set_end_all(End end, const char *method, const godot::TypedArray<godot::Transform3D> &transforms);
	void set_end_buffer(End end, const char *method, const godot::PackedFloat32Array &buffer);
	void interpolate_rows(const float *weights, float common_weight, MultivectorLerp::Mode mode);

	std::vector<cga::PoseBlock> _blocks;
	godot::PackedFloat32Array _buffer; // 12 floats per row
	godot::PackedFloat32Array _spare_buffer; // replaces _buffer when that is shared
	bool _is_shared = false; // a script or the engine may hold _buffer
	std::vector<uint32_t> _slot_of_row; // NO_ROW where the body was released
	std::vector<Slot> _slots;
	std::vector<uint32_t> _free_slots;
	uint32_t _gaps = 0;

	// Scratch memory, kept so that a frame allocates nothing.
	std::vector<cga::Pose<float>> _poses;
	std::vector<WeakNode<godot::Node3D>> _nodes; // by row, of the last apply_to_nodes(); all are watched by FreedNodes
	uint64_t _freed_nodes = 0; // FreedNodes::count() when all _nodes were alive
	godot::PackedFloat32Array _instances;
};

} // namespace ga_godot
