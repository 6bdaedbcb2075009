#include "net/receiver.hpp"

#include "net/delivery/chunk_buffer.hpp"
#include "net/delivery/playback_clock.hpp"
#include "net/delivery/state_parts.hpp"
#include "net/motion/motion_track.hpp"
#include "net/stream/state_header.hpp"
#include "net/stream/stream_decoder.hpp"

#include <algorithm>
#include <unordered_map>

namespace net {

namespace {

/// A stream that has told nothing new for so long is asked for its state, in seconds; a request is repeated after PAUSE.
constexpr double SILENCE = 1.5;
constexpr double PAUSE = 0.25;
/// While parts of a state have come within so long, it is waited for.
constexpr double PART_PAUSE = 0.75;
/// A state that is older than the last one is a straggler, unless nothing new has come for so long: then it is that of a
/// sender that began again.
constexpr double STRAGGLERS = 1.0;
/// One whose number is further on than this is that of another sender, if it is of an earlier time.
constexpr uint8_t MAX_STATES_MISSED = 32;
/// Weight of a chunk in the estimate of loss.
constexpr double LOSS_WEIGHT = 1.0 / 32.0;
/// Bytes that a body takes in a state at most, and the models.
constexpr size_t BODY_BYTES = 96;
constexpr size_t MODEL_BYTES = 8192;

} // namespace

struct Receiver::State {
	explicit State(size_t most_bodies) :
			most_bodies(most_bodies) {}

	size_t most_bodies;
	PacketContent content;
	ChunkBuffer chunks;
	std::unique_ptr<StreamDecoder> decoder; // null before the first state
	StateHeader header;
	double window_end = 0.0; // ticks
	PlaybackClock clock;
	std::unordered_map<uint32_t, MotionTrack> tracks;
	std::vector<BodyEvent> events;
	std::vector<BodyMotion> motions;
	std::vector<uint8_t> window;

	StateParts parts; // of the state that is arriving, or the last one
	bool state_done = false; // the last one has been read
	uint8_t last_state = 0; // number of the one before
	bool broken = false; // the stream cannot be followed without a new state
	bool answer_due = false;
	bool state_ack_due = false;
	bool has_heard = false;
	double progressed = 0.0; // when something new came: a window, a part of a state, at first anything
	double part_came = -1e9; // when a part of the open state came that was lacking
	double asked = -1e9;
	double least_margin = 0.0;
	double most_margin = -1.0; // negative: as much as max_latency
	StreamStatistics statistics;

	uint8_t newest_chunk = 0;

	void count_loss(uint8_t number, bool is_new);
	const char *check_parts() const;
	void take_part(const StatePartItem &part, double now);
	const char *finish_state(double now);
	[[nodiscard]] bool is_next_state() const { return uint8_t(parts.number() - last_state) <= MAX_STATES_MISSED; }
	[[nodiscard]] bool is_behind(const StateHeader &next) const;
	[[nodiscard]] bool is_lost(double now) const;
	void decode_windows(double now);
	void show(const BodyMotion &motion);
	void set_limits();
	/// The latency that was asked for, whatever is needed at the moment: windows may become longer, and chunks get lost.
	[[nodiscard]] double usual_delay() const { return std::max(header.settings.max_latency - FRAME, 0.0); }
	[[nodiscard]] double tick() const { return header.settings.tick; }
};

Receiver::Receiver(size_t most_bodies) :
		_state(std::make_unique<State>(most_bodies)) {}

Receiver::~Receiver() = default;

const char *Receiver::accept(const uint8_t *packet, size_t size, double now) {
	State &s = *_state;
	const char *error = read_packet(packet, size, s.content);
	if (error == nullptr) {
		error = s.check_parts();
	}
	if (error != nullptr) {
		++s.statistics.packets_rejected;
		return error;
	}
	s.statistics.bytes_received += size;
	++s.statistics.packets_received;
	if (!s.has_heard) {
		s.has_heard = true;
		s.progressed = now;
	}
	if (s.content.round_trip > 0.0) {
		s.statistics.round_trip = s.content.round_trip;
	}
	for (const ChunkItem &chunk : s.content.chunks) {
		s.answer_due = true;
		uint8_t number = 0;
		const bool is_new = s.chunks.add(chunk, number);
		s.count_loss(number, is_new);
	}
	for (const StatePartItem &part : s.content.parts) {
		s.state_ack_due = true;
		s.take_part(part, now);
	}
	if (s.parts.is_complete()) {
		error = s.finish_state(now);
		if (error != nullptr) {
			++s.statistics.packets_rejected;
			return error;
		}
	}
	s.set_limits();
	s.decode_windows(now);
	return nullptr;
}

void Receiver::State::count_loss(uint8_t number, bool is_new) {
	if (!is_new) {
		return;
	}
	// One that comes after a later one was lost, or was overtaken.
	const bool is_late = int8_t(number - newest_chunk) < 0;
	statistics.loss += ((is_late ? 1.0 : 0.0) - statistics.loss) * LOSS_WEIGHT;
	newest_chunk = is_late ? newest_chunk : number;
}

const char *Receiver::State::check_parts() const {
	const size_t most_parts = (most_bodies * BODY_BYTES + MODEL_BYTES) / StateSnapshot::PART_BYTES + 1;
	for (const StatePartItem &part : content.parts) {
		if (part.parts == 0 || part.part >= part.parts || part.size == 0) {
			return "a state's part has a wrong number";
		}
		if (part.parts > most_parts) {
			return "the stream has more bodies than are expected";
		}
	}
	return nullptr;
}

void Receiver::State::take_part(const StatePartItem &part, double now) {
	if (state_done && part.state == parts.number()) {
		return;
	}
	if ((parts.is_open() || state_done) && int8_t(part.state - parts.number()) < 0 && now - progressed < STRAGGLERS) {
		return;
	}
	if (!parts.belongs(part)) {
		state_done = false;
		parts.start(part);
	}
	if (parts.add(part)) {
		progressed = part_came = now;
	}
}

const char *Receiver::State::finish_state(double now) {
	parts.close(window);
	StateHeader next;
	const char *error = read_state_header(window.data(), window.size(), next);
	if (error != nullptr) {
		return error;
	}
	if (is_behind(next)) {
		state_done = true;
		return nullptr;
	}
	auto fresh = std::make_unique<StreamDecoder>(float(next.settings.position_tolerance), float(next.settings.rotation_tolerance), most_bodies);
	if (!fresh->read_state(window.data() + StateHeader::BYTES, window.size() - StateHeader::BYTES)) {
		return "the state cannot be read";
	}
	const bool is_first = decoder == nullptr;
	const bool is_earlier = double(next.tick) < window_end;
	const bool goes_on = !is_first && next.settings.tick == tick() && (!is_earlier || (is_next_state() && double(next.tick) >= window_end - MAX_TICKS));
	header = next;
	decoder = std::move(fresh);
	window_end = double(header.tick);
	state_done = true;
	last_state = parts.number();
	broken = false;
	if (!goes_on) {
		clock.start(window_end * tick(), std::max(double(header.window), usual_delay()), now);
		for (auto &track : tracks) {
			track.second = MotionTrack();
		}
	}
	set_limits();
	clock.observe(window_end * tick(), now);
	chunks.restart(parts.next_chunk());
	if (!goes_on || int8_t(newest_chunk - parts.next_chunk()) < 0) {
		newest_chunk = uint8_t(parts.next_chunk() - 1);
	}
	// Bodies of the state are there from now on; those that are not in it have gone.
	std::unordered_map<uint32_t, bool> present;
	for (size_t i = 0; i < decoder->body_count(); ++i) {
		BodyMotion motion;
		motion.id = decoder->id(i);
		motion.segment.begin = window_end;
		motion.segment.from = decoder->pose(i);
		const auto track = tracks.find(motion.id);
		// At the first state a body has been there before; later, one that nobody knew has appeared.
		motion.appears = goes_on && (track == tracks.end() || track->second.is_empty());
		present[motion.id] = true;
		show(motion);
	}
	for (auto &track : tracks) {
		if (present.count(track.first) == 0) {
			BodyMotion motion;
			motion.id = track.first;
			motion.vanishes = true;
			motion.segment.begin = window_end;
			track.second.add(motion);
		}
	}
	return nullptr;
}

bool Receiver::State::is_behind(const StateHeader &next) const {
	// It came so late that the windows after it have been decoded, with what was there before.
	return decoder != nullptr && !broken && is_next_state() && double(next.tick) <= window_end && double(next.tick) >= window_end - MAX_TICKS &&
			next.settings.is_same_stream(header.settings);
}

void Receiver::State::show(const BodyMotion &motion) {
	const auto entry = tracks.try_emplace(motion.id);
	if (entry.second) {
		events.push_back({ BodyEvent::ADDED, motion.id });
	}
	entry.first->second.add(motion);
}

void Receiver::State::decode_windows(double now) {
	uint8_t check = 0;
	uint8_t check_mask = 0;
	if (broken) {
		return;
	}
	while (decoder != nullptr && !broken && chunks.take_window(window, check, check_mask)) {
		int ticks = 0;
		if (!decoder->decode_window(window.data(), window.size(), check, check_mask, window_end, header.settings.mode, motions, ticks)) {
			broken = true;
			break;
		}
		progressed = now;
		const double begin = window_end;
		window_end += ticks;
		clock.observe(window_end * tick(), now);
		double moves_from = window_end;
		for (const BodyMotion &motion : motions) {
			moves_from = std::min(moves_from, motion.segment.begin);
			show(motion);
		}
		if (!motions.empty()) {
			clock.observe_motion(moves_from * tick(), now);
			if (clock.media_time() > begin * tick()) {
				++statistics.late_windows;
			}
		}
	}
	broken = broken || chunks.is_broken() || tracks.size() > 2 * most_bodies + 64;
	if (events.size() > 8 * most_bodies + 64) {
		// Nobody takes them: the oldest half is of no use any more.
		events.erase(events.begin(), events.begin() + ptrdiff_t(events.size() / 2));
	}
	if (broken) {
		chunks.forget(); // what waited may be as wrong
	}
}

void Receiver::State::set_limits() {
	const double most = std::max(header.settings.max_latency, double(header.window)) + (most_margin < 0.0 ? header.settings.max_latency : most_margin);
	clock.set_limits(std::min(std::max(least_margin, usual_delay()), most), most);
}

bool Receiver::State::is_lost(double now) const {
	if (parts.is_open() && now - part_came < PART_PAUSE) {
		return false;
	}
	return broken || (has_heard && now - progressed > (decoder == nullptr && !parts.is_open() ? PAUSE : SILENCE));
}

bool Receiver::take_answer(std::vector<uint8_t> &packet, double now) {
	State &s = *_state;
	packet.clear();
	if (s.is_lost(now) && now - s.asked > PAUSE) {
		s.asked = now;
		put_state_wish(packet);
	}
	if (s.state_ack_due) {
		put_state_ack(packet, s.parts.ack(s.state_done));
		s.state_ack_due = false;
	}
	if (s.answer_due && s.decoder != nullptr && !s.broken) {
		put_ack(packet, s.chunks.ack());
	}
	s.answer_due = false;
	return !packet.empty();
}

bool Receiver::is_ready() const {
	return _state->decoder != nullptr;
}

void Receiver::advance(double now) {
	State &s = *_state;
	if (s.decoder == nullptr) {
		return;
	}
	s.clock.advance(now);
	const double tick = s.clock.media_time() / s.tick();
	for (auto track = s.tracks.begin(); track != s.tracks.end();) {
		track->second.forget_before(tick);
		if (track->second.is_over(tick)) {
			s.events.push_back({ BodyEvent::REMOVED, track->first });
			track = s.tracks.erase(track);
		} else {
			++track;
		}
	}
	s.statistics.playback_delay = s.clock.delay_at(now);
	s.statistics.jitter = s.clock.jitter();
}

double Receiver::media_time() const {
	return _state->clock.media_time();
}

double Receiver::media_time_at(double now) const {
	return _state->clock.media_time_at(now);
}

double Receiver::known_time() const {
	return _state->window_end * _state->tick();
}

bool Receiver::pose(uint32_t id, cga::Pose<double> &pose) const {
	return pose_at(id, media_time(), pose);
}

bool Receiver::pose_at(uint32_t id, double media_time, cga::Pose<double> &pose) const {
	const auto track = _state->tracks.find(id);
	return track != _state->tracks.end() && track->second.pose_at(media_time / _state->tick(), pose);
}

void Receiver::bodies(std::vector<uint32_t> &ids) const {
	ids.clear();
	cga::Pose<double> pose;
	for (const auto &track : _state->tracks) {
		if (track.second.pose_at(_state->clock.media_time() / _state->tick(), pose)) {
			ids.push_back(track.first);
		}
	}
}

void Receiver::take_events(std::vector<BodyEvent> &events) {
	events.clear();
	events.swap(_state->events);
}

void Receiver::set_margin_limits(double least, double most) {
	_state->least_margin = std::max(least, 0.0);
	_state->most_margin = std::max(most, _state->least_margin);
	_state->set_limits();
}

const StreamSettings &Receiver::settings() const {
	return _state->header.settings;
}

StreamStatistics Receiver::statistics() const {
	return _state->statistics;
}

} // namespace net
