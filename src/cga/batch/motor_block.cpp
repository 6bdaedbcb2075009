#include "cga/batch/motor_block.hpp"

#include "cga/batch/lane_access.hpp"

namespace cga {

MotorBlock::MotorBlock() noexcept {
	for (int lane = 0; lane < LANES; ++lane) {
		set(lane, Motor<float>());
	}
}

void MotorBlock::set(int lane, const Motor<float> &motor) noexcept {
	store_lane(a, lane, motor.a);
	store_lane(b, lane, motor.b);
	store_lane(v, lane, motor.v);
}

Motor<float> MotorBlock::get(int lane) const noexcept {
	return { load_lane(a, lane), load_lane(b, lane), load_lane(v, lane) };
}

} // namespace cga
