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
	const uint32_t coarseness = coder.read_bits(BodyState::COARSENESS_BITS);
	const uint32_t check = coder.read_bits(32);
	MotionModels models;
	code_models(coder, models);
	BodyBlocks blocks;
	uint32_t count = 0;
	AdaptiveBit block_model = blocks.model();
	code_body_count(coder, count, block_model);
	_work = SNAPSHOT_WORK + size / BYTES_PER_WORK;
	// A short snapshot cannot make the decoder allocate many bodies.
	if (ticks > MAX_TICKS || coarseness > BodyState::MAX_COARSENESS || count > size / MIN_BODY_BYTES) {
		return PacketError::UNREADABLE_SNAPSHOT;
	}
	_declared_count = count;
	if (count > _max_bodies) {
		return PacketError::TOO_MANY_BODIES;
	}
	std::vector<Body> bodies;
	bodies.reserve(count);
	blocks.resize(count);
	blocks.set_model(block_model);
	uint32_t hash_sum = 0;
	for (uint32_t i = 0; i < count; ++i) {
		Body body{ coder.read_bits(31) };
		body.state.visit(state_coder);
		_work += NEW_BODY_WORK;
		if (!body.state.is_valid()) {
			return PacketError::UNREADABLE_SNAPSHOT;
		}
		body.hash = body_hash(body.id, body.state);
		hash_sum += body.hash;
		blocks.change_active(i, false, body.state.active);
		bodies.push_back(body);
	}
	_models = models;
	_bodies.swap(bodies);
	std::swap(_blocks, blocks);
	_last_ticks = int(ticks);
	_last_coarseness = int(coarseness);
	_check = check;
	_hash_sum = hash_sum;
	return {};
}

void StreamDecoder::encode_snapshot(std::vector<uint8_t> &bytes) {
	RangeEncoder coder(bytes);
	StateCoder<RangeEncoder> state_coder(coder);
	coder.bits(uint32_t(_last_ticks), 7);
	coder.bits(uint32_t(_last_coarseness), BodyState::COARSENESS_BITS);
	coder.bits(_check, 32);
	code_models(coder, _models);
	auto count = uint32_t(_bodies.size());
	AdaptiveBit block_model = _blocks.model();
	code_body_count(coder, count, block_model);
	for (Body &body : _bodies) {
		coder.bits(body.id, 31);
		body.state.visit(state_coder);
	}
	coder.finish();
}

std::optional<int> StreamDecoder::decode_window(const uint8_t *bytes, size_t size, WindowCheck check, double begin, cga::Mode mode, std::vector<BodyMotion> &motions) {
	motions.clear();
	_events.clear();
	_saved.clear();
	_saved_models = _models;
	_saved_block_model = _blocks.model();
	_work = WINDOW_WORK + size / BYTES_PER_WORK;
	const size_t count = _bodies.size();
	RangeDecoder coder(bytes, size);
	bool same_length = true;
	coder.bit(_models.same_length, same_length);
	const int ticks = same_length ? _last_ticks : int(coder.read_bits(6)) + 1;
	int coarseness = _last_coarseness;
	code_coarseness(coder, _models, coarseness, _motion.coarseness);
	const uint32_t hash_sum = _hash_sum;
	bool is_valid = coarseness <= BodyState::MAX_COARSENESS && ticks >= 1 && ticks <= MAX_TICKS && decode_events(coder, ticks) && decode_bodies(coder, begin, ticks, mode, motions);
	const uint32_t new_check = next_check(_check, _hash_sum);
	is_valid = is_valid && ((check_bits(new_check) ^ check.value) & check.mask) == 0;
	if (!is_valid) {
		undo(count);
		_hash_sum = hash_sum;
		motions.clear();
		return std::nullopt;
	}
	_check = new_check;
	_last_ticks = ticks;
	_last_coarseness = coarseness;
	remove_bodies();
	return ticks;
}

void StreamDecoder::undo(size_t body_count) {
	_models = _saved_models;
	for (auto saved = _saved.rbegin(); saved != _saved.rend(); ++saved) {
		_blocks.change_active(saved->index, _bodies[saved->index].state.active, saved->body.state.active);
		_bodies[saved->index] = saved->body;
	}
	for (const BodyEvents &events : _events) {
		_bodies[events.index].event = NO_EVENT;
	}
	_bodies.resize(body_count);
	_blocks.resize(body_count);
	_blocks.set_model(_saved_block_model);
}

/// The last body takes the place of each removed one, from the end of the list on.
void StreamDecoder::remove_bodies() {
	for (const BodyEvents &events : _events) {
		_bodies[events.index].event = NO_EVENT;
	}
	_events.erase(std::remove_if(_events.begin(), _events.end(), [](const BodyEvents &events) { return events.removal_tick == NEVER; }), _events.end());
	std::sort(_events.begin(), _events.end(), [](const BodyEvents &a, const BodyEvents &b) { return a.index > b.index; });
	for (const BodyEvents &events : _events) {
		const size_t last = _bodies.size() - 1;
		_hash_sum -= _bodies[events.index].hash;
		_blocks.change_active(events.index, _bodies[events.index].state.active, _bodies[last].state.active);
		_blocks.change_active(last, _bodies[last].state.active, false);
		_bodies[events.index] = _bodies[last];
		_bodies.pop_back();
	}
	_blocks.resize(_bodies.size());
}

StreamDecoder::BodyEvents &StreamDecoder::events_of(size_t index) {
	Body &body = _bodies[index];
	if (body.event == NO_EVENT) {
		body.event = int32_t(_events.size());
		_events.emplace_back();
		_events.back().index = index;
	}
	return _events[size_t(body.event)];
}

bool StreamDecoder::decode_events(RangeDecoder &coder, int ticks) {
	bool has_events = false;
	coder.bit(_models.has_events, has_events);
	if (!has_events) {
		return true;
	}
	StateCoder<RangeDecoder> state_coder(coder);
	while (coder.read_bits(1) != 0) {
		const auto event = WindowEvent(coder.read_bits(2));
		const int tick = int(coder.read_bits(7));
		_work += NEW_BODY_WORK;
		if (tick > ticks) {
			return false;
		}
		if (event == WindowEvent::ADDED) {
			Body body{ coder.read_bits(31) };
			body.state.visit(state_coder);
			if (!body.state.is_valid() || body.state.active || _bodies.size() >= _max_bodies) {
				return false;
			}
			_bodies.push_back(body);
			BodyEvents &events = events_of(_bodies.size() - 1);
			events.appears = true;
			events.tick = tick;
			continue;
		}
		int32_t index = 0;
		state_coder(index, INDEX_BITS);
		if (index < 0 || size_t(index) >= _bodies.size()) {
			return false;
		}
		BodyEvents &events = events_of(size_t(index));
		if (events.removal_tick != NEVER) {
			return false;
		}
		if (event == WindowEvent::REMOVED || event == WindowEvent::FREED) {
			events.removal_tick = tick;
			events.freed = event == WindowEvent::FREED;
			continue;
		}
		events.target.visit(state_coder);
		events.tick = tick;
		events.jumps = true;
		if (!events.target.is_valid() || events.target.active || events.target.planar != _bodies[size_t(index)].state.planar) {
			return false;
		}
	}
	return true;
}

bool StreamDecoder::decode_bodies(RangeDecoder &coder, double begin, int ticks, cga::Mode mode, std::vector<BodyMotion> &motions) {
	const size_t count = _bodies.size();
	const size_t max_work = max_window_work(count);
	_blocks.resize(count);
	_has_events.assign(BodyBlocks::count(count), false);
	_work += BodyBlocks::count(count) * BODY_WORK;
	for (const BodyEvents &events : _events) {
		_has_events[BodyBlocks::block_of(events.index)] = true;
	}
	_previous_active = false;
	for (size_t from = 0; from < count; from += BodyBlocks::SIZE) {
		const size_t block = BodyBlocks::block_of(from);
		bool is_coded = !_blocks.has_flags() || _blocks.is_active(block) || _has_events[block];
		if (!is_coded) {
			_blocks.code_flag(coder, is_coded);
		}
		if (!is_coded) {
			_previous_active = false;
			continue;
		}
		const size_t to = std::min(from + BodyBlocks::SIZE, count);
		_work += (to - from) * BODY_WORK;
		for (size_t i = from; i < to; ++i) {
			Body &body = _bodies[i];
			const bool was_active = body.state.active;
			_saved.push_back({ i, body });
			const bool is_valid = decode_motion(coder, body, begin, ticks, mode, motions);
			_blocks.change_active(i, was_active, body.state.active);
			if (!is_valid) {
				return false;
			}
			_hash_sum -= body.hash;
			body.hash = body_hash(body.id, body.state);
			_hash_sum += body.hash;
		}
		if (_work > max_work) {
			return false;
		}
	}
	return true;
}

bool StreamDecoder::decode_motion(RangeDecoder &coder, Body &body, double begin, int ticks, cga::Mode mode, std::vector<BodyMotion> &motions) {
	static const BodyEvents NO_EVENTS;
	const BodyEvents &events = body.event != NO_EVENT ? _events[size_t(body.event)] : NO_EVENTS;
	const int last = std::min(events.removal_tick, ticks);
	const int at = std::min(events.tick, last);
	if (events.jumps) {
		if (!decode_span(coder, body, begin, at, mode, motions)) {
			return false;
		}
		body.state = events.target;
	}
	if (events.appears || events.jumps) {
		motions.push_back(BodyMotion::rest(body.id, begin + at, body.state.pose(_grid), true));
		motions.back().jumps = events.jumps;
	}
	if (!decode_span(coder, body, begin + at, last - at, mode, motions)) {
		return false;
	}
	if (events.removal_tick != NEVER) {
		motions.push_back(BodyMotion::removal(body.id, begin + last, events.freed));
	}
	return true;
}

bool StreamDecoder::decode_span(RangeDecoder &coder, Body &body, double begin, int ticks, cga::Mode mode, std::vector<BodyMotion> &motions) {
	if (ticks <= 0) {
		return true;
	}
	_motion.active = false;
	_motion.count = 0;
	const bool is_valid = code_motion(coder, _models, body.state, _grid, begin, ticks, _previous_active, _motion, [&](const BodyState &state, const SegmentCode &code, const SegmentSteps &steps, double segment_begin) {
		_work += SEGMENT_WORK;
		motions.push_back({ body.id, false, false, false, false, state.segment(code, steps, _grid, segment_begin, mode) });
	});
	_previous_active = _motion.active;
	return is_valid;
}

} // namespace net
