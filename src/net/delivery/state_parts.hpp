#pragma once

#include "net/delivery/packet.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// A whole state, cut up, as it was before chunk `next_chunk`.
struct StateSnapshot {
	static constexpr std::size_t PART_BYTES = 1280;
	std::uint8_t number = 0;
	std::uint32_t next_chunk = 0;
	std::vector<std::uint8_t> bytes;

	[[nodiscard]] std::size_t parts() const { return (bytes.size() + PART_BYTES - 1) / PART_BYTES; }
};

/// A state at its receiver: its parts, in any order, until all of them are there.
class StateParts {
public:
	/// Forgets the state before.
	void start(const StatePartItem &part);
	/// Takes a part of the state that was started. False if it is known already.
	bool add(const StatePartItem &part);

	/// True from the start until `close`.
	[[nodiscard]] bool is_open() const { return open_; }
	[[nodiscard]] bool is_complete() const { return open_ && missing_ == 0; }
	/// True if the part is one of the state that is open.
	[[nodiscard]] bool belongs(const StatePartItem &part) const { return open_ && part.state == number_ && part.parts == parts_.size(); }
	[[nodiscard]] std::uint8_t number() const { return number_; }
	[[nodiscard]] std::uint8_t next_chunk() const { return next_chunk_; }
	/// Replaces `bytes` by all parts in order; nothing is waited for any more.
	void close(std::vector<std::uint8_t> &bytes);
	/// Which parts have arrived; all of them, if `is_done` says that the state is known.
	[[nodiscard]] StateAckItem ack(bool is_done) const;

private:
	struct Part {
		bool arrived = false;
		std::vector<std::uint8_t> bytes;
	};

	bool open_ = false;
	std::uint8_t number_ = 0;
	std::uint8_t next_chunk_ = 0;
	std::vector<Part> parts_;
	std::size_t missing_ = 0;
};

} // namespace net
