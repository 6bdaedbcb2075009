#include "net/endpoint/receiver.hpp"

#include <algorithm>
#include <cmath>

namespace net {

namespace {

/// After this many seconds without progress, the receiver requests a snapshot every REQUEST_INTERVAL.
constexpr double SILENCE = 1.5;
constexpr double LONG_SILENCE = 4.0;
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
/// Work of decoding a snapshot, for each of its bytes, if its bodies have two.
constexpr size_t SNAPSHOT_WORK_PER_BYTE = NEW_BODY_WORK / 2;
/// Bytes of a usual body in a snapshot.
constexpr size_t USUAL_BODY_BYTES = 32;
/// Numbers of items in a packet and of bytes in a window of few bodies that are usual.
constexpr size_t USUAL_ITEMS = 1024;
constexpr size_t USUAL_WINDOW_BYTES = 32768;
constexpr double MAX_TICK = double(uint64_t(1) << (8 * SnapshotHeader::TICK_BYTES));
/// Known motion may be so many seconds further ahead of playback than its maximum delay.
constexpr double MAX_AHEAD = 10.0;
/// The same in ticks: then a track holds all motion from playback on, and the next window.
constexpr double MAX_TICKS_AHEAD = double(MotionTrack::MAX_SEGMENTS - MAX_TICKS);
/// Maximum of the playback delay, in ticks. The rest of MAX_TICKS_AHEAD is for playback that is behind its target.
constexpr double MAX_DELAY_TICKS = MAX_TICKS_AHEAD - 1.5 * 1024.0;
static_assert(MAX_DELAY_TICKS > MAX_LATENCY_TICKS);

} // namespace

PacketResult Receiver::accept(const uint8_t *packet, size_t size, double now) {
	now = _local_clock.advance(now);
	_budget.refill(now, body_count());
	if (_budget.is_refused()) {
		return {}; // `refuse` has reported it
	}
	free_unusual_memory();
	PacketResult result = read_packet(packet, size, _content);
	_budget.spend_items(1 + _content.chunks.size() + _content.fragments.size() + _content.ack_count);
	if (_budget.is_exceeded()) {
		return refuse(now);
	}
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
	const size_t present = _chunks.present();
	for (const ChunkItem &chunk : _content.chunks) {
		_ack_due = true;
		_chunk_time = now;
		if (const auto number = _chunks.add(chunk)) {
			count_loss(*number, &chunk - _content.chunks.data() + 1 < copies, now);
		}
	}
	if (_chunks.present() > present) {
		_progress_time = now; // over a slow line, a window takes long
	}
	for (const FragmentItem &fragment : _content.fragments) {
		_snapshot_ack_due = true;
		take_fragment(fragment, now);
	}
	if (_budget.is_exceeded()) {
		return refuse(now);
	}
	return decode(now, true);
}

PacketResult Receiver::decode(double now, bool is_prompt) {
	bool waits = false;
	if (_fragments.is_complete()) {
		// A costly snapshot waits for the end of the frame: if its packets are part of a flood, it is not decoded at all.
		waits = _budget.must_wait() || (is_prompt && _budget.is_costly(SNAPSHOT_WORK_PER_BYTE * _fragments.size()));
		if (const PacketResult result = waits ? PacketResult() : finish_snapshot(now); !result) {
			++_statistics.packets_rejected;
			return result;
		}
	}
	set_limits();
	waits = !decode_windows(now) || waits;
	_budget.note_waiting(waits, now);
	if (waits) {
		_progress_time = now;
	}
	return {};
}

/// Frees what an unusual packet or window has made buffers allocate.
void Receiver::free_unusual_memory() {
	if (std::max(_content.chunks.capacity(), _content.fragments.capacity()) > USUAL_ITEMS) {
		_content = PacketContent();
	}
	if (_motions.capacity() > USUAL_ITEMS + 4 * body_count()) {
		std::vector<BodyMotion>().swap(_motions);
	}
	if (_window.capacity() > USUAL_WINDOW_BYTES + 64 * body_count()) {
		std::vector<uint8_t>().swap(_window);
	}
}

PacketResult Receiver::refuse(double now) {
	_budget.refuse(now);
	_chunks.forget();
	_fragments = FragmentBuffer();
	_broken = true;
	++_statistics.packets_rejected;
	return PacketError::TOO_MUCH_WORK;
}

bool Receiver::must_wait(double now) const {
	return _budget.must_wait() || known_time() - _clock.media_time_at(now) > std::min(max_delay() + MAX_AHEAD, MAX_TICKS_AHEAD * tick());
}

void Receiver::set_max_bodies(size_t max_bodies) {
	_max_bodies = max_bodies;
	_bodies.set_max_bodies(max_bodies);
	if (_decoder) {
		_decoder->set_max_bodies(max_bodies);
	}
}

size_t Receiver::held_bodies() const {
	return body_count() + _fragments.size() / USUAL_BODY_BYTES;
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
		if (fragment.index >= fragment.count || fragment.size == 0) {
			return PacketError::BAD_FRAGMENT;
		}
		if (fragment.count > max_count) {
			return PacketError::TOO_MANY_BODIES;
		}
		if (fragment.index + 1 < fragment.count && fragment.size < MIN_FRAGMENT_BYTES) {
			return PacketError::BAD_FRAGMENT;
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
		if (!_budget.begin_snapshot()) {
			return;
		}
		_snapshot_done = false;
		_fragments.start(fragment);
		_chunks.expect(fragment.next_chunk);
	}
	if (_fragments.add(fragment)) {
		_progress_time = _fragment_time = now;
	}
}

PacketResult Receiver::finish_snapshot(double now) {
	std::vector<uint8_t> bytes;
	_fragments.finish(bytes);
	_budget.spend_work(SNAPSHOT_WORK + bytes.size() / BYTES_PER_WORK);
	const auto next = read_snapshot_header(bytes.data(), bytes.size());
	if (!next) {
		_other_version = bytes.empty() ? 0 : bytes[0];
		return next.error();
	}
	if (is_behind(*next)) {
		_snapshot_done = true;
		return {};
	}
	StreamDecoder decoder(float(next->settings.position_tolerance), float(next->settings.rotation_tolerance), _max_bodies);
	const PacketResult result = decoder.read_snapshot(bytes.data() + next->bytes(), bytes.size() - next->bytes());
	_budget.spend_work(decoder.work());
	if (!result) {
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
		_bodies.restart(media_time() / tick());
	}
	set_limits();
	_clock.observe(known_time(), known_time(), now);
	_chunks.restart(_fragments.next_chunk());
	if (!continues || int16_t(_newest_chunk - _fragments.next_chunk()) < 0) {
		_newest_chunk = uint16_t(_fragments.next_chunk() - 1);
	}
	_bodies.show_snapshot(*_decoder, _window_end, continues);
	return {};
}

bool Receiver::is_next_snapshot() const {
	return uint8_t(_fragments.number() - _last_snapshot) <= MAX_SNAPSHOTS_MISSED;
}

bool Receiver::is_behind(const SnapshotHeader &next) const {
	// The snapshot arrived so late that the windows after it have already been decoded.
	return is_ready() && !_broken && is_next_snapshot() && double(next.tick) <= _window_end && double(next.tick) >= _window_end - MAX_TICKS &&
			next.settings.is_same_stream(_header.settings);
}

bool Receiver::decode_windows(double now) {
	bool waits = false;
	while (is_ready() && !_broken) {
		waits = must_wait(now);
		const auto check = waits ? std::nullopt : _chunks.take_window(_window);
		if (!check) {
			break;
		}
		const auto ticks = _decoder->decode_window(_window.data(), _window.size(), *check, _window_end, _header.settings.mode, _motions);
		_budget.spend_work(_decoder->work());
		// A snapshot could not name a later tick.
		if (!ticks || _window_end > MAX_TICK - MAX_TICKS) {
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
			_bodies.add(motion);
		}
		_clock.observe(moves_from * tick(), known_time(), now);
		if (!_motions.empty()) {
			if (_clock.media_time() > begin * tick()) {
				++_statistics.late_windows;
			}
		}
	}
	_broken = _broken || _chunks.is_broken();
	if (_broken) {
		_chunks.forget();
	}
	return !waits;
}

void Receiver::encode_snapshot(std::vector<uint8_t> &bytes) {
	SnapshotHeader header = _header;
	header.tick = uint64_t(_window_end);
	put_snapshot_header(bytes, header);
	_decoder->encode_snapshot(bytes);
}

double Receiver::max_delay() const {
	const double latency = _header.settings.max_latency;
	return std::min(std::max(latency, double(_header.window)) + (_max_margin < 0.0 ? latency : _max_margin), MAX_DELAY_TICKS * tick());
}

void Receiver::set_limits() {
	_clock.set_limits(std::min(std::max(_min_margin, usual_delay()), max_delay()), max_delay());
}

bool Receiver::needs_snapshot(double now) const {
	if (_budget.is_refused()) {
		return false;
	}
	if (_fragments.is_open() && now - _fragment_time < FRAGMENT_TIMEOUT) {
		return false;
	}
	// While later chunks arrive, the sender knows what is missing, and repeats it.
	const bool is_alive = _chunks.size() > 0 && now - _chunk_time < SILENCE;
	const double max_silence = !is_ready() && !_fragments.is_open() ? REQUEST_INTERVAL : (is_alive ? LONG_SILENCE : SILENCE);
	return _broken || (_has_heard && now - _progress_time > max_silence);
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

PacketResult Receiver::decode_waiting(double now) {
	now = _local_clock.advance(now);
	_budget.refill(now, body_count());
	return _budget.is_waiting() ? decode(now, false) : PacketResult();
}

void Receiver::advance(double now) {
	(void)decode_waiting(now);
	now = _local_clock.advance(now);
	if (!is_ready()) {
		return;
	}
	_clock.advance(now);
	_bodies.advance(media_time() / tick(), END_MEMORY / tick());
	_statistics.playback_delay = _clock.delay_at(now);
	_statistics.jitter = _clock.jitter();
}

std::optional<cga::Pose<double>> Receiver::pose_at(uint32_t id, double media_time) const {
	const MotionTrack *track = _bodies.find(id);
	return track != nullptr && !std::isnan(media_time) ? track->pose_at(media_time / tick()) : std::nullopt;
}

std::optional<ShownBody> Receiver::shown(uint32_t id) const {
	const MotionTrack *track = _bodies.find(id);
	const double tick = media_time() / this->tick();
	const BodyMotion *motion = track != nullptr ? track->motion_at(tick) : nullptr;
	return motion != nullptr ? std::optional(ShownBody{ motion->segment.pose_at(tick), motion->life, motion->segment.begin > tick || _clock.is_waiting() }) : std::nullopt;
}

std::optional<ShownBody> Receiver::first_known(uint32_t id, uint64_t min_life) const {
	const MotionTrack *track = _bodies.find(id);
	const double tick = media_time() / this->tick();
	const BodyMotion *motion = track != nullptr ? track->first_motion(tick, min_life) : nullptr;
	return motion != nullptr ? std::optional(ShownBody{ motion->segment.pose_at(tick), motion->life }) : std::nullopt;
}

uint64_t Receiver::life_at_known_end(uint32_t id) const {
	const MotionTrack *track = _bodies.find(id);
	return track != nullptr ? track->life() : 0;
}

void Receiver::set_margin_limits(double min, double max) {
	_min_margin = std::fmin(std::fmax(min, DELAY_RANGE.min), DELAY_RANGE.max);
	_max_margin = std::fmin(std::fmax(max, _min_margin), DELAY_RANGE.max);
	set_limits();
}

} // namespace net
