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
	void start(const FragmentItem &fragment);
	/// Adds a fragment of the current snapshot. Returns false for a duplicate.
	bool add(const FragmentItem &fragment);

	/// True between `start` and `finish`.
	[[nodiscard]] bool is_open() const { return _open; }
	[[nodiscard]] bool is_complete() const { return _open && _missing == 0; }
	[[nodiscard]] bool belongs(const FragmentItem &fragment) const { return _open && fragment.snapshot == _number && fragment.count == _fragments.size(); }
	[[nodiscard]] uint8_t number() const { return _number; }
	[[nodiscard]] uint8_t next_chunk() const { return _next_chunk; }
	/// Replaces `bytes` with the reassembled snapshot and closes it.
	void finish(std::vector<uint8_t> &bytes);
	/// Acknowledges the fragments that have arrived, or all of them if the snapshot has been decoded (`is_done`).
	[[nodiscard]] SnapshotAckItem ack(bool is_done) const;

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
