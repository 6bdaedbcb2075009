#include "godot/motion/motor_pool.hpp"

#include "godot/algebra/conversions.hpp"
#include "godot/motion/row_split.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ga_godot {

using cga::PoseBlock;
using godot::PackedFloat32Array;
using godot::vformat;

static constexpr const char *INVALID_MODE = "MotorPool.%s: mode %d is invalid; use MultivectorLerp.LINEAR (0), SCREW (1) or SEPARATE (2).";
static constexpr int64_t ROW_FLOATS = int64_t(cga::ROW_FLOATS);
static constexpr int64_t MAX_COUNT = int64_t(1) << 24; // 4 GiB of blocks
static constexpr uint32_t GENERATION_MASK = 0x7fffffffu; // keeps indices positive

static_assert(RowSplit::ROWS_PER_PIECE % PoseBlock::LANES == 0, "Two threads must not write to the same block.");

int64_t MotorPool::acquire() {
	close_gaps();
	const uint32_t row = uint32_t(_slot_of_row.size());
	ERR_FAIL_COND_V_MSG(int64_t(row) >= MAX_COUNT, -1, vformat("MotorPool.acquire: the pool is full; it holds at most %d bodies.", MAX_COUNT));
	uint32_t slot = uint32_t(_slots.size());
	if (_free_slots.empty()) {
		_slots.emplace_back();
	} else {
		slot = _free_slots.back();
		_free_slots.pop_back();
	}
	_slots[slot].row = row;
	_slot_of_row.push_back(slot);
	_blocks.resize(cga::block_count(_slot_of_row.size()));
	block_of(row).set(lane_of(row), cga::Pose<float>(), cga::Pose<float>());
	_buffer.resize((int64_t(row) + 1) * ROW_FLOATS);
	cga::pose_to_row(cga::Pose<float>(), _buffer.ptrw() + row * ROW_FLOATS);
	return int64_t(_slots[slot].generation) << 32 | int64_t(slot);
}

void MotorPool::release(int64_t index) {
	if (const Slot *slot = find_slot("release", index)) {
		_slot_of_row[slot->row] = NO_ROW;
		_gaps++;
		free_slot(uint32_t(index));
	}
}

void MotorPool::free_slot(uint32_t slot) {
	_slots[slot].row = NO_ROW;
	_slots[slot].generation = (_slots[slot].generation + 1) & GENERATION_MASK;
	_free_slots.push_back(slot);
}

void MotorPool::reserve(int64_t count) {
	ERR_FAIL_COND_MSG(count < 0 || count > MAX_COUNT, vformat("MotorPool.reserve: count %d is not in 0..%d.", count, MAX_COUNT));
	_blocks.reserve(cga::block_count(size_t(count)));
	_slots.reserve(size_t(count));
	_slot_of_row.reserve(size_t(count));
	_poses.reserve(size_t(count));
	_nodes.reserve(size_t(count));
}

int64_t MotorPool::get_count() const {
	return int64_t(_slot_of_row.size()) - int64_t(_gaps);
}

void MotorPool::clear() {
	for (uint32_t slot : _slot_of_row) {
		if (slot != NO_ROW) {
			free_slot(slot);
		}
	}
	_slot_of_row.clear();
	_blocks.clear();
	_buffer.resize(0);
	_gaps = 0;
}

const MotorPool::Slot *MotorPool::find_slot(const char *method, int64_t index) const {
	const uint64_t slot = uint64_t(index) & 0xffffffffu;
	const bool is_live = index >= 0 && slot < _slots.size() && _slots[slot].row != NO_ROW && _slots[slot].generation == uint64_t(index) >> 32;
	ERR_FAIL_COND_V_MSG(!is_live, nullptr, vformat("MotorPool.%s: index %d is not a live index returned by acquire().", method, index));
	return &_slots[slot];
}

void MotorPool::close_gaps() {
	if (_gaps == 0) {
		return;
	}
	uint32_t destination = 0;
	float *rows = _buffer.ptrw();
	for (uint32_t source = 0; source < _slot_of_row.size(); source++) {
		const uint32_t slot = _slot_of_row[source];
		if (slot == NO_ROW) {
			continue;
		}
		if (source != destination) {
			const PoseBlock &block = block_of(source);
			const cga::Pose<float> from = block.get_from(lane_of(source));
			block_of(destination).set(lane_of(destination), from, block.get_to(lane_of(source)));
			std::copy_n(rows + source * ROW_FLOATS, ROW_FLOATS, rows + destination * ROW_FLOATS);
			_slot_of_row[destination] = slot;
			_slots[slot].row = destination;
		}
		destination++;
	}
	_slot_of_row.resize(destination);
	_blocks.resize(cga::block_count(destination));
	_buffer.resize(int64_t(destination) * ROW_FLOATS);
	_gaps = 0;
}

void MotorPool::interpolate_rows(const float *weights, float common_weight, MultivectorLerp::Mode mode) {
	// With fewer rows, the calling thread finishes before the worker threads start; see docs/performance/engine.md.
	constexpr uint32_t MIN_SHARED = 65536;
	if (_slot_of_row.empty()) {
		return;
	}
	// Writing to a packed array that the engine or a script also holds would trigger copy-on-write in each frame.
	if (_is_shared) {
		std::swap(_buffer, _spare_buffer);
		_buffer.resize(int64_t(_slot_of_row.size()) * ROW_FLOATS);
		_is_shared = false;
	}
	const PoseBlock *blocks = _blocks.data();
	float *rows = _buffer.ptrw();
	RowSplit::run(uint32_t(_slot_of_row.size()), MIN_SHARED, [&](uint32_t first, uint32_t count) {
		const float *own_weights = weights != nullptr ? weights + first : nullptr;
		cga::interpolate_blocks(blocks + first / PoseBlock::LANES, count, own_weights, common_weight, cga::Mode(mode), rows + first * cga::ROW_FLOATS);
	});
}

void MotorPool::interpolate(double weight, MultivectorLerp::Mode mode) {
	ERR_FAIL_COND_MSG(!std::isfinite(float(weight)), "MotorPool.interpolate: the weight is not finite.");
	ERR_FAIL_COND_MSG(!is_mode(mode), vformat(INVALID_MODE, "interpolate", int64_t(mode)));
	close_gaps();
	interpolate_rows(nullptr, float(weight), mode);
}

void MotorPool::interpolate_each(const PackedFloat32Array &weights, MultivectorLerp::Mode mode) {
	ERR_FAIL_COND_MSG(!is_mode(mode), vformat(INVALID_MODE, "interpolate_each", int64_t(mode)));
	close_gaps();
	const int64_t count = weights.size();
	ERR_FAIL_COND_MSG(count != get_count(), vformat("MotorPool.interpolate_each: got %d weights for %d bodies; pass one per body, in the order of acquire().", count, get_count()));
	const float *values = count > 0 ? weights.ptr() : nullptr;
	for (int64_t i = 0; i < count; i++) {
		ERR_FAIL_COND_MSG(!std::isfinite(values[i]), vformat("MotorPool.interpolate_each: the weight at index %d is not finite. No pose was changed.", i));
	}
	interpolate_rows(values, 0.0f, mode);
}

void MotorPool::_bind_methods() {
	using godot::ClassDB;
	using godot::D_METHOD;

	ClassDB::bind_method(D_METHOD("acquire"), guarded<&MotorPool::acquire, -1>());
	ClassDB::bind_method(D_METHOD("release", "index"), guarded<&MotorPool::release>());
	ClassDB::bind_method(D_METHOD("reserve", "count"), guarded<&MotorPool::reserve>());
	ClassDB::bind_method(D_METHOD("get_count"), guarded<&MotorPool::get_count>());
	ClassDB::bind_method(D_METHOD("clear"), guarded<&MotorPool::clear>());
	ClassDB::bind_method(D_METHOD("set_from", "index", "transform"), guarded<&MotorPool::set_from>());
	ClassDB::bind_method(D_METHOD("set_to", "index", "transform"), guarded<&MotorPool::set_to>());
	ClassDB::bind_method(D_METHOD("set_from_all", "transforms"), guarded<&MotorPool::set_from_all>());
	ClassDB::bind_method(D_METHOD("set_to_all", "transforms"), guarded<&MotorPool::set_to_all>());
	ClassDB::bind_method(D_METHOD("set_from_buffer", "buffer"), guarded<&MotorPool::set_from_buffer>());
	ClassDB::bind_method(D_METHOD("set_to_buffer", "buffer"), guarded<&MotorPool::set_to_buffer>());
	ClassDB::bind_method(D_METHOD("advance"), guarded<&MotorPool::advance>());
	ClassDB::bind_method(D_METHOD("interpolate", "weight", "mode"), guarded<&MotorPool::interpolate>());
	ClassDB::bind_method(D_METHOD("interpolate_each", "weights", "mode"), guarded<&MotorPool::interpolate_each>());
	ClassDB::bind_method(D_METHOD("get_transform", "index"), guarded<&MotorPool::get_transform>());
	ClassDB::bind_method(D_METHOD("get_motor", "index"), guarded<&MotorPool::get_motor>());
	ClassDB::bind_method(D_METHOD("get_buffer"), guarded<&MotorPool::get_buffer>());
	ClassDB::bind_method(D_METHOD("apply_to_nodes", "nodes"), guarded<&MotorPool::apply_to_nodes>());
	ClassDB::bind_method(D_METHOD("apply_to_multimesh", "multimesh", "instance_data"), guarded<&MotorPool::apply_to_multimesh>(), DEFVAL(PackedFloat32Array()));
}

} // namespace ga_godot
