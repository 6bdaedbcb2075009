#pragma once

#include <algorithm>
#include <cstddef>

namespace net {

/// Limits what is sent to a peer before it has acknowledged anything to a multiple of what it has sent, so that nobody can make us flood
/// a victim (RFC 9000, section 8.1).
class SendCredit {
public:
	/// Bytes sent per byte received.
	static constexpr size_t FACTOR = 3;

	void received(size_t bytes) { _bytes += _is_validated ? 0 : FACTOR * bytes; }
	void sent(size_t bytes) { _bytes -= _is_validated ? 0 : std::min(bytes, _bytes); }
	/// The peer has acknowledged what was sent.
	void validate() { _is_validated = true; }
	/// Bytes that may be sent.
	[[nodiscard]] size_t allowance() const { return _is_validated ? ~size_t(0) : _bytes; }

private:
	size_t _bytes = 0;
	bool _is_validated = false;
};

} // namespace net
