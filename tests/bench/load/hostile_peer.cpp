#include "hostile_peer.hpp"

#include "net/stream/snapshot_header.hpp"

#include <algorithm>
#include <array>

namespace bench {

namespace {

constexpr size_t MAX_PAYLOAD = 1000; // bytes of a fragment
constexpr size_t FRESH_BODIES = 200; // in a snapshot
constexpr size_t MANY_BODIES = 4128;
constexpr double LONG_LATENCY = 10.0; // seconds, the maximum; receivers keep motion for as long
constexpr size_t WINDOWS_PER_PACKET = 127;
constexpr size_t EMPTY_WINDOWS = 40 * WINDOWS_PER_PACKET; // after each snapshot
constexpr size_t BUSY_WINDOWS = 20;
constexpr double SPEED = 0.05; // of the bodies in busy windows, in meters per tick
constexpr size_t FRAGMENTS_PER_PACKET = 64;
constexpr size_t PACKETS_PER_SNAPSHOT = 64;
constexpr uint16_t MANY_FRAGMENTS = 30000;
constexpr size_t SMALL_CHUNKS_PER_PACKET = 210;
constexpr size_t LARGE_PACKET = 64000; // bytes
constexpr size_t LARGE_FRAGMENT = 300;
constexpr size_t ACKS_PER_PACKET = 8000;
constexpr int OPENS_PER_ACK = 64; // a peer without a stream requests it so often

net::StreamEncoder resting_bodies(uint32_t first_id, size_t count) {
	const net::StreamSettings settings;
	net::StreamEncoder encoder(float(settings.position_tolerance), float(settings.rotation_tolerance), settings.mode);
	for (size_t i = 0; i < count; ++i) {
		(void)encoder.add_body(first_id + uint32_t(i), 0.0, cga::Pose<double>());
	}
	encoder.start_at(0.0);
	return encoder;
}

} // namespace

const char *attack_name(Attack attack) {
	static constexpr std::array<const char *, size_t(Attack::COUNT)> NAMES = { "fresh_ids", "reversed_snapshots", "repeated_snapshot", "empty_windows", "busy_windows", "restarted_snapshots", "small_chunks", "large_packets", "opens", "stream_switches", "snapshot_requests", "random_acks", "gap_acks", "large_acks", "random_bytes", "mixture" };
	return NAMES[size_t(attack)];
}

HostilePeer::Bytes HostilePeer::begin(net::PacketKind kind, uint8_t link) {
	Bytes packet(net::ENVELOPE_BYTES);
	net::write_envelope({ kind, link, net::ENVELOPE_VERSION }, packet.data());
	return packet;
}

void HostilePeer::hear(const uint8_t *bytes, size_t size) {
	const auto envelope = net::read_envelope(bytes, size);
	if (!envelope || envelope->kind != net::PacketKind::OPEN) {
		return;
	}
	const uint8_t *content = bytes + net::ENVELOPE_BYTES;
	if (size >= net::ENVELOPE_BYTES + net::OPEN_BYTES + net::TOKEN_BYTES && (content[0] & net::OPEN_CHALLENGE) != 0) {
		if (envelope->link == _own_link) {
			_token = uint16_t(content[net::OPEN_BYTES] | content[net::OPEN_BYTES + 1] << 8);
		}
	} else if (envelope->link != _link) {
		_link = envelope->link;
		_queue.clear();
	}
}

HostilePeer::Bytes HostilePeer::open() const {
	return begin(net::PacketKind::OPEN, _own_link);
}

HostilePeer::Bytes HostilePeer::next() {
	++_sent;
	if (_attack != Attack::MIXTURE) {
		return make(_attack);
	}
	_next_kind = (_next_kind + 1) % size_t(Attack::MIXTURE);
	return make(Attack(_next_kind));
}

HostilePeer::Bytes HostilePeer::make(Attack attack) {
	switch (attack) {
		case Attack::FRESH_IDS:
		case Attack::REVERSED_SNAPSHOTS:
		case Attack::REPEATED_SNAPSHOT:
		case Attack::EMPTY_WINDOWS:
		case Attack::BUSY_WINDOWS:
			return from_queue(attack);
		case Attack::RESTARTED_SNAPSHOTS:
			return restarted_fragments();
		case Attack::SMALL_CHUNKS:
			return small_chunks();
		case Attack::LARGE_PACKETS:
			return large_packet();
		case Attack::OPENS:
			++_own_link;
			return open();
		case Attack::STREAM_SWITCHES:
			return switch_stream();
		case Attack::SNAPSHOT_REQUESTS:
		case Attack::RANDOM_ACKS:
		case Attack::GAP_ACKS:
		case Attack::LARGE_ACKS:
			return acknowledge(attack);
		default:
			return random_bytes();
	}
}

HostilePeer::Bytes HostilePeer::from_queue(Attack attack) {
	if (_queue.empty() && (attack == Attack::EMPTY_WINDOWS || attack == Attack::BUSY_WINDOWS)) {
		queue_windows(attack);
	} else if (_queue.empty()) {
		queue_fresh_snapshot();
	}
	Bytes packet = std::move(attack == Attack::REVERSED_SNAPSHOTS ? _queue.back() : _queue.front());
	if (attack == Attack::REVERSED_SNAPSHOTS) {
		_queue.pop_back();
	} else {
		_queue.pop_front();
	}
	if (attack == Attack::REPEATED_SNAPSHOT) {
		_queue.push_back(packet);
	}
	return packet;
}

void HostilePeer::queue_snapshot(const Bytes &content) {
	net::SnapshotHeader header;
	header.settings.max_latency = LONG_LATENCY;
	header.tick = _tick++;
	header.window = 0.1f;
	Bytes bytes;
	net::put_snapshot_header(bytes, header);
	bytes.insert(bytes.end(), content.begin(), content.end());
	++_snapshot;
	net::FragmentItem fragment;
	fragment.snapshot = uint8_t(_snapshot);
	fragment.next_chunk = decltype(fragment.next_chunk)(_chunk);
	fragment.count = uint16_t((bytes.size() + MAX_PAYLOAD - 1) / MAX_PAYLOAD);
	for (size_t i = 0; i < fragment.count; ++i) {
		fragment.index = uint16_t(i);
		fragment.bytes = bytes.data() + i * MAX_PAYLOAD;
		fragment.size = std::min(MAX_PAYLOAD, bytes.size() - i * MAX_PAYLOAD);
		Bytes packet = begin(net::PacketKind::MOTION, _link);
		net::put_fragment(packet, fragment);
		_queue.push_back(std::move(packet));
	}
}

void HostilePeer::queue_fresh_snapshot() {
	net::StreamEncoder encoder = resting_bodies(_next_id, FRESH_BODIES);
	_next_id += uint32_t(FRESH_BODIES);
	Bytes content;
	encoder.encode_snapshot(content);
	queue_snapshot(content);
}

void HostilePeer::encode_windows(Attack attack) {
	if (!_windows.empty()) {
		return;
	}
	net::StreamEncoder encoder = resting_bodies(_next_id, MANY_BODIES);
	encoder.encode_snapshot(_many_bodies);
	const bool moves = attack == Attack::BUSY_WINDOWS;
	_windows.resize(moves ? BUSY_WINDOWS : EMPTY_WINDOWS);
	for (size_t i = 0; i < _windows.size(); ++i) {
		for (size_t body = 0; moves && body < MANY_BODIES; ++body) {
			(void)encoder.observe(_next_id + uint32_t(body), double(i + 1), { { SPEED * double(i + 1), 0.0, 0.0 }, { 1.0, 0.0, 0.0, 0.0 }, 1.0 });
		}
		encoder.encode_window(double(i), 1, _windows[i].bytes);
		_windows[i].check = encoder.check();
	}
}

/// A snapshot, then all windows after it.
void HostilePeer::queue_windows(Attack attack) {
	encode_windows(attack);
	queue_snapshot(_many_bodies);
	size_t chunks = WINDOWS_PER_PACKET; // in the last packet
	for (const Window &window : _windows) {
		for (size_t at = 0; at == 0 || at < window.bytes.size(); at += MAX_PAYLOAD) {
			net::ChunkItem chunk;
			chunk.number = decltype(chunk.number)(_chunk++);
			chunk.is_wide = true;
			chunk.bytes = window.bytes.data() + at;
			chunk.size = std::min(MAX_PAYLOAD, window.bytes.size() - at);
			chunk.first = at == 0;
			chunk.last = at + chunk.size == window.bytes.size();
			chunk.check = chunk.last ? window.check : 0;
			if (chunks == WINDOWS_PER_PACKET || _queue.back().size() + chunk.size > MAX_PAYLOAD) {
				_queue.push_back(begin(net::PacketKind::MOTION, _link));
				chunks = 0;
			}
			net::put_chunk(_queue.back(), chunk, false);
			++chunks;
		}
	}
	_tick += uint32_t(_windows.size());
}

HostilePeer::Bytes HostilePeer::restarted_fragments() {
	const uint8_t byte = 0;
	const size_t place = _sent % PACKETS_PER_SNAPSHOT;
	_snapshot += place == 0 ? 1 : 0;
	Bytes packet = begin(net::PacketKind::MOTION, _link);
	for (size_t i = 0; i < (place == 0 ? 1 : FRAGMENTS_PER_PACKET); ++i) {
		net::FragmentItem fragment;
		fragment.snapshot = uint8_t(_snapshot);
		fragment.index = uint16_t(place * FRAGMENTS_PER_PACKET + i);
		fragment.count = MANY_FRAGMENTS;
		fragment.bytes = &byte;
		fragment.size = 1;
		net::put_fragment(packet, fragment);
	}
	return packet;
}

HostilePeer::Bytes HostilePeer::small_chunks() {
	Bytes packet = begin(net::PacketKind::MOTION, _link);
	for (size_t i = 0; i < SMALL_CHUNKS_PER_PACKET; ++i) {
		net::ChunkItem chunk;
		chunk.number = decltype(chunk.number)(7 * _chunk++); // with gaps
		chunk.first = chunk.last = chunk.is_wide = true;
		net::put_chunk(packet, chunk, false);
	}
	return packet;
}

HostilePeer::Bytes HostilePeer::large_packet() {
	static constexpr std::array<uint8_t, LARGE_FRAGMENT> CONTENT{};
	Bytes packet = begin(net::PacketKind::MOTION, _link);
	net::FragmentItem fragment;
	fragment.snapshot = 1;
	fragment.count = MANY_FRAGMENTS;
	fragment.bytes = CONTENT.data();
	fragment.size = CONTENT.size();
	while (packet.size() + net::FRAGMENT_HEADER + fragment.size <= LARGE_PACKET) {
		fragment.index = uint16_t(_chunk++ % (MANY_FRAGMENTS - 1));
		net::put_fragment(packet, fragment);
	}
	return packet;
}

HostilePeer::Bytes HostilePeer::subscribe() {
	_is_subscribed = _token.has_value();
	if (!_token) {
		++_own_link;
		return open();
	}
	Bytes packet = open();
	packet.insert(packet.end(), { net::OPEN_TOKEN, net::STREAM_VERSION, uint8_t(*_token), uint8_t(*_token >> 8) });
	_token.reset();
	return packet;
}

HostilePeer::Bytes HostilePeer::switch_stream() {
	if (!_is_subscribed) {
		return subscribe();
	}
	_is_subscribed = false;
	Bytes packet = begin(net::PacketKind::CLOSE, _own_link);
	packet.push_back(uint8_t(net::CloseRole::RECEIVER));
	return packet;
}

HostilePeer::Bytes HostilePeer::acknowledge(Attack attack) {
	if (_token || (!_is_subscribed && _sent % OPENS_PER_ACK == 0)) {
		return subscribe();
	}
	Bytes packet = begin(net::PacketKind::ACK, _own_link);
	if (attack == Attack::SNAPSHOT_REQUESTS) {
		net::put_snapshot_request(packet);
		return packet;
	}
	for (size_t i = 0; i < (attack == Attack::LARGE_ACKS ? ACKS_PER_PACKET : 1); ++i) {
		net::AckItem ack;
		ack.next = decltype(ack.next)(uint64_t(_random.between(0.0, attack == Attack::GAP_ACKS ? 64.0 : 65536.0)));
		ack.packets = decltype(ack.packets)(uint64_t(_random.between(0.0, 256.0)));
		for (size_t run = 0; attack == Attack::GAP_ACKS && run < net::AckRuns::MAX_RUNS; ++run) {
			ack.later.add(1, 1);
		}
		net::put_ack(packet, ack);
	}
	return packet;
}

HostilePeer::Bytes HostilePeer::random_bytes() {
	Bytes packet = begin(net::PacketKind::MOTION, _link);
	packet.resize(packet.size() + 1 + size_t(_random.between(0.0, double(MAX_PAYLOAD))));
	for (size_t i = net::ENVELOPE_BYTES; i < packet.size(); ++i) {
		packet[i] = uint8_t(_random.between(0.0, 256.0));
	}
	return packet;
}

} // namespace bench
