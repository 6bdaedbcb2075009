#include "net/stream/stream_decoder.hpp"

#include <algorithm>

namespace net {

namespace {

constexpr int NEVER = MOST_TICKS + 1;

} // namespace

StreamDecoder::StreamDecoder(float position_tolerance, float rotation_tolerance, std::size_t most_bodies) :
		grid_(position_tolerance, rotation_tolerance), most_bodies_(most_bodies) {}

bool StreamDecoder::read_state(const std::uint8_t *bytes, std::size_t size) {
	RangeDecoder coder(bytes, size);
	StateCoder<RangeDecoder> state_coder(coder);
	std::uint32_t ticks = 0;
	std::uint32_t check = 0;
	std::uint32_t count = 0;
	coder.bits(ticks, 7);
	coder.bits(check, 32);
	new_models_ = MotionModels();
	code_models(coder, new_models_);
	coder.bits(count, INDEX_BITS);
	// Even a body at rest takes some bytes: a short state cannot make us hold many.
	if (ticks > MOST_TICKS || count > most_bodies_ || count > size) {
		return false;
	}
	new_bodies_.clear();
	for (std::uint32_t i = 0; i < count; ++i) {
		Body body;
		coder.bits(body.id, 31);
		body.state.visit(state_coder);
		body.until = NEVER;
		if (!body.state.is_valid()) {
			return false;
		}
		new_bodies_.push_back(body);
	}
	std::swap(models_, new_models_);
	bodies_.swap(new_bodies_);
	last_ticks_ = int(ticks);
	check_ = check;
	return true;
}

bool StreamDecoder::decode_window(const std::uint8_t *bytes, std::size_t size, std::uint8_t check, std::uint8_t check_mask, double begin, cga::Mode mode, std::vector<BodyMotion> &motions, int &ticks) {
	motions.clear();
	new_models_ = models_;
	new_bodies_ = bodies_;
	RangeDecoder coder(bytes, size);
	bool same_length = true;
	coder.bit(new_models_.same_length, same_length);
	ticks = last_ticks_;
	if (!same_length) {
		std::uint32_t less_one = 0;
		coder.bits(less_one, 6);
		ticks = int(less_one) + 1;
	}
	if (ticks < 1 || ticks > MOST_TICKS || !decode_changes(coder, ticks)) {
		motions.clear();
		return false;
	}
	bool neighbour_active = false;
	std::uint32_t new_check = check_;
	for (Body &body : new_bodies_) {
		if (!decode_motion(coder, body, begin, ticks, mode, neighbour_active, motions)) {
			motions.clear();
			return false;
		}
		new_check = (new_check ^ body.state.hash()) * 0x01000193u;
	}
	if (((check_bits(new_check) ^ check) & check_mask) != 0) {
		motions.clear();
		return false;
	}
	new_bodies_.erase(std::remove_if(new_bodies_.begin(), new_bodies_.end(), [](const Body &body) { return body.until != NEVER; }), new_bodies_.end());
	std::swap(models_, new_models_);
	bodies_.swap(new_bodies_);
	check_ = new_check;
	last_ticks_ = ticks;
	return true;
}

bool StreamDecoder::decode_changes(RangeDecoder &coder, int ticks) {
	bool has_events = false;
	coder.bit(new_models_.has_events, has_events);
	if (!has_events) {
		return true;
	}
	StateCoder<RangeDecoder> state_coder(coder);
	while (true) {
		std::uint32_t more = 0;
		coder.bits(more, 1);
		if (more == 0) {
			return true;
		}
		std::uint32_t change = 0;
		std::uint32_t tick = 0;
		coder.bits(change, 2);
		coder.bits(tick, 7);
		if (int(tick) > ticks) {
			return false;
		}
		if (change == std::uint32_t(BodyChange::ADDED)) {
			Body body;
			coder.bits(body.id, 31);
			body.reached.visit(state_coder);
			body.state = body.reached;
			body.from = int(tick);
			body.until = NEVER;
			if (!body.state.is_valid() || body.state.active || new_bodies_.size() >= most_bodies_) {
				return false;
			}
			body.change = Change::APPEARS;
			new_bodies_.push_back(body);
			continue;
		}
		std::int32_t index = 0;
		state_coder(index, INDEX_BITS);
		if (index < 0 || std::size_t(index) >= new_bodies_.size() || new_bodies_[std::size_t(index)].until != NEVER) {
			return false;
		}
		Body &body = new_bodies_[std::size_t(index)];
		if (change == std::uint32_t(BodyChange::REMOVED)) {
			body.until = int(tick);
			continue;
		}
		body.reached.visit(state_coder);
		body.from = int(tick);
		body.change = Change::JUMPS;
		if (change != std::uint32_t(BodyChange::JUMPED) || !body.reached.is_valid() || body.reached.active) {
			return false;
		}
	}
}

bool StreamDecoder::decode_motion(RangeDecoder &coder, Body &body, double begin, int ticks, cga::Mode mode, bool &neighbour_active, std::vector<BodyMotion> &motions) {
	const int last = std::min(body.until, ticks);
	const int at = std::min(body.from, last);
	if (body.change == Change::JUMPS) {
		if (!decode_span(coder, body, begin, at, mode, neighbour_active, motions)) {
			return false;
		}
		body.state = body.reached;
	}
	if (body.change != Change::NONE) {
		BodyMotion motion;
		motion.id = body.id;
		motion.appears = true;
		motion.segment.begin = begin + at;
		motion.segment.from = body.state.pose(grid_);
		motions.push_back(motion);
		body.change = Change::NONE;
		body.from = 0;
	}
	if (!decode_span(coder, body, begin + at, last - at, mode, neighbour_active, motions)) {
		return false;
	}
	if (body.until != NEVER) {
		BodyMotion motion;
		motion.id = body.id;
		motion.vanishes = true;
		motion.segment.begin = begin + last;
		motions.push_back(motion);
	}
	return true;
}

bool StreamDecoder::decode_span(RangeDecoder &coder, Body &body, double begin, int ticks, cga::Mode mode, bool &neighbour_active, std::vector<BodyMotion> &motions) {
	if (ticks <= 0) {
		return true;
	}
	motion_.active = false;
	motion_.count = 0;
	const bool read = code_motion(coder, new_models_, body.state, grid_, begin, ticks, neighbour_active, motion_, [&](const BodyState &state, const SegmentCode &code, const SegmentSteps &steps, double from) {
		BodyMotion motion;
		motion.id = body.id;
		motion.segment = state.segment(code, steps, grid_, from, mode);
		motions.push_back(motion);
	});
	neighbour_active = motion_.active;
	return read;
}

} // namespace net
