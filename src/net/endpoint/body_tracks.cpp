#include "net/endpoint/body_tracks.hpp"

#include <algorithm>
#include <atomic>
#include <iterator>

namespace net {

namespace {

/// Maximum number of ends of lives that are kept.
constexpr size_t MAX_ENDS = 32768;
/// Fraction of the time for which ends are known after which old ones are dropped again.
constexpr double END_CHECK_INTERVAL = 0.125;

uint64_t next_life() {
	static std::atomic<uint64_t> last_life = 0; // receivers may be in different threads
	return ++last_life;
}

} // namespace

void BodyTracks::add(BodyMotion &motion) {
	auto found = _tracks.find(motion.id);
	if (found == _tracks.end()) {
		if (_tracks.size() >= max_tracks()) {
			drop_ended();
		}
		found = _tracks.try_emplace(motion.id).first;
		add_event(BodyEvent::ADDED, motion.id);
	}
	add(*found, motion);
}

void BodyTracks::add(Tracks::value_type &entry, BodyMotion &motion) {
	MotionTrack &track = entry.second.motions;
	const bool is_new = motion.appears && !motion.jumps;
	motion.life = track.life();
	if (motion.life != 0 && (is_new || motion.vanishes)) {
		add_end(track, motion);
	}
	if (!motion.vanishes && (is_new || motion.life == 0)) {
		motion.life = next_life();
	}
	_capacity -= track.capacity();
	track.add(motion, _capacity < max_capacity() ? MotionTrack::MAX_CAPACITY : MotionTrack::MIN_CAPACITY);
	_capacity += track.capacity();
	if (!track.is_settled()) {
		mark_busy(entry);
	}
}

void BodyTracks::add_end(const MotionTrack &track, const BodyMotion &motion) {
	const BodyMotion *last = track.motion_at(motion.segment.begin);
	_ends[motion.life] = { motion.id, motion.freed ? BodyEnd::FREED : BodyEnd::REMOVED, motion.segment.begin, last != nullptr ? std::optional(last->segment.pose_at(motion.segment.begin)) : std::nullopt };
	if (_ends.size() > MAX_ENDS) {
		_ends.erase(_ends.begin());
	}
}

void BodyTracks::add_event(BodyEvent::Kind kind, uint32_t id) {
	if (_events.size() > 8 * _max_bodies + 64) {
		// The caller does not call take_events(): drop the older half.
		_events.erase(_events.begin(), _events.begin() + ptrdiff_t(_events.size() / 2));
	}
	_events.push_back({ kind, id });
}

void BodyTracks::mark_busy(Tracks::value_type &entry) {
	if (!entry.second.is_busy) {
		entry.second.is_busy = true;
		_busy.push_back(&entry);
	}
}

void BodyTracks::erase(uint32_t id) {
	const auto found = _tracks.find(id);
	_capacity -= found->second.motions.capacity();
	_tracks.erase(found);
	add_event(BodyEvent::REMOVED, id);
}

/// Drops the bodies that do not exist at the end of known motion, although playback may still show them.
void BodyTracks::drop_ended() {
	const auto ended = std::partition(_busy.begin(), _busy.end(), [](const Tracks::value_type *entry) { return entry->second.motions.life() != 0; });
	std::for_each(ended, _busy.end(), [this](const Tracks::value_type *entry) { erase(entry->first); });
	_busy.erase(ended, _busy.end());
}

void BodyTracks::show_snapshot(const StreamDecoder &decoder, double tick, bool continues) {
	++_snapshot;
	for (size_t i = 0; i < decoder.body_count(); ++i) {
		const uint32_t id = decoder.id(i);
		const auto known = _tracks.find(id);
		// Bodies in the first snapshot already existed. An unknown body in a later snapshot is new.
		const bool appears = continues && (known == _tracks.end() || known->second.motions.life() == 0);
		BodyMotion motion = BodyMotion::rest(id, tick, decoder.pose(i), appears);
		add(motion);
		_tracks.find(id)->second.snapshot = _snapshot;
	}
	for (auto &entry : _tracks) {
		const MotionTrack &track = entry.second.motions;
		if (entry.second.snapshot != _snapshot && (track.life() != 0 || !track.is_over(tick))) {
			BodyMotion motion = BodyMotion::removal(entry.first, tick);
			add(entry, motion);
		}
	}
}

void BodyTracks::restart(double tick) {
	for (auto &entry : _tracks) {
		entry.second.motions.restart();
		mark_busy(entry);
	}
	for (auto &end : _ends) {
		end.second.tick = tick;
	}
	_ends_checked = tick;
}

void BodyTracks::advance(double tick, double end_memory) {
	_end_memory = end_memory;
	size_t kept = 0;
	for (Tracks::value_type *entry : _busy) {
		MotionTrack &track = entry->second.motions;
		_capacity -= track.capacity();
		track.forget_before(tick);
		_capacity += track.capacity();
		if (track.is_over(tick)) {
			erase(entry->first);
		} else if (track.is_settled()) {
			entry->second.is_busy = false;
		} else {
			_busy[kept++] = entry;
		}
	}
	_busy.resize(kept);
	if (tick - _ends_checked > END_CHECK_INTERVAL * end_memory) {
		_ends_checked = tick;
		for (auto end = _ends.begin(); end != _ends.end();) {
			end = tick - end->second.tick > end_memory ? _ends.erase(end) : std::next(end);
		}
	}
}

const MotionTrack *BodyTracks::find(uint32_t id) const {
	const auto found = _tracks.find(id);
	return found != _tracks.end() ? &found->second.motions : nullptr;
}

BodyEnd BodyTracks::end(uint32_t id, uint64_t life, double tick) const {
	const auto found = _ends.find(life);
	const bool is_recent = found != _ends.end() && found->second.id == id && found->second.tick <= tick && tick - found->second.tick <= _end_memory;
	return is_recent ? found->second.kind : BodyEnd::NONE;
}

std::optional<cga::Pose<double>> BodyTracks::last_pose(uint32_t id, uint64_t life) const {
	const auto found = _ends.find(life);
	return found != _ends.end() && found->second.id == id ? found->second.pose : std::nullopt;
}

std::vector<uint32_t> BodyTracks::bodies(double tick) const {
	std::vector<uint32_t> ids;
	for (const auto &entry : _tracks) {
		if (entry.second.motions.pose_at(tick)) {
			ids.push_back(entry.first);
		}
	}
	return ids;
}

} // namespace net
