#pragma once

#include "net/delivery/packet.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// A whole state, cut up, as it was before chunk `next_chunk`.
struct StateSnapshot {
	static constexpr size_t PART_BYTES = 1280;
	uint8_t number = 0;
	uint32_t next_chunk = 0;
	std::vector<uint8_t> bytes;

	[[nodiscard]] size_t parts() const { return (bytes.size() + PART_BYTES - 1) / PART_BYTES; }
};

/// A state at its receiver: its parts, in any order, until all of them are there.
class StateParts {
public:
	/// Forgets the state before.
	void start(const StatePartItem &part);
	/// Takes a part of the state that was started. False if it is known already.
	bool add(const StatePartItem &part);

	/// True from the start until `close`.
	[[nodiscard]] bool is_open() const { return _open; }
	[[nodiscard]] bool is_complete() const { return _open && _missing == 0; }
	/// True if the part is one of the state that is open.
	[[nodiscard]] bool belongs(const StatePartItem &part) const { return _open && part.state == _number && part.parts == _parts.size(); }
	[[nodiscard]] uint8_t number() const { return _number; }
	[[nodiscard]] uint8_t next_chunk() const { return _next_chunk; }
	/// Replaces `bytes` by all parts in order; nothing is waited for any more.
	void close(std::vector<uint8_t> &bytes);
	/// Which parts have arrived; all of them, if `is_done` says that the state is known.
	[[nodiscard]] StateAckItem ack(bool is_done) const;

private:
	struct Part {
		bool arrived = false;
		std::vector<uint8_t> bytes;
	};

	bool _open = false;
	uint8_t _number = 0;
	uint8_t _next_chunk = 0;
	std::vector<Part> _parts;
	size_t _missing = 0;
};

} // namespace net
