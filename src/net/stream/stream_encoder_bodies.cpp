#include "net/stream/stream_encoder.hpp"

#include "net/stream/setting_range.hpp"

#include <algorithm>
#include <cmath>

// The bodies of a stream, and what is observed of them.

namespace net {

namespace {

/// Samples closer together than this, in ticks, are dropped.
constexpr double MIN_STEP = 0.12;

} // namespace

static_assert(PRIORITY_RANGE.max == BodyState::MAX_COARSENESS);

bool StreamEncoder::add_body(uint32_t id, double time, const cga::Pose<double> &pose, bool planar) {
	Body body;
	body.state.planar = planar;
	if (id >= ID_LIMIT || has_body(id) || !set_latest(body, pose) || !body.state.set_pose(body.latest, _grid)) {
		return false;
	}
	body.id = id;
	body.added = true;
	body.event_time = time;
	body.encoded_until = time;
	_index[id] = _bodies.size();
	_bodies.push_back(std::move(body));
	_changed = true;
	return true;
}

void StreamEncoder::include(size_t index) {
	if (index != _known) {
		std::swap(_bodies[index], _bodies[_known]);
		for (const size_t moved : { index, _known }) {
			if (!_bodies[moved].removed) {
				_index[_bodies[moved].id] = moved;
			}
		}
	}
	Body &body = _bodies[_known++];
	_blocks.resize(_known);
	body.hash = body_hash(body.id, body.state);
	_hash_sum += body.hash;
}

void StreamEncoder::move_body(size_t from, size_t to) {
	if (from == to) {
		return;
	}
	_bodies[to] = std::move(_bodies[from]);
	if (!_bodies[to].removed) {
		_index[_bodies[to].id] = to;
	}
}

void StreamEncoder::erase(size_t index) {
	if (index < _known) {
		_hash_sum -= _bodies[index].hash;
		const bool is_last_active = _bodies[--_known].state.active;
		_blocks.change_active(index, _bodies[index].state.active, is_last_active);
		_blocks.change_active(_known, is_last_active, false);
		move_body(_known, index);
		index = _known;
		_blocks.resize(_known);
	}
	move_body(_bodies.size() - 1, index);
	_bodies.pop_back();
}

void StreamEncoder::start_at(double tick) {
	for (size_t i = _known; i < _bodies.size(); ++i) {
		Body &body = _bodies[i];
		if (body.event_time > tick + SAME_TICK) {
			continue;
		}
		MotionSample from{ body.event_time, body.state.pose(_grid) };
		auto after = body.samples.begin();
		for (; after != body.samples.end() && after->time <= tick; ++after) {
			from = *after;
		}
		if (after != body.samples.end()) {
			(void)body.state.set_pose(blended(from.pose, after->pose, std::max(tick - from.time, 0.0) / (after->time - from.time)), _grid);
		} else if (after != body.samples.begin()) {
			(void)body.state.set_pose(from.pose, _grid);
		}
		body.samples.erase(body.samples.begin(), after);
		body.added = false;
		body.encoded_until = tick;
		include(i);
	}
}

bool StreamEncoder::remove_body(uint32_t id, double time, bool freed) {
	const auto found = _index.find(id);
	if (found == _index.end()) {
		return false;
	}
	Body &body = _bodies[found->second];
	body.removed = true;
	body.freed = freed;
	// The body is shown up to its last pose.
	body.removal_time = body.samples.empty() ? time : std::clamp(body.samples.back().time, time, time + MAX_TICKS);
	_index.erase(found);
	_changed = true;
	return true;
}

bool StreamEncoder::jump(uint32_t id) {
	const auto found = _index.find(id);
	if (found == _index.end()) {
		return false;
	}
	_bodies[found->second].jump_next = true;
	return true;
}

bool StreamEncoder::set_latest(Body &body, const cga::Pose<double> &pose) const {
	const auto set = [&body, this](const cga::Pose<double> &used) {
		if (!BodyState::is_in_range(used, _grid)) {
			return false;
		}
		body.latest = { used.translation, glm::normalize(used.rotation), used.scale };
		return true;
	};
	return body.state.planar ? set(BodyState::planar_part(pose)) : set(pose);
}

bool StreamEncoder::observe(uint32_t id, double time, const cga::Pose<double> &pose) {
	const auto found = _index.find(id);
	return found != _index.end() && set_latest(_bodies[found->second], pose) && observe(_bodies[found->second], time);
}

bool StreamEncoder::observe(uint32_t id, double time) {
	const auto found = _index.find(id);
	return found != _index.end() && observe(_bodies[found->second], time);
}

bool StreamEncoder::observe(Body &body, double time) {
	const double whole = std::floor(time + 0.5);
	if (std::fabs(time - whole) < SAME_TICK) {
		time = whole;
	}
	// What was observed at later times no longer holds.
	while (!body.samples.empty() && body.samples.back().time > time) {
		body.samples.pop_back();
	}
	body.event_time = std::min(body.event_time, time);
	if (body.added && (body.jump_next || time <= body.event_time + SAME_TIME)) {
		// No window contains the body yet: it is added at this pose.
		body.jump_next = false;
		body.samples.clear();
		if (time > body.event_time + MIN_STEP) {
			body.samples.push_back({ time, body.latest });
		}
		return body.state.set_pose(body.latest, _grid);
	}
	if (body.jump_next) {
		body.jump_next = false;
		_changed = true;
		// Merge all jumps of a window into one: at the time of the first, to the pose of the last.
		const double first = body.jumped ? body.event_time : time;
		body.jumped = true;
		body.event_time = first;
		while (!body.samples.empty() && body.samples.back().time >= first) {
			body.samples.pop_back();
		}
		body.samples.push_back({ first, body.latest });
		if (time > first + MIN_STEP) {
			body.samples.push_back({ time, body.latest });
		}
		return true;
	}
	_changed = _changed || is_changed(body, body.latest);
	if (body.samples.empty() || time - body.samples.back().time >= MIN_STEP) {
		body.samples.push_back({ time, body.latest });
	}
	return true;
}

bool StreamEncoder::set_priority(uint32_t id, int priority) {
	const auto found = _index.find(id);
	if (found == _index.end()) {
		return false;
	}
	_bodies[found->second].priority = uint8_t(std::clamp(priority, int(PRIORITY_RANGE.min), int(PRIORITY_RANGE.max)));
	return true;
}

} // namespace net
