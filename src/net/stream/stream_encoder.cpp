#include "net/stream/stream_encoder.hpp"

#include <algorithm>
#include <cmath>

namespace net {

namespace {

/// A gap between samples that exceeds both limits is not interpolated: the body rests, then jumps.
constexpr double MAX_GAP_WINDOWS = 1.5;
constexpr double MAX_GAP_TICKS = 6.0;
/// Fraction of the tolerance within which a body stays at rest.
constexpr double MAX_REST_DEVIATION = 0.9;

double max_gap(int ticks) {
	return std::max(MAX_GAP_WINDOWS * ticks, MAX_GAP_TICKS);
}

} // namespace

int StreamEncoder::tick_in_window(double time, double begin, int ticks) {
	return int(std::clamp(std::floor(time - begin + SAME_TICK), 0.0, double(ticks)));
}

bool StreamEncoder::is_changed(const Body &body, const cga::Pose<double> &pose) const {
	return body.state.active || !body.state.rest_corrected || pose_distance(body.state.pose(_grid), pose, _grid.lever_arm) > MAX_REST_DEVIATION * StreamGrid::TOLERANCE * _grid.position_step;
}

void StreamEncoder::encode_window(double begin, int ticks, std::vector<uint8_t> &bytes) {
	RangeEncoder coder(bytes);
	const bool same_length = ticks == _last_ticks;
	coder.bit(_models.same_length, same_length);
	if (!same_length) {
		coder.bits(uint32_t(ticks - 1), 6);
	}
	_last_ticks = ticks;
	code_coarseness(coder, _models, _last_coarseness, _motion.coarseness);
	find_gaps(begin, ticks);
	const double end = begin + ticks + SAME_TIME;
	const size_t first_added = _known;
	for (size_t i = _known; i < _bodies.size(); ++i) {
		if (_bodies[i].event_time <= end) {
			include(i);
		}
	}
	encode_events(coder, first_added, begin, ticks);
	encode_bodies(coder, begin, ticks);
	coder.finish();
	_check = next_check(_check, _hash_sum);
	for (size_t i = _bodies.size(); i-- > 0;) {
		// A body that was added after the end and has already been removed is never sent.
		if (_bodies[i].is_removed_by(end) || (i >= _known && _bodies[i].removed)) {
			erase(i);
		}
	}
	_changed = std::any_of(_bodies.begin(), _bodies.end(), [this](const Body &body) {
		return body.jumped || body.added || body.removed || (body.samples.empty() ? body.state.active || !body.state.rest_corrected : is_changed(body, body.samples.back().pose));
	});
}

void StreamEncoder::find_gaps(double begin, int ticks) {
	const double gap = max_gap(ticks);
	for (Body &body : _bodies) {
		if (body.samples.empty() || body.added || body.jumped || body.samples.front().time > begin + ticks || body.samples.front().time - body.encoded_until <= gap) {
			continue;
		}
		if (is_changed(body, body.samples.front().pose)) {
			body.jumped = true;
			body.event_time = body.samples.front().time;
		}
	}
}

void StreamEncoder::encode_events(RangeEncoder &coder, size_t first_added, double begin, int ticks) {
	// Events after the window's end belong to the next one.
	const double end = begin + ticks + SAME_TIME;
	const bool has_events = first_added < _known || std::any_of(_bodies.begin(), _bodies.begin() + ptrdiff_t(_known), [end](const Body &body) { return body.has_event_by(end); });
	coder.bit(_models.has_events, has_events);
	if (!has_events) {
		return;
	}
	StateCoder<RangeEncoder> state_coder(coder);
	const auto put_event = [&](WindowEvent event, double time) {
		coder.bits(1, 1);
		coder.bits(uint32_t(event), 2);
		coder.bits(uint32_t(tick_in_window(time, begin, ticks)), 7);
	};
	for (size_t i = 0; i < _known; ++i) {
		Body &body = _bodies[i];
		int32_t index = int32_t(i);
		if (body.added) {
			put_event(WindowEvent::ADDED, body.event_time);
			coder.bits(body.id, 31);
			body.state.visit(state_coder);
		} else if (body.is_jumped_by(end)) {
			put_event(WindowEvent::JUMPED, body.event_time);
			state_coder(index, INDEX_BITS);
			BodyState target;
			target.planar = body.state.planar;
			const auto first = std::find_if(body.samples.begin(), body.samples.end(), [&](const MotionSample &sample) { return sample.time >= body.event_time; });
			if (first == body.samples.end() || !target.set_pose(first->pose, _grid)) {
				target = body.state;
				target.reset_motion();
			}
			target.visit(state_coder);
		}
		if (body.is_removed_by(end)) {
			put_event(body.freed ? WindowEvent::FREED : WindowEvent::REMOVED, body.removal_time);
			state_coder(index, INDEX_BITS);
		}
	}
	coder.bits(0, 1);
}

void StreamEncoder::encode_bodies(RangeEncoder &coder, double begin, int ticks) {
	const double end = begin + ticks + SAME_TIME;
	_previous_active = false;
	_moving = 0;
	for (size_t from = 0; from < _known; from += BodyBlocks::SIZE) {
		const size_t to = std::min(from + BodyBlocks::SIZE, _known);
		const auto any = [this, from, to](const auto &condition) { return std::any_of(_bodies.begin() + ptrdiff_t(from), _bodies.begin() + ptrdiff_t(to), condition); };
		bool is_coded = !_blocks.has_flags() || _blocks.is_active(BodyBlocks::block_of(from)) || any([end](const Body &body) { return body.has_event_by(end); });
		if (!is_coded) {
			is_coded = any([this, end](const Body &body) { return must_encode(body, end); });
			_blocks.code_flag(coder, is_coded);
		}
		if (!is_coded) {
			std::for_each(_bodies.begin() + ptrdiff_t(from), _bodies.begin() + ptrdiff_t(to), [&](Body &body) { skip_motion(body, begin, ticks); });
			_previous_active = false;
			continue;
		}
		for (size_t i = from; i < to; ++i) {
			Body &body = _bodies[i];
			const bool was_active = body.state.active;
			encode_motion(coder, body, begin, ticks);
			_blocks.change_active(i, was_active, body.state.active);
			_moving += body.state.active ? 1 : 0;
			_hash_sum -= body.hash;
			body.hash = body_hash(body.id, body.state);
			_hash_sum += body.hash;
		}
	}
}

bool StreamEncoder::must_encode(const Body &body, double end) const {
	const auto is_relevant = [&](const MotionSample &sample) { return sample.time <= end && is_changed(body, sample.pose); };
	return std::any_of(body.samples.begin(), body.samples.end(), is_relevant);
}

void StreamEncoder::skip_motion(Body &body, double begin, int ticks) {
	const double end = begin + ticks + SAME_TIME;
	const auto after = std::partition_point(body.samples.begin(), body.samples.end(), [end](const MotionSample &sample) { return sample.time <= end; });
	if (after != body.samples.begin()) {
		body.encoded_until = (after - 1)->time;
		body.samples.erase(body.samples.begin(), after);
	}
}

void StreamEncoder::encode_motion(RangeEncoder &coder, Body &body, double begin, int ticks) {
	const double end = begin + ticks + SAME_TIME;
	const size_t count = size_t(std::partition_point(body.samples.begin(), body.samples.end(), [end](const MotionSample &sample) { return sample.time <= end; }) - body.samples.begin());
	const int last = body.is_removed_by(end) ? tick_in_window(body.removal_time, begin, ticks) : ticks;
	int from = 0;
	size_t first = 0;
	if ((body.added || body.jumped) && body.event_time <= end) {
		from = std::min(tick_in_window(body.event_time, begin, ticks), last);
		while (first < count && body.samples[first].time < body.event_time) {
			++first;
		}
		if (body.jumped) {
			encode_span(coder, body, begin, from, 0, first, first);
			if (first == count || !body.state.set_pose(body.samples[first].pose, _grid)) {
				body.state.reset_motion();
			}
		}
		body.added = false;
		body.jumped = false;
	}
	encode_span(coder, body, begin + from, last - from, first, count - first, body.samples.size() - first);
	body.samples.erase(body.samples.begin(), body.samples.begin() + ptrdiff_t(count));
}

void StreamEncoder::encode_span(RangeEncoder &coder, Body &body, double begin, int ticks, size_t first, size_t count, size_t available) {
	if (ticks <= 0) {
		return;
	}
	_motion.finer = body.priority;
	const MotionSample *samples = body.samples.data() + first;
	while (count > 0 && samples->time <= begin + SAME_TIME) {
		++samples;
		--count;
		--available;
	}
	// Ignore samples between the tick of a jump or removal and its actual time.
	while (count > 0 && samples[count - 1].time > begin + ticks + SAME_TIME) {
		--count;
	}
	if (count == 0 && body.state.active && begin + ticks - body.encoded_until <= max_gap(ticks)) {
		_motion.active = true;
		_motion.count = 1;
		_motion.segments[0] = SegmentCode{ ticks };
	} else {
		body.encoded_until = count == 0 ? body.encoded_until : samples[count - 1].time;
		_planner.plan(body.state, begin, ticks, samples, count, available, _models, _motion);
		body.jump_next = body.jump_next || _motion.must_jump;
	}
	(void)code_motion(coder, _models, body.state, _grid, begin, ticks, _previous_active, _motion, [](const BodyState &, const SegmentCode &, const SegmentSteps &, double) {});
	_previous_active = _motion.active;
}

void StreamEncoder::encode_snapshot(std::vector<uint8_t> &bytes) {
	RangeEncoder coder(bytes);
	StateCoder<RangeEncoder> state_coder(coder);
	coder.bits(uint32_t(_last_ticks), 7);
	coder.bits(uint32_t(_last_coarseness), COARSENESS_BITS);
	coder.bits(_check, 32);
	code_models(coder, _models);
	auto count = uint32_t(_known);
	AdaptiveBit block_model = _blocks.model();
	code_body_count(coder, count, block_model);
	for (size_t i = 0; i < _known; ++i) {
		coder.bits(_bodies[i].id, 31);
		_bodies[i].state.visit(state_coder);
	}
	coder.finish();
}

} // namespace net
