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
constexpr size_t WINDOWS = 40 * WINDOWS_PER_PACKET; // after each snapshot
constexpr size_t FRAGMENTS_PER_PACKET = 64;
constexpr size_t PACKETS_PER_SNAPSHOT = 64;
constexpr uint16_t MANY_FRAGMENTS = 30000;

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
	static constexpr std::array<const char *, size_t(Attack::COUNT)> NAMES = { "fresh_ids", "empty_windows", "restarted_snapshots", "opens", "snapshot_requests", "random_acks", "random_bytes" };
	return NAMES[size_t(attack)];
}

HostilePeer::Bytes HostilePeer::begin(net::PacketKind kind, uint8_t link) const {
	Bytes packet(net::ENVELOPE_BYTES);
	net::write_envelope({ kind, link, net::ENVELOPE_VERSION }, packet.data());
	return packet;
}

void HostilePeer::hear(const uint8_t *bytes, size_t size) {
	const auto envelope = net::read_envelope(bytes, size);
	if (envelope && envelope->kind == net::PacketKind::OPEN && envelope->link != _link) {
		_link = envelope->link;
		_needs_snapshot = true;
		_queue.clear();
	}
}

HostilePeer::Bytes HostilePeer::open() const {
	return begin(net::PacketKind::OPEN, _own_link);
}

HostilePeer::Bytes HostilePeer::next() {
	++_sent;
	if (_attack == Attack::FRESH_IDS && _queue.empty()) {
		queue_fresh_snapshot();
	} else if (_attack == Attack::EMPTY_WINDOWS && _needs_snapshot) {
		_needs_snapshot = false;
		_next_window = 0;
		encode_windows();
		queue_snapshot(_many_bodies);
	}
	if (!_queue.empty()) {
		Bytes packet = std::move(_queue.front());
		_queue.pop_front();
		return packet;
	}
	switch (_attack) {
		case Attack::EMPTY_WINDOWS:
			return empty_windows();
		case Attack::RESTARTED_SNAPSHOTS:
			return restarted_fragments();
		case Attack::OPENS:
			++_own_link;
			return open();
		case Attack::SNAPSHOT_REQUESTS: {
			Bytes packet = begin(net::PacketKind::ACK, _own_link);
			net::put_snapshot_request(packet);
			return packet;
		}
		case Attack::RANDOM_ACKS:
			return random_ack();
		default:
			return random_bytes();
	}
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

void HostilePeer::encode_windows() {
	if (!_windows.empty()) {
		return;
	}
	net::StreamEncoder encoder = resting_bodies(_next_id, MANY_BODIES);
	encoder.encode_snapshot(_many_bodies);
	_windows.resize(WINDOWS);
	for (size_t i = 0; i < WINDOWS; ++i) {
		encoder.encode_window(double(i), 1, _windows[i].bytes);
		_windows[i].check = encoder.check();
	}
}

HostilePeer::Bytes HostilePeer::empty_windows() {
	Bytes packet = begin(net::PacketKind::MOTION, _link);
	for (size_t i = 0; i < WINDOWS_PER_PACKET; ++i) {
		const EmptyWindow &window = _windows[_next_window++];
		net::ChunkItem chunk;
		chunk.number = decltype(chunk.number)(_chunk++);
		chunk.first = chunk.last = true;
		chunk.check = window.check;
		chunk.bytes = window.bytes.data();
		chunk.size = window.bytes.size();
		net::put_chunk(packet, chunk, i + 1 == WINDOWS_PER_PACKET);
	}
	_tick += uint32_t(WINDOWS_PER_PACKET);
	_needs_snapshot = _next_window == WINDOWS;
	return packet;
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

HostilePeer::Bytes HostilePeer::random_ack() {
	Bytes packet = begin(net::PacketKind::ACK, _own_link);
	net::AckItem ack;
	ack.next = decltype(ack.next)(uint64_t(_random.between(0.0, 65536.0)));
	ack.packets = decltype(ack.packets)(uint64_t(_random.between(0.0, 256.0)));
	net::put_ack(packet, ack);
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
