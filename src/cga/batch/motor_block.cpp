#include "cga/batch/motor_block.hpp"

#include "cga/batch/lane_access.hpp"

namespace cga {

MotorBlock::MotorBlock() noexcept {
	for (int lane = 0; lane < LANES; ++lane) {
		set(lane, Motor<float>());
	}
}

void MotorBlock::set(int lane, const Motor<float> &motor) noexcept {
	kernel::store_lane(a, lane, motor.a);
	kernel::store_lane(b, lane, motor.b);
	kernel::store_lane(v, lane, motor.v);
}

Motor<float> MotorBlock::get(int lane) const noexcept {
	using kernel::load_lane;
	return { load_lane<Quaternion<float>>(a, lane), load_lane<Quaternion<float>>(b, lane), load_lane<Quaternion<float>>(v, lane) };
}

} // namespace cga
