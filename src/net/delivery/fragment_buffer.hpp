#pragma once

#include "net/delivery/packet.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// A snapshot at its sender: everything a receiver needs to decode from chunk `next_chunk` on.
struct Snapshot {
	static constexpr size_t FRAGMENT_BYTES = 1280;
	uint8_t number = 0;
	uint32_t next_chunk = 0;
	std::vector<uint8_t> bytes;

	[[nodiscard]] size_t fragment_count() const { return (bytes.size() + FRAGMENT_BYTES - 1) / FRAGMENT_BYTES; }
};

/// A snapshot at its receiver: collects its fragments, in any order.
class FragmentBuffer {
public:
	/// Begins with the snapshot that `fragment` belongs to and drops the one before.
	void start(const FragmentItem &fragment);
	/// Adds a fragment of that snapshot. False if it has arrived before.
	bool add(const FragmentItem &fragment);

	/// True from `start` to `finish`.
	[[nodiscard]] bool is_open() const { return _open; }
	[[nodiscard]] bool is_complete() const { return _open && _missing == 0; }
	[[nodiscard]] bool belongs(const FragmentItem &fragment) const { return _open && fragment.snapshot == _number && fragment.count == _fragments.size(); }
	[[nodiscard]] uint8_t number() const { return _number; }
	[[nodiscard]] uint8_t next_chunk() const { return _next_chunk; }
	/// Replaces `bytes` with the snapshot and stops collecting.
	void finish(std::vector<uint8_t> &bytes);
	/// The fragments that have arrived; all of them if the snapshot `is_done`, that is, has been decoded.
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
