#include "net/sender.hpp"

#include "net/delivery/delivery.hpp"
#include "net/stream/state_header.hpp"
#include "net/stream/stream_encoder.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <unordered_map>

namespace net {

namespace {

/// Longest window in which nothing moves, in seconds: it tells receivers that the sender is there.
constexpr double IDLE_WINDOW = 0.5;
/// The shortest window in relation to the longest, whatever the network.
constexpr double MIN_WINDOW = 0.25;
/// Loss from which a window has to leave time for a repeat.
constexpr double NOTABLE_LOSS = 0.004;
constexpr double MAX_STEP = 4.0; ///< ticks between two flushes that count
/// Ticks within which a time is at a tick.
constexpr double SAME_TICK = 1e-5;

/// Any number, the same for the same time.
uint8_t number_from(double time) {
	uint64_t bits = 0;
	std::memcpy(&bits, &time, sizeof(bits));
	return uint8_t((bits ^ bits >> 32) * 0x9e3779b97f4a7c15u >> 56);
}

} // namespace

struct Sender::State {
	struct Peer {
		Delivery delivery;
		uint64_t bytes_sent = 0;
		uint64_t packets_sent = 0;
	};

	explicit State(const StreamSettings &settings) :
			settings(settings) {}

	StreamSettings settings;
	std::unordered_map<uint32_t, cga::Pose<double>> bodies; // the last pose of each
	std::unique_ptr<StreamEncoder> encoder; // only while there are receivers
	ChunkRing ring;
	std::map<uint32_t, Peer> peers;
	std::vector<uint8_t> window;
	std::vector<uint8_t> bytes;
	std::vector<OutgoingPacket> packets;
	PacketContent answer;
	uint8_t state_number = 0; // of the last one; begins anywhere, so that another sender's states are not taken for it
	bool has_state_number = false;
	double time = 0.0; // of the last flush
	double origin = 0.0; // time of tick 0
	bool has_origin = false;
	int64_t window_begin = 0; // ticks
	int64_t last_flush = 0;
	int64_t news_since = -1; // tick; -1: no news
	double step = 1.0; // ticks between flushes

	[[nodiscard]] double ticks(double at) const { return (at - origin) / settings.tick; }
	void begin_at(double first_time);
	void start_encoder();
	[[nodiscard]] double longest_window() const;
	[[nodiscard]] bool is_window_due(int64_t now) const;
	void close_window(int64_t end);
	void give_states();
	void send_all();
};

Sender::Sender(const StreamSettings &settings) :
		_state(std::make_unique<State>(settings)) {}

Sender::~Sender() = default;

bool Sender::add_body(uint32_t id, const cga::Pose<double> &pose) {
	State &s = *_state;
	const StreamGrid grid(float(s.settings.position_tolerance), float(s.settings.rotation_tolerance));
	if (id >= ID_LIMIT || has_body(id) || !BodyState::can_hold(pose, grid)) {
		return false;
	}
	if (s.encoder != nullptr && !s.encoder->add_body(id, s.ticks(s.time), pose)) {
		return false;
	}
	s.bodies[id] = pose;
	return true;
}

bool Sender::remove_body(uint32_t id) {
	State &s = *_state;
	if (s.bodies.erase(id) == 0) {
		return false;
	}
	if (s.encoder != nullptr) {
		s.encoder->remove_body(id, s.ticks(s.time));
	}
	return true;
}

bool Sender::has_body(uint32_t id) const {
	return _state->bodies.count(id) != 0;
}

size_t Sender::body_count() const {
	return _state->bodies.size();
}

bool Sender::observe(uint32_t id, double time, const cga::Pose<double> &pose) {
	State &s = *_state;
	s.begin_at(time);
	const auto found = s.bodies.find(id);
	if (found == s.bodies.end() || !std::isfinite(time)) {
		return false;
	}
	if (s.encoder != nullptr) {
		if (!s.encoder->observe(id, s.ticks(time), pose)) {
			return false;
		}
	} else if (!BodyState::can_hold(pose, StreamGrid(float(s.settings.position_tolerance), float(s.settings.rotation_tolerance)))) {
		return false;
	}
	found->second = pose;
	return true;
}

bool Sender::teleport(uint32_t id) {
	return _state->encoder != nullptr ? _state->encoder->jump(id) : has_body(id);
}

void Sender::add_receiver(uint32_t receiver, double time) {
	State &s = *_state;
	s.begin_at(time);
	s.peers.erase(receiver);
	s.peers.emplace(receiver, State::Peer{ Delivery(time) });
}

void Sender::remove_receiver(uint32_t receiver) {
	_state->peers.erase(receiver);
	if (_state->peers.empty()) {
		_state->encoder.reset();
	}
}

bool Sender::has_receiver(uint32_t receiver) const {
	return _state->peers.count(receiver) != 0;
}

void Sender::State::begin_at(double first_time) {
	if (!has_origin) {
		origin = time = first_time;
		has_origin = true;
	}
}

void Sender::State::start_encoder() {
	encoder = std::make_unique<StreamEncoder>(float(settings.position_tolerance), float(settings.rotation_tolerance), settings.mode);
	std::vector<uint32_t> ids;
	for (const auto &body : bodies) {
		ids.push_back(body.first);
	}
	std::sort(ids.begin(), ids.end());
	for (const uint32_t id : ids) {
		(void)encoder->add_body(id, double(window_begin), bodies[id]);
	}
	for (auto &peer : peers) {
		peer.second.delivery = Delivery(time);
	}
	news_since = -1;
}

double Sender::State::longest_window() const {
	// What a chunk may need after its window has ended, at the receiver for which that is most.
	double network = FRAME;
	for (const auto &peer : peers) {
		const Delivery &delivery = peer.second.delivery;
		if (!delivery.is_silent(time)) {
			const double once = std::max(3.0 * delivery.round_trip_deviation(), FRAME);
			network = std::max(network, once + (delivery.expected_loss() > NOTABLE_LOSS ? delivery.patience() + settings.tick : 0.0));
		}
	}
	const double longest = std::max(settings.max_latency - network, settings.max_latency * MIN_WINDOW);
	return std::max(longest, settings.send_rate > 0.0 ? std::min(1.0 / settings.send_rate, settings.max_latency) : 0.0) / settings.tick;
}

bool Sender::State::is_window_due(int64_t now) const {
	const double next = double(now) + step;
	if (next - double(window_begin) > double(MAX_TICKS) + SAME_TICK) {
		return true;
	}
	const bool is_awaited = std::any_of(peers.begin(), peers.end(), [](const auto &peer) { return peer.second.delivery.needs_state(); });
	if (is_awaited) {
		return true;
	}
	if (news_since >= 0) {
		return next - double(news_since) > longest_window() + SAME_TICK;
	}
	return next - double(window_begin) > IDLE_WINDOW / settings.tick;
}

void Sender::State::close_window(int64_t end) {
	while (window_begin < end) {
		const int length = int(std::min<int64_t>(end - window_begin, MAX_TICKS));
		window.clear();
		encoder->encode_window(double(window_begin), length, window);
		ring.push_window(window, encoder->check());
		window_begin += length;
	}
	news_since = encoder->has_news() ? window_begin : -1;
}

void Sender::State::give_states() {
	std::shared_ptr<StateSnapshot> snapshot;
	for (auto &peer : peers) {
		if (!peer.second.delivery.needs_state() || peer.second.delivery.is_silent(time)) {
			continue;
		}
		if (snapshot == nullptr) {
			snapshot = std::make_shared<StateSnapshot>();
			if (!has_state_number) {
				has_state_number = true;
				state_number = number_from(origin);
			}
			snapshot->number = ++state_number;
			snapshot->next_chunk = ring.next();
			StateHeader header;
			header.settings = settings;
			header.tick = uint32_t(window_begin);
			header.window = float(longest_window() * settings.tick);
			put_state_header(snapshot->bytes, header);
			encoder->encode_state(snapshot->bytes);
		}
		peer.second.delivery.start_state(snapshot);
	}
}

void Sender::State::send_all() {
	for (auto &entry : peers) {
		Peer &peer = entry.second;
		peer.delivery.send(ring, time, bytes, [&](size_t begin, size_t size) {
			packets.push_back({ entry.first, begin, size });
			peer.bytes_sent += size;
			++peer.packets_sent;
		});
	}
}

void Sender::flush(double time) {
	State &s = *_state;
	s.bytes.clear();
	s.packets.clear();
	s.begin_at(time);
	s.time = std::max(time, s.time);
	const int64_t now = int64_t(std::floor(s.ticks(s.time) + SAME_TICK));
	if (now > s.last_flush) {
		// The longest of the recent steps, gaps apart: a window must be over before it is too long.
		s.step = std::clamp(double(now - s.last_flush), 0.9 * s.step, MAX_STEP);
	}
	const int64_t before = s.last_flush;
	s.last_flush = now;
	if (s.peers.empty()) {
		s.window_begin = now;
		return;
	}
	if (s.encoder == nullptr) {
		s.window_begin = now > 0 ? now - 1 : 0;
		s.start_encoder();
	}
	if (s.news_since < 0 && s.encoder->has_news()) {
		// What was idle until now is told at once, so that windows with motion are as short as they should be.
		s.close_window(std::max(s.window_begin, std::min(before, now - 1)));
		s.news_since = s.window_begin;
	}
	if (now > s.window_begin && s.is_window_due(now)) {
		s.close_window(now);
		s.give_states();
	}
	s.send_all();
}

const std::vector<OutgoingPacket> &Sender::packets() const {
	return _state->packets;
}

const uint8_t *Sender::bytes() const {
	return _state->bytes.data();
}

const char *Sender::accept(uint32_t receiver, const uint8_t *packet, size_t size, double time) {
	State &s = *_state;
	const auto found = s.peers.find(receiver);
	if (found == s.peers.end()) {
		return "the answer comes from nobody that poses are sent to";
	}
	const char *error = read_packet(packet, size, s.answer);
	if (error != nullptr) {
		return error;
	}
	found->second.delivery.accept(s.answer, s.ring, time);
	return nullptr;
}

void Sender::set_settings(const StreamSettings &settings) {
	State &s = *_state;
	const StreamSettings &old = s.settings;
	const bool restarts = !old.is_same_stream(settings);
	if (old.tick != settings.tick) {
		s.origin = s.time;
		s.window_begin = s.last_flush = 0;
	}
	s.settings = settings;
	if (restarts) {
		s.encoder.reset();
	}
}

const StreamSettings &Sender::settings() const {
	return _state->settings;
}

double Sender::media_time(double time) const {
	return _state->has_origin ? time - _state->origin : 0.0;
}

ReceiverStatistics Sender::statistics(uint32_t receiver) const {
	ReceiverStatistics statistics;
	const auto found = _state->peers.find(receiver);
	if (found != _state->peers.end()) {
		const State::Peer &peer = found->second;
		statistics.bytes_sent = peer.bytes_sent;
		statistics.packets_sent = peer.packets_sent;
		statistics.chunks_repeated = peer.delivery.repeated();
		statistics.loss = peer.delivery.loss();
		statistics.round_trip = peer.delivery.round_trip();
	}
	return statistics;
}

size_t Sender::moving_count() const {
	return _state->encoder != nullptr ? _state->encoder->moving_count() : 0;
}

} // namespace net
