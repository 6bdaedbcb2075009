#include "net/stream/stream_decoder.hpp"

#include <algorithm>

namespace net {

namespace {

/// Minimum size of a body in a snapshot: its id, and for each number of its pose the width, in plain bits.
constexpr size_t MIN_BODY_BYTES = (31 + 3 * 6 + 2 + 3 * 5 + 5 + 2 + 2) / 8;

} // namespace

PacketResult StreamDecoder::read_snapshot(const uint8_t *bytes, size_t size) {
	RangeDecoder coder(bytes, size);
	StateCoder<RangeDecoder> state_coder(coder);
	const uint32_t ticks = coder.read_bits(7);
	const uint32_t check = coder.read_bits(32);
	_new_models = MotionModels();
	code_models(coder, _new_models);
	const uint32_t count = coder.read_bits(INDEX_BITS);
	// A short snapshot cannot make the decoder allocate many bodies.
	if (ticks > MAX_TICKS || count > size / MIN_BODY_BYTES) {
		return PacketError::UNREADABLE_SNAPSHOT;
	}
	_declared_count = count;
	if (count > _max_bodies) {
		return PacketError::TOO_MANY_BODIES;
	}
	_new_bodies.clear();
	for (uint32_t i = 0; i < count; ++i) {
		Body body{ coder.read_bits(31) };
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

void StreamDecoder::encode_snapshot(std::vector<uint8_t> &bytes) {
	RangeEncoder coder(bytes);
	StateCoder<RangeEncoder> state_coder(coder);
	coder.bits(uint32_t(_last_ticks), 7);
	coder.bits(_check, 32);
	code_models(coder, _models);
	coder.bits(uint32_t(_bodies.size()), INDEX_BITS);
	for (Body &body : _bodies) {
		coder.bits(body.id, 31);
		body.state.visit(state_coder);
	}
	coder.finish();
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
	const int ticks = same_length ? _last_ticks : int(coder.read_bits(6)) + 1;
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
	while (coder.read_bits(1) != 0) {
		const auto event = WindowEvent(coder.read_bits(2));
		const int tick = int(coder.read_bits(7));
		if (tick > ticks) {
			return false;
		}
		if (event == WindowEvent::ADDED) {
			Body body{ coder.read_bits(31) };
			body.state.visit(state_coder);
			if (!body.state.is_valid() || body.state.active || _new_bodies.size() >= _max_bodies) {
				return false;
			}
			body.event = Event::APPEARS;
			body.event_tick = tick;
			_new_bodies.push_back(body);
			continue;
		}
		int32_t index = 0;
		state_coder(index, INDEX_BITS);
		if (index < 0 || size_t(index) >= _new_bodies.size() || _new_bodies[size_t(index)].removal_tick != NEVER) {
			return false;
		}
		Body &body = _new_bodies[size_t(index)];
		if (event == WindowEvent::REMOVED || event == WindowEvent::FREED) {
			body.removal_tick = tick;
			body.freed = event == WindowEvent::FREED;
			continue;
		}
		body.target.visit(state_coder);
		body.event_tick = tick;
		body.event = Event::JUMPS;
		if (!body.target.is_valid() || body.target.active || body.target.planar != body.state.planar) {
			return false;
		}
	}
	return true;
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
		motions.push_back(BodyMotion::rest(body.id, begin + at, body.state.pose(_grid), true));
		motions.back().jumps = body.event == Event::JUMPS;
		body.event = Event::NONE;
		body.event_tick = 0;
	}
	if (!decode_span(coder, body, begin + at, last - at, mode, motions)) {
		return false;
	}
	if (body.removal_tick != NEVER) {
		motions.push_back(BodyMotion::removal(body.id, begin + last, body.freed));
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
		motions.push_back({ body.id, false, false, false, false, state.segment(code, steps, _grid, segment_begin, mode) });
	});
	_previous_active = _motion.active;
	return is_valid;
}

} // namespace net
