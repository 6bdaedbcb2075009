#pragma once

#include "net/endpoint/forwarded_stream.hpp"
#include "net/session/body_owners.hpp"
#include "net/session/forwarding_schedule.hpp"
#include "net/session/section.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace net {

/// The server's side of relaying: forwards the streams of owners to clients. Each client gets one sequence of packets, in
/// which the sections of all streams, the server's own included, share packets. So that they do, owners are asked to align their
/// windows. Times are local times in seconds.
class Relay {
public:
	/// A stream may contain bodies of other owners for this many seconds: peers learn of a change of owner at different times.
	static constexpr double GRACE = 1.0;
	/// Maximum number of bodies of a stream that do not exist at the server. They are spawned or freed there at another time.
	static constexpr size_t MAX_ABSENT = 64;

	/// Forwards an owner's stream from now on. `source` must exist until remove_stream.
	void add_stream(PeerId owner, Receiver &source, double now);
	/// Returns the channel of the stream, so that it can be reported to the clients; std::nullopt if nothing of it was forwarded.
	std::optional<uint32_t> remove_stream(PeerId owner);

	void add_client(PeerId client, double now);
	void remove_client(PeerId client);
	[[nodiscard]] bool has_client(PeerId client) const { return _clients.count(client) != 0; }
	template <class Visit>
	void visit_clients(Visit &&visit) const {
		for (const auto &entry : _clients) {
			visit(entry.first);
		}
	}

	/// Begins a tick, with its number, its local time and its length. `max_window` is the length of the longest windows of owners.
	void begin_tick(int64_t number, double now, double length, double max_window) { _schedule.begin_tick(number, now, length, max_window); }
	[[nodiscard]] const ForwardingSchedule &schedule() const { return _schedule; }
	/// Records that a packet of an owner has been processed.
	void note_arrival(PeerId owner, double now);
	/// The request to align its windows that is due for an owner.
	[[nodiscard]] std::optional<AlignItem> take_alignment(PeerId owner, double now);

	/// Adds a packet of the server's own stream to the next packets for a client.
	void add_own_packet(PeerId client, const uint8_t *bytes, size_t size);
	/// Calls send(client, bytes, size) for each packet that is due, once per tick. Packets have at most `max_size` bytes.
	template <class Send>
	void flush(double now, size_t max_size, Send &&send) {
		update(now, max_size - Section::HEADER);
		for (auto &[id, client] : _clients) {
			collect(id, client, now, max_size - Section::HEADER);
			pack_sections(client.sections, client.bytes, max_size, _packet, [&send, client_id = id](const uint8_t *bytes, size_t size) { send(client_id, bytes, size); });
			client.bytes.clear();
		}
	}
	/// Sends a client snapshots instead of anything that is in flight.
	void resend_all(PeerId client);
	/// Processes acknowledgements of a client. Those of the server's own stream are passed to accept_own(bytes, size).
	template <class AcceptOwn>
	PacketResult accept(PeerId client, const uint8_t *bytes, size_t size, double now, AcceptOwn &&accept_own) {
		return read_sections(bytes, size, [&](const Section &section) {
			return section.channel == Section::SERVER_CHANNEL ? accept_own(bytes + section.begin, section.size) : accept_section(client, section, bytes, now);
		});
	}

	/// Holds each stream that has contained bodies of other owners, or more than MAX_ABSENT bodies that do not exist here, for longer
	/// than GRACE, and releases it when it no longer does. Calls on_held(owner, error) when a stream is held.
	template <class OnHeld>
	void check_owners(double now, const BodyOwners &owners, OnHeld &&on_held) {
		const double elapsed = std::min(now - _checked_at, 2.0 * CHECK_INTERVAL);
		if (elapsed < CHECK_INTERVAL) {
			return;
		}
		_checked_at = now;
		for (auto &[id, stream] : _streams) {
			const std::optional<PacketError> fault = find_fault(id, *stream.source, owners);
			stream.grace = fault ? stream.grace - elapsed : std::min(stream.grace + GRACE_RECOVERY * elapsed, GRACE);
			const bool holds = fault && stream.grace < 0.0;
			if (holds && !stream.forwarded.is_held()) {
				on_held(id, *fault);
			}
			stream.forwarded.set_held(holds, now);
		}
	}

private:
	static constexpr double CHECK_INTERVAL = 0.2; // seconds
	/// Seconds of grace that a stream without a fault regains each second.
	static constexpr double GRACE_RECOVERY = 0.2;

	struct Stream {
		uint32_t channel;
		Receiver *source;
		ForwardedStream forwarded;
		double grace = GRACE; // seconds for which it may still contain other bodies than its owner's
		std::set<PeerId> known_by; // clients that know the owner of the channel
		WindowAligner aligner;
		uint32_t chunks = 0; // received until the last arrival
		double known_time = 0.0; // of the source at the last arrival
	};
	struct Client {
		std::vector<Section> sections;
		std::vector<uint8_t> bytes; // of the sections
	};

	/// Why a stream must not be forwarded.
	[[nodiscard]] static std::optional<PacketError> find_fault(PeerId owner, const Receiver &stream, const BodyOwners &owners) {
		size_t absent = 0;
		if (stream.has_body_if([&](uint32_t body) {
				absent += owners.exists(body) ? 0 : 1;
				return owners.is_unauthorized(owner, body);
			})) {
			return PacketError::UNAUTHORIZED_BODIES;
		}
		return absent > MAX_ABSENT ? std::optional(PacketError::ABSENT_BODIES) : std::nullopt;
	}
	[[nodiscard]] uint32_t free_channel();
	void update(double now, size_t max_size);
	void collect(PeerId id, Client &client, double now, size_t max_size);
	PacketResult accept_section(PeerId client, const Section &section, const uint8_t *bytes, double now);

	std::map<PeerId, Stream> _streams; // by owner
	std::map<PeerId, Client> _clients;
	std::map<uint32_t, PeerId> _channels; // owners by channel
	uint32_t _last_channel = 0;
	ForwardingSchedule _schedule;
	double _checked_at = -1e9;
	PacketContent _content;
	std::vector<uint8_t> _packet;
};

} // namespace net
