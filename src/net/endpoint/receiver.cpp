#include "net/endpoint/receiver.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_set>

namespace net {

namespace {

/// After this many seconds without progress, the receiver requests a snapshot every REQUEST_INTERVAL.
constexpr double SILENCE = 1.5;
constexpr double REQUEST_INTERVAL = 0.25;
/// The receiver waits for the rest of a snapshot while the gaps between its fragments are shorter than this.
constexpr double FRAGMENT_TIMEOUT = 0.75;
/// A snapshot older than the last one is a late duplicate, unless the stream has been silent for this long: then the sender
/// has restarted.
constexpr double RESTART_SILENCE = 1.0;
/// A snapshot whose number is further ahead than this and whose time is earlier comes from another sender.
constexpr uint8_t MAX_SNAPSHOTS_MISSED = 32;
/// A chunk that arrives this many seconds after a newer one was not lost.
constexpr double MAX_REORDERING = 0.02;
/// Weight of one chunk in the moving average of the loss.
constexpr double LOSS_WEIGHT = 1.0 / 32.0;
/// Minimum size of a fragment of a snapshot, except the last.
constexpr size_t MIN_FRAGMENT_BYTES = 200;
/// Maximum size of a body in a snapshot and of the models.
constexpr size_t BODY_BYTES = 96;
constexpr size_t MODEL_BYTES = 8192;
/// Maximum number of ends of lives that are kept.
constexpr size_t MAX_ENDS = 32768;

uint64_t next_life() {
	static uint64_t last_life = 0;
	return ++last_life;
}

} // namespace

PacketResult Receiver::accept(const uint8_t *packet, size_t size, double now) {
	now = _local_clock.advance(now);
	PacketResult result = read_packet(packet, size, _content);
	if (result) {
		result = check_fragments();
	}
	if (!result) {
		++_statistics.packets_rejected;
		return result;
	}
	_clock.observe_packet(now);
	_statistics.bytes_received += size;
	++_statistics.packets_received;
	if (!_has_heard) {
		_has_heard = true;
		_progress_time = now;
	}
	if (_content.round_trip > 0.0) {
		_statistics.round_trip = _content.round_trip;
	}
	const auto newest_window = std::find_if(_content.chunks.rbegin(), _content.chunks.rend(), [](const ChunkItem &chunk) { return chunk.first; });
	const auto copies = _content.chunks.rend() - newest_window; // chunks up to the newest window's first
	for (const ChunkItem &chunk : _content.chunks) {
		_ack_due = true;
		if (const auto number = _chunks.add(chunk)) {
			count_loss(*number, &chunk - _content.chunks.data() + 1 < copies, now);
		}
	}
	for (const FragmentItem &fragment : _content.fragments) {
		_snapshot_ack_due = true;
		take_fragment(fragment, now);
	}
	if (_fragments.is_complete()) {
		result = finish_snapshot(now);
		if (!result) {
			++_statistics.packets_rejected;
			return result;
		}
	}
	set_limits();
	decode_windows(now);
	return {};
}

void Receiver::count_loss(uint16_t number, bool is_copy, double now) {
	// A chunk that arrives after a newer one was retransmitted or reordered.
	const bool is_late = is_copy || int16_t(number - _newest_chunk) < 0;
	_statistics.loss += ((is_late ? 1.0 : 0.0) - _statistics.loss) * LOSS_WEIGHT;
	if (is_late && (is_copy || now - _newest_chunk_time > MAX_REORDERING)) {
		_clock.observe_loss(_statistics.loss, now);
	}
	if (int16_t(number - _newest_chunk) >= 0) {
		_newest_chunk = number;
		_newest_chunk_time = now;
	}
}

PacketResult Receiver::check_fragments() {
	const size_t max_bytes = _max_bodies * BODY_BYTES + MODEL_BYTES;
	const size_t max_count = max_bytes / MIN_FRAGMENT_BYTES + 1;
	for (const FragmentItem &fragment : _content.fragments) {
		if (fragment.count == 0 || fragment.index >= fragment.count || fragment.size == 0) {
			return PacketError::BAD_FRAGMENT;
		}
		if (fragment.count > max_count) {
			return PacketError::TOO_MANY_BODIES;
		}
		if (_fragments.belongs(fragment) && _fragments.size() + fragment.size > max_bytes) {
			_refused_size = _max_bodies + 1;
			return PacketError::TOO_MANY_BODIES;
		}
	}
	return {};
}

void Receiver::take_fragment(const FragmentItem &fragment, double now) {
	const bool is_stale = (_fragments.is_open() || _snapshot_done) && int8_t(fragment.snapshot - _fragments.number()) < 0 && now - _progress_time < RESTART_SILENCE;
	if (is_stale || (_snapshot_done && fragment.snapshot == _fragments.number())) {
		return;
	}
	if (!_fragments.belongs(fragment)) {
		_snapshot_done = false;
		_fragments.start(fragment);
		_chunks.expect(fragment.next_chunk);
	}
	if (_fragments.add(fragment)) {
		_progress_time = _fragment_time = now;
	}
}

PacketResult Receiver::finish_snapshot(double now) {
	_fragments.finish(_window);
	const auto next = read_snapshot_header(_window.data(), _window.size());
	if (!next) {
		return next.error();
	}
	if (is_behind(*next)) {
		_snapshot_done = true;
		return {};
	}
	StreamDecoder decoder(float(next->settings.position_tolerance), float(next->settings.rotation_tolerance), _max_bodies);
	if (const PacketResult result = decoder.read_snapshot(_window.data() + next->bytes(), _window.size() - next->bytes()); !result) {
		_refused_size = result.error() == PacketError::TOO_MANY_BODIES ? decoder.declared_count() : 0;
		return result;
	}
	const bool is_earlier = double(next->tick) < _window_end;
	const bool continues = is_ready() && next->settings.tick == tick() && (!is_earlier || (is_next_snapshot() && double(next->tick) >= _window_end - MAX_TICKS));
	_header = *next;
	_decoder = std::move(decoder);
	++_snapshot_count;
	_refused_size = 0;
	_window_end = double(next->tick);
	_snapshot_done = true;
	_last_snapshot = _fragments.number();
	_broken = false;
	if (!continues) {
		_clock.start(known_time(), std::max(double(next->window), usual_delay()), now);
		for (auto &track : _tracks) {
			track.second.restart();
		}
		for (auto &end : _ends) {
			end.second.tick = _clock.media_time() / tick();
		}
	}
	set_limits();
	_clock.observe(known_time(), known_time(), now);
	_chunks.restart(_fragments.next_chunk());
	if (!continues || int16_t(_newest_chunk - _fragments.next_chunk()) < 0) {
		_newest_chunk = uint16_t(_fragments.next_chunk() - 1);
	}
	show_snapshot(continues);
	return {};
}

/// Bodies in the snapshot exist from its time on; all others do not.
void Receiver::show_snapshot(bool continues) {
	std::unordered_set<uint32_t> present;
	for (size_t i = 0; i < _decoder->body_count(); ++i) {
		const uint32_t id = _decoder->id(i);
		const auto track = _tracks.find(id);
		// Bodies in the first snapshot already existed. An unknown body in a later snapshot is new.
		const bool appears = continues && (track == _tracks.end() || track->second.life() == 0);
		present.insert(id);
		BodyMotion motion = BodyMotion::rest(id, _window_end, _decoder->pose(i), appears);
		show(motion);
	}
	for (auto &track : _tracks) {
		if (present.count(track.first) == 0) {
			BodyMotion motion = BodyMotion::removal(track.first, _window_end);
			add(track.second, motion);
		}
	}
}

bool Receiver::is_next_snapshot() const {
	return uint8_t(_fragments.number() - _last_snapshot) <= MAX_SNAPSHOTS_MISSED;
}

bool Receiver::is_behind(const SnapshotHeader &next) const {
	// The snapshot arrived so late that the windows after it have already been decoded.
	return is_ready() && !_broken && is_next_snapshot() && double(next.tick) <= _window_end && double(next.tick) >= _window_end - MAX_TICKS &&
			next.settings.is_same_stream(_header.settings);
}

void Receiver::show(BodyMotion &motion) {
	const auto entry = _tracks.try_emplace(motion.id);
	if (entry.second) {
		_events.push_back({ BodyEvent::ADDED, motion.id });
	}
	add(entry.first->second, motion);
}

/// Assigns the motion to a life and appends it to the body's track.
void Receiver::add(MotionTrack &track, BodyMotion &motion) {
	const bool is_new = motion.appears && !motion.jumps;
	motion.life = track.life();
	if (motion.life != 0 && (is_new || motion.vanishes)) {
		const BodyMotion *last = track.motion_at(motion.segment.begin);
		_ends[motion.life] = { motion.id, motion.freed ? BodyEnd::FREED : BodyEnd::REMOVED, motion.segment.begin, last != nullptr ? std::optional(last->segment.pose_at(motion.segment.begin)) : std::nullopt };
		if (_ends.size() > MAX_ENDS) {
			_ends.erase(_ends.begin());
		}
	}
	if (!motion.vanishes && (is_new || motion.life == 0)) {
		motion.life = next_life();
	}
	track.add(motion);
}

void Receiver::decode_windows(double now) {
	if (_broken) {
		return;
	}
	while (is_ready() && !_broken) {
		const auto check = _chunks.take_window(_window);
		if (!check) {
			break;
		}
		const auto ticks = _decoder->decode_window(_window.data(), _window.size(), *check, _window_end, _header.settings.mode, _motions);
		if (!ticks) {
			_broken = true;
			break;
		}
		if (_record) {
			_record->push_window(_window, _decoder->check(), *ticks * tick(), _record_size, _record_needed);
		}
		_progress_time = now;
		const double begin = _window_end;
		_window_end += *ticks;
		double moves_from = _window_end;
		for (BodyMotion &motion : _motions) {
			moves_from = std::min(moves_from, motion.segment.begin);
			show(motion);
		}
		_clock.observe(moves_from * tick(), known_time(), now);
		if (!_motions.empty()) {
			if (_clock.media_time() > begin * tick()) {
				++_statistics.late_windows;
			}
		}
	}
	_broken = _broken || _chunks.is_broken() || _tracks.size() > 2 * _max_bodies + 64;
	if (_events.size() > 8 * _max_bodies + 64) {
		// The caller does not call take_events(): drop the older half.
		_events.erase(_events.begin(), _events.begin() + ptrdiff_t(_events.size() / 2));
	}
	if (_broken) {
		_chunks.forget();
	}
}

void Receiver::encode_snapshot(std::vector<uint8_t> &bytes) {
	SnapshotHeader header = _header;
	header.tick = uint64_t(_window_end);
	put_snapshot_header(bytes, header);
	_decoder->encode_snapshot(bytes);
}

void Receiver::set_limits() {
	const double latency = _header.settings.max_latency;
	const double max_delay = std::max(latency, double(_header.window)) + (_max_margin < 0.0 ? latency : _max_margin);
	_clock.set_limits(std::min(std::max(_min_margin, usual_delay()), max_delay), max_delay);
}

bool Receiver::needs_snapshot(double now) const {
	if (_fragments.is_open() && now - _fragment_time < FRAGMENT_TIMEOUT) {
		return false;
	}
	return _broken || (_has_heard && now - _progress_time > (!is_ready() && !_fragments.is_open() ? REQUEST_INTERVAL : SILENCE));
}

void Receiver::take_ack(std::vector<uint8_t> &packet, double now) {
	now = _local_clock.advance(now);
	packet.clear();
	if (needs_snapshot(now) && now - _request_time > REQUEST_INTERVAL) {
		_request_time = now;
		put_snapshot_request(packet);
	}
	if (_snapshot_ack_due) {
		put_snapshot_ack(packet, _fragments.ack(_snapshot_done));
		_snapshot_ack_due = false;
	}
	if (_ack_due && is_ready() && !_broken) {
		AckItem ack = _chunks.ack();
		ack.packets = uint8_t(_statistics.packets_received);
		put_ack(packet, ack);
	}
	_ack_due = false;
}

void Receiver::advance(double now) {
	now = _local_clock.advance(now);
	if (!is_ready()) {
		return;
	}
	_clock.advance(now);
	const double shown = media_time() / tick();
	for (auto track = _tracks.begin(); track != _tracks.end();) {
		track->second.forget_before(shown);
		if (track->second.is_over(shown)) {
			_events.push_back({ BodyEvent::REMOVED, track->first });
			track = _tracks.erase(track);
		} else {
			++track;
		}
	}
	for (auto end = _ends.begin(); end != _ends.end();) {
		end = shown - end->second.tick > END_MEMORY / tick() ? _ends.erase(end) : std::next(end);
	}
	_statistics.playback_delay = _clock.delay_at(now);
	_statistics.jitter = _clock.jitter();
}

std::optional<cga::Pose<double>> Receiver::pose_at(uint32_t id, double media_time) const {
	const auto track = _tracks.find(id);
	return track != _tracks.end() && !std::isnan(media_time) ? track->second.pose_at(media_time / tick()) : std::nullopt;
}

std::optional<ShownBody> Receiver::shown(uint32_t id) const {
	const auto track = _tracks.find(id);
	const double tick = media_time() / this->tick();
	const BodyMotion *motion = track != _tracks.end() ? track->second.motion_at(tick) : nullptr;
	return motion != nullptr ? std::optional(ShownBody{ motion->segment.pose_at(tick), motion->life, motion->segment.begin > tick || _clock.is_waiting() }) : std::nullopt;
}

std::optional<ShownBody> Receiver::first_known(uint32_t id, uint64_t min_life) const {
	const auto track = _tracks.find(id);
	const double tick = media_time() / this->tick();
	const BodyMotion *motion = track != _tracks.end() ? track->second.first_motion(tick, min_life) : nullptr;
	return motion != nullptr ? std::optional(ShownBody{ motion->segment.pose_at(tick), motion->life }) : std::nullopt;
}

BodyEnd Receiver::end(uint32_t id, uint64_t life) const {
	const auto found = _ends.find(life);
	return found != _ends.end() && found->second.id == id && found->second.tick <= media_time() / tick() ? found->second.kind : BodyEnd::NONE;
}

std::optional<cga::Pose<double>> Receiver::last_pose(uint32_t id, uint64_t life) const {
	const auto found = _ends.find(life);
	return found != _ends.end() && found->second.id == id ? found->second.pose : std::nullopt;
}

uint64_t Receiver::life_at_known_end(uint32_t id) const {
	const auto track = _tracks.find(id);
	return track != _tracks.end() ? track->second.life() : 0;
}

std::vector<uint32_t> Receiver::bodies() const {
	std::vector<uint32_t> ids;
	for (const auto &track : _tracks) {
		if (track.second.pose_at(media_time() / tick())) {
			ids.push_back(track.first);
		}
	}
	return ids;
}

void Receiver::set_margin_limits(double min, double max) {
	_min_margin = std::max(min, 0.0);
	_max_margin = std::max(max, _min_margin);
	set_limits();
}

} // namespace net
