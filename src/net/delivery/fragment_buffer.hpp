#pragma once

#include "net/delivery/packet.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// An outgoing snapshot: the state that a receiver needs to decode the stream from chunk `next_chunk` on.
struct Snapshot {
	static constexpr size_t FRAGMENT_BYTES = 1280;
	uint8_t number = 0;
	uint32_t next_chunk = 0;
	std::vector<uint8_t> bytes;

	[[nodiscard]] size_t fragment_count() const { return (bytes.size() + FRAGMENT_BYTES - 1) / FRAGMENT_BYTES; }
};

/// Reassembles an incoming snapshot from its fragments, which may arrive in any order.
class FragmentBuffer {
public:
	/// Starts reassembling the snapshot that `fragment` belongs to and drops the previous one.
	void start(const FragmentItem &fragment) {
		_open = true;
		_number = fragment.snapshot;
		_next_chunk = fragment.next_chunk;
		_fragments.assign(fragment.count, Fragment());
		_missing = fragment.count;
	}

	/// Adds a fragment of the current snapshot. Returns false for a duplicate.
	bool add(const FragmentItem &fragment) {
		Fragment &slot = _fragments[fragment.index];
		if (slot.arrived) {
			return false;
		}
		slot.arrived = true;
		slot.bytes.assign(fragment.bytes, fragment.bytes + fragment.size);
		--_missing;
		return true;
	}

	/// True between `start` and `finish`.
	[[nodiscard]] bool is_open() const { return _open; }
	[[nodiscard]] bool is_complete() const { return _open && _missing == 0; }
	[[nodiscard]] bool belongs(const FragmentItem &fragment) const { return _open && fragment.snapshot == _number && fragment.count == _fragments.size(); }
	[[nodiscard]] uint8_t number() const { return _number; }
	[[nodiscard]] uint8_t next_chunk() const { return _next_chunk; }
	/// Replaces `bytes` with the reassembled snapshot and closes it.
	void finish(std::vector<uint8_t> &bytes) {
		_open = false;
		bytes.clear();
		for (const Fragment &fragment : _fragments) {
			bytes.insert(bytes.end(), fragment.bytes.begin(), fragment.bytes.end());
		}
	}

	/// Acknowledges the fragments that have arrived, or all of them if the snapshot has been decoded (`is_done`).
	[[nodiscard]] SnapshotAckItem ack(bool is_done) const {
		SnapshotAckItem ack;
		ack.snapshot = _number;
		while (ack.next < _fragments.size() && (is_done || _fragments[ack.next].arrived)) {
			++ack.next;
		}
		for (size_t bit = 0; bit < 32 && ack.next + 1 + bit < _fragments.size(); ++bit) {
			ack.later |= _fragments[ack.next + 1 + bit].arrived ? uint32_t(1) << bit : 0;
		}
		return ack;
	}

private:
	struct Fragment {
		bool arrived = false;
		std::vector<uint8_t> bytes;
	};

	bool _open = false;
	uint8_t _number = 0;
	uint8_t _next_chunk = 0;
	std::vector<Fragment> _fragments;
	size_t _missing = 0;
};

} // namespace net
