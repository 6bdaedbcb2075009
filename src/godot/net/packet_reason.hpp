#pragma once

#include "net/session/envelope.hpp"
#include "net/stream/packet_error.hpp"
#include "net/stream/snapshot_header.hpp"

#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cstdint>

namespace ga_godot {

/// Why a packet was rejected, as a clause without a period. `version`: of the peer, if that is the reason.
inline godot::String packet_reason(net::PacketError error, uint8_t version) {
	const bool is_session = error == net::PacketError::OTHER_SESSION_VERSION;
	if (!is_session && error != net::PacketError::OTHER_STREAM_VERSION) {
		return net::describe(error);
	}
	return godot::vformat("it has version %d of the %s format, but this peer uses version %d; install the same version of the GA-Godot addon on all peers", int64_t(version), is_session ? "session" : "stream", int64_t(is_session ? net::ENVELOPE_VERSION : net::STREAM_VERSION));
}

} // namespace ga_godot
