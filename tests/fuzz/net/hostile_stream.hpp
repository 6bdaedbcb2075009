#pragma once

#include "motion.hpp"

#include "net/delivery/packet.hpp"
#include "net/stream/snapshot_header.hpp"
#include "net/stream/stream_encoder.hpp"

#include <optional>

// A hostile sender: well-coded snapshots and windows whose content the fuzzer chooses, and edits of them.

namespace fuzz {

class HostileStream {
public:
	static constexpr uint32_t ID_LIMIT = 24; // of most bodies
	static constexpr size_t MAX_WINDOW_TICKS = 64;

	explicit HostileStream(Input &input) :
			_input(input) {
		restart(input.flag());
	}

	/// The next packet: one item or several.
	Bytes packet() {
		Bytes bytes;
		for (size_t items = 1 + _input.byte() % 4; items > 0 && bytes.size() < 60000; --items) {
			add_item(bytes);
		}
		return bytes;
	}

	/// A snapshot of other bodies than in all earlier ones, one tick later.
	Bytes fresh_snapshot() {
		_time += 1.0;
		_encoder.emplace(float(_header.settings.position_tolerance), float(_header.settings.rotation_tolerance), _header.settings.mode);
		for (int body = 0; body < 4; ++body) {
			(void)_encoder->add_body(_fresh_id++, _time, pose_at(1, 0.0));
		}
		_encoder->start_at(_time);
		Bytes packet;
		const Bytes bytes = snapshot_bytes();
		put_fragment(packet, bytes, ++_number, 0, 1, bytes.size());
		return packet;
	}

	/// Changes the bodies, then encodes the next window. `ticks` receives its length.
	Bytes window(int &ticks) {
		ticks = 1 + int(_input.below(MAX_WINDOW_TICKS));
		for (size_t changes = _input.byte() % 6; changes > 0; --changes) {
			change_body(ticks);
		}
		Bytes bytes;
		_encoder->encode_window(_time, ticks, bytes);
		_time += ticks;
		edit_some(bytes);
		return bytes;
	}

	/// The state after the last window.
	Bytes snapshot() {
		Bytes bytes;
		_encoder->encode_snapshot(bytes);
		edit_some(bytes);
		return bytes;
	}

	[[nodiscard]] const net::StreamSettings &settings() const { return _header.settings; }

private:
	using Chunk = net::ChunkItem;
	using Fragment = net::FragmentItem;

	void restart(bool usual) {
		_header = net::SnapshotHeader();
		if (!usual) {
			_header.settings.position_tolerance = std::pow(10.0, _input.between(-6.0, 6.0));
			_header.settings.rotation_tolerance = std::pow(10.0, _input.between(-4.0, 2.0));
			_header.settings.max_latency = _input.between(0.0, 60.0);
			_header.settings.tick = std::pow(10.0, _input.between(-4.0, 1.0));
			_header.settings.mode = cga::Mode(_input.byte() % 3);
		}
		_header.window = float(_input.flag() ? _input.between(0.0, 60.0) : 0.2);
		_encoder.emplace(float(_header.settings.position_tolerance), float(_header.settings.rotation_tolerance), _header.settings.mode);
		_time = double(_input.flag() ? _input.bits(4) : 0);
		for (size_t bodies = _input.byte() % 8; bodies > 0; --bodies) {
			(void)_encoder->add_body(body_id(), _time, pose_from(_input), _input.flag());
		}
		_encoder->start_at(_time);
	}

	uint32_t body_id() { return uint32_t(_input.flag() ? _input.below(ID_LIMIT) : _input.bits(3)); }

	void change_body(int ticks) {
		const uint32_t id = body_id();
		const double time = _time + _input.between(0.0, double(ticks));
		switch (_input.byte() % 6) {
			case 0:
				(void)_encoder->add_body(id, time, pose_from(_input), _input.flag());
				break;
			case 1:
				(void)_encoder->remove_body(id, time, _input.flag());
				break;
			case 2:
				(void)_encoder->jump(id);
				[[fallthrough]];
			case 3:
				(void)_encoder->observe(id, time, pose_from(_input));
				break;
			case 4:
				// As many bodies as one window may add.
				for (uint32_t count = uint32_t(_input.below(128)), first = body_id(); count > 0; --count) {
					(void)_encoder->add_body(first + count, time, pose_at(1, time));
				}
				break;
			default:
				for (int tick = 1; tick <= ticks; ++tick) {
					(void)_encoder->observe(id, _time + tick, pose_at(id % 7, (_time + tick) * TICK));
				}
		}
	}

	void add_item(Bytes &packet) {
		switch (_input.byte() % 8) {
			case 0:
			case 1:
				add_snapshot(packet);
				break;
			case 2:
			case 3:
			case 4: {
				int ticks = 0;
				add_window(packet, window(ticks));
				break;
			}
			case 5:
				// Windows without content, which cost the sender next to nothing.
				for (size_t count = _input.byte(); count > 0; --count) {
					Bytes bytes;
					_encoder->encode_window(_time, 1, bytes);
					_time += 1.0;
					add_window(packet, bytes);
				}
				break;
			case 6:
				net::put_round_trip(packet, _input.between(0.0, 10.0));
				break;
			default: {
				const Bytes raw = _input.take(_input.byte() % 32);
				packet.insert(packet.end(), raw.begin(), raw.end());
				restart(_input.flag());
			}
		}
	}

	Bytes snapshot_bytes() {
		_header.tick = uint32_t(std::min(_time, 4e9));
		Bytes bytes;
		net::put_snapshot_header(bytes, _header);
		const Bytes state = snapshot();
		bytes.insert(bytes.end(), state.begin(), state.end());
		return bytes;
	}

	void put_fragment(Bytes &packet, const Bytes &bytes, size_t number, size_t index, size_t count, size_t size) {
		const size_t begin = index * size;
		Fragment fragment;
		fragment.snapshot = decltype(fragment.snapshot)(number);
		fragment.next_chunk = decltype(fragment.next_chunk)(_next_chunk);
		fragment.index = decltype(fragment.index)(index);
		fragment.count = decltype(fragment.count)(count);
		fragment.bytes = bytes.data() + begin;
		fragment.size = std::min(size, bytes.size() - begin);
		net::put_fragment(packet, fragment);
	}

	void add_snapshot(Bytes &packet) {
		_number = decltype(_number)(_number + (_input.flag() ? 1 : _input.byte()));
		const Bytes bytes = snapshot_bytes();
		const size_t size = _input.flag() ? 1000 : 1 + _input.below(400);
		const size_t count = std::min<size_t>((bytes.size() + size - 1) / size, 64);
		const size_t omitted = _input.flag() ? count : _input.below(count + 1);
		for (size_t index = 0; index < count; ++index) {
			if (index != omitted) {
				put_fragment(packet, bytes, _number, index, count, size);
			}
		}
	}

	void add_window(Bytes &packet, const Bytes &window) {
		const uint8_t check = _input.flag() ? _encoder->check() : _input.byte();
		const size_t size = _input.flag() ? 1000 : 1 + _input.below(250);
		size_t begin = 0;
		do {
			Chunk chunk;
			chunk.is_wide = _input.byte() >= 128;
			chunk.number = decltype(chunk.number)(_input.byte() < 240 ? _next_chunk : _input.bits(2));
			chunk.first = begin == 0;
			chunk.bytes = window.data() + begin;
			chunk.size = std::min(size, window.size() - begin);
			begin += chunk.size;
			chunk.last = begin == window.size();
			chunk.check = chunk.last ? check : 0;
			net::put_chunk(packet, chunk, false);
			++_next_chunk;
		} while (begin < window.size());
	}

	void edit_some(Bytes &bytes) {
		if (_input.byte() >= 192) {
			edit(bytes, _input);
		}
	}

	Input &_input;
	net::SnapshotHeader _header;
	std::optional<net::StreamEncoder> _encoder;
	uint32_t _next_chunk = 0;
	decltype(Fragment::snapshot) _number = 0;
	double _time = 0.0; // ticks
	uint32_t _fresh_id = 1000;
};

} // namespace fuzz
