#include "net/stream/stream_decoder.hpp"

#include <algorithm>

namespace net {

StreamDecoder::StreamDecoder(float position_tolerance, float rotation_tolerance, size_t max_bodies) :
		_grid(position_tolerance, rotation_tolerance), _max_bodies(max_bodies) {}

PacketResult StreamDecoder::read_snapshot(const uint8_t *bytes, size_t size) {
	RangeDecoder coder(bytes, size);
	StateCoder<RangeDecoder> state_coder(coder);
	uint32_t ticks = 0;
	uint32_t check = 0;
	uint32_t count = 0;
	coder.bits(ticks, 7);
	coder.bits(check, 32);
	_new_models = MotionModels();
	code_models(coder, _new_models);
	coder.bits(count, INDEX_BITS);
	// Each body takes at least one byte, so a short snapshot cannot make the decoder allocate many bodies.
	if (ticks > MAX_TICKS || count > size) {
		return PacketError::UNREADABLE_SNAPSHOT;
	}
	if (count > _max_bodies) {
		return PacketError::TOO_MANY_BODIES;
	}
	_new_bodies.clear();
	for (uint32_t i = 0; i < count; ++i) {
		Body body;
		coder.bits(body.id, 31);
		body.state.visit(state_coder);
		if (!body.state.is_valid()) {
			return PacketError::UNREADABLE_SNAPSHOT;
		}
		_new_bodies.push_back(body);
	}
	std::swap(_models, _new_models);
	_bodies.swap(_new_bodies);
	_last_ticks = int(ticks);
	_check = check;
	return {};
}

std::optional<int> StreamDecoder::decode_window(const uint8_t *bytes, size_t size, WindowCheck check, double begin, cga::Mode mode, std::vector<BodyMotion> &motions) {
	const auto fail = [&motions] {
		motions.clear();
		return std::nullopt;
	};
	motions.clear();
	_new_models = _models;
	_new_bodies = _bodies;
	RangeDecoder coder(bytes, size);
	bool same_length = true;
	coder.bit(_new_models.same_length, same_length);
	int ticks = _last_ticks;
	if (!same_length) {
		uint32_t ticks_minus_one = 0;
		coder.bits(ticks_minus_one, 6);
		ticks = int(ticks_minus_one) + 1;
	}
	if (ticks < 1 || ticks > MAX_TICKS || !decode_events(coder, ticks)) {
		return fail();
	}
	_previous_active = false;
	uint32_t new_check = _check;
	for (Body &body : _new_bodies) {
		if (!decode_motion(coder, body, begin, ticks, mode, motions)) {
			return fail();
		}
		new_check = (new_check ^ body.state.hash()) * 0x01000193u;
	}
	if (((check_bits(new_check) ^ check.value) & check.mask) != 0) {
		return fail();
	}
	_new_bodies.erase(std::remove_if(_new_bodies.begin(), _new_bodies.end(), [](const Body &body) { return body.removal_tick != NEVER; }), _new_bodies.end());
	std::swap(_models, _new_models);
	_bodies.swap(_new_bodies);
	_check = new_check;
	_last_ticks = ticks;
	return ticks;
}

bool StreamDecoder::decode_events(RangeDecoder &coder, int ticks) {
	bool has_events = false;
	coder.bit(_new_models.has_events, has_events);
	if (!has_events) {
		return true;
	}
	StateCoder<RangeDecoder> state_coder(coder);
	while (true) {
		uint32_t more = 0;
		coder.bits(more, 1);
		if (more == 0) {
			return true;
		}
		uint32_t event = 0;
		uint32_t tick = 0;
		coder.bits(event, 2);
		coder.bits(tick, 7);
		if (int(tick) > ticks) {
			return false;
		}
		if (event == uint32_t(WindowEvent::ADDED)) {
			Body body;
			coder.bits(body.id, 31);
			body.target.visit(state_coder);
			body.state = body.target;
			body.event_tick = int(tick);
			if (!body.state.is_valid() || body.state.active || _new_bodies.size() >= _max_bodies) {
				return false;
			}
			body.event = Event::APPEARS;
			_new_bodies.push_back(body);
			continue;
		}
		int32_t index = 0;
		state_coder(index, INDEX_BITS);
		if (index < 0 || size_t(index) >= _new_bodies.size() || _new_bodies[size_t(index)].removal_tick != NEVER) {
			return false;
		}
		Body &body = _new_bodies[size_t(index)];
		if (event == uint32_t(WindowEvent::REMOVED)) {
			body.removal_tick = int(tick);
			continue;
		}
		body.target.visit(state_coder);
		body.event_tick = int(tick);
		body.event = Event::JUMPS;
		if (event != uint32_t(WindowEvent::JUMPED) || !body.target.is_valid() || body.target.active) {
			return false;
		}
	}
}

bool StreamDecoder::decode_motion(RangeDecoder &coder, Body &body, double begin, int ticks, cga::Mode mode, std::vector<BodyMotion> &motions) {
	const int last = std::min(body.removal_tick, ticks);
	const int at = std::min(body.event_tick, last);
	if (body.event == Event::JUMPS) {
		if (!decode_span(coder, body, begin, at, mode, motions)) {
			return false;
		}
		body.state = body.target;
	}
	if (body.event != Event::NONE) {
		BodyMotion motion;
		motion.id = body.id;
		motion.appears = true;
		motion.segment.begin = begin + at;
		motion.segment.start = body.state.pose(_grid);
		motions.push_back(motion);
		body.event = Event::NONE;
		body.event_tick = 0;
	}
	if (!decode_span(coder, body, begin + at, last - at, mode, motions)) {
		return false;
	}
	if (body.removal_tick != NEVER) {
		BodyMotion motion;
		motion.id = body.id;
		motion.vanishes = true;
		motion.segment.begin = begin + last;
		motions.push_back(motion);
	}
	return true;
}

bool StreamDecoder::decode_span(RangeDecoder &coder, Body &body, double begin, int ticks, cga::Mode mode, std::vector<BodyMotion> &motions) {
	if (ticks <= 0) {
		return true;
	}
	_motion.active = false;
	_motion.count = 0;
	const bool is_valid = code_motion(coder, _new_models, body.state, _grid, begin, ticks, _previous_active, _motion, [&](const BodyState &state, const SegmentCode &code, const SegmentSteps &steps, double segment_begin) {
		BodyMotion motion;
		motion.id = body.id;
		motion.segment = state.segment(code, steps, _grid, segment_begin, mode);
		motions.push_back(motion);
	});
	_previous_active = _motion.active;
	return is_valid;
}

} // namespace net
