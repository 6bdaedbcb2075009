#pragma once

#include "net/delivery/packet.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace net {

/// An outgoing snapshot: the state that a receiver needs to decode the stream from chunk `next_chunk` on.
struct Snapshot {
	uint8_t number = 0;
	uint32_t next_chunk = 0;
	size_t fragment_size = 1000; ///< in bytes, of all fragments but the last
	std::vector<uint8_t> bytes;

	/// The usual size of a snapshot, in bytes.
	[[nodiscard]] static size_t estimate(size_t bodies) { return 300 + 50 * bodies; }
	/// Fragments are small: a receiver gets few bytes before it has acknowledged any.
	static constexpr size_t MAX_FRAGMENT = 1100;
	[[nodiscard]] static size_t fragment_size_for(size_t max_packet_size) { return std::min(max_packet_size, MAX_FRAGMENT) - FRAGMENT_HEADER; }
	[[nodiscard]] size_t fragment_count() const { return (bytes.size() + fragment_size - 1) / fragment_size; }
	[[nodiscard]] size_t size_of(size_t index) const { return std::min(fragment_size, bytes.size() - index * fragment_size); }
};

/// Reassembles an incoming snapshot from its fragments, which may arrive in any order. Allocates only what has arrived.
class FragmentBuffer {
public:
	/// Starts reassembling the snapshot that `fragment` belongs to and drops the previous one.
	void start(const FragmentItem &fragment) {
		_open = true;
		_number = fragment.snapshot;
		_next_chunk = fragment.next_chunk;
		_count = fragment.count;
		_next = 0;
		_size = 0;
		_fragments.clear();
	}

	/// Adds a fragment of the current snapshot. Returns false for a duplicate.
	bool add(const FragmentItem &fragment) {
		const auto [slot, is_new] = _fragments.try_emplace(fragment.index);
		if (!is_new) {
			return false;
		}
		slot->second.assign(fragment.bytes, fragment.bytes + fragment.size);
		_size += fragment.size;
		while (_fragments.count(_next) != 0) {
			++_next;
		}
		return true;
	}

	/// True between `start` and `finish`.
	[[nodiscard]] bool is_open() const { return _open; }
	[[nodiscard]] bool is_complete() const { return _open && _fragments.size() == _count; }
	[[nodiscard]] bool belongs(const FragmentItem &fragment) const { return _open && fragment.snapshot == _number && fragment.count == _count; }
	[[nodiscard]] uint8_t number() const { return _number; }
	[[nodiscard]] uint16_t next_chunk() const { return _next_chunk; }
	/// Total size of the fragments that have arrived, in bytes.
	[[nodiscard]] size_t size() const { return _size; }
	/// Replaces `bytes` with the reassembled snapshot and closes it.
	void finish(std::vector<uint8_t> &bytes) {
		_open = false;
		bytes.clear();
		for (const auto &fragment : _fragments) {
			bytes.insert(bytes.end(), fragment.second.begin(), fragment.second.end());
		}
	}

	/// Acknowledges the fragments that have arrived, or all of them if the snapshot has been decoded (`is_done`).
	[[nodiscard]] SnapshotAckItem ack(bool is_done) const {
		SnapshotAckItem ack{ _number, is_done ? _count : _next, {} };
		uint32_t at = ack.next;
		for (auto fragment = _fragments.upper_bound(ack.next); fragment != _fragments.end();) {
			const uint32_t begin = fragment->first;
			uint32_t end = begin;
			for (; fragment != _fragments.end() && fragment->first == end; ++fragment) {
				++end;
			}
			ack.later.add(uint16_t(begin - at), uint16_t(end - begin));
			at = end;
		}
		return ack;
	}

private:
	bool _open = false;
	uint8_t _number = 0;
	uint16_t _next_chunk = 0;
	uint16_t _count = 0; // of all fragments
	uint16_t _next = 0; // the first one that has not arrived
	size_t _size = 0;
	std::map<uint16_t, std::vector<uint8_t>> _fragments; // by index
};

} // namespace net
