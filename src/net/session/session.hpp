#pragma once

#include "net/endpoint/sender.hpp"
#include "net/session/body_owners.hpp"
#include "net/session/envelope.hpp"
#include "net/session/outbox.hpp"
#include "net/session/peer.hpp"
#include "net/session/relay.hpp"
#include "net/session/relayed_streams.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace net {

/// Replicates bodies between peers, each body from its owner to all others.
///
/// A session holds one Sender for the bodies that its own peer owns, and one Receiver for each peer that sends others. It requests
/// the stream of each connected peer with an OPEN packet and repeats it until the stream arrives, so it does not matter which
/// side starts first. A peer that owns no bodies remembers the request and starts the stream when it owns one. The receiver numbers
/// each stream (its link), which distinguishes its packets from those of an earlier one that are still in flight. Either side ends
/// a stream with a CLOSE packet; the sender does so when it has owned no bodies for a while.
///
/// If the session relays, clients exchange streams with the server only, which forwards the streams of all owners to them.
///
/// The session is independent of the transport: the caller passes packets to `accept` and drains `outbox`. No input is
/// trusted: only a body's owner can move it, and memory for each peer is bounded. Times are in seconds on one local clock, which
/// may jump (see SteadyClock).
class Session {
public:
	/// Settings that are not valid are replaced with the defaults.
	explicit Session(const StreamSettings &settings) :
			_settings(settings.is_valid() ? settings : StreamSettings()) {}

	/// Resets the session to local peer `self` (0: not connected), without peers and bodies. Sends no packets.
	void connect(PeerId self);
	[[nodiscard]] bool is_connected() const { return _self != 0; }
	[[nodiscard]] PeerId self() const { return _self; }
	/// Sets the connected peers, in ascending order. Returns those that have left.
	std::vector<PeerId> set_peers(const std::vector<PeerId> &peers, double now);
	[[nodiscard]] const std::vector<PeerId> &peers() const { return _connected; }
	[[nodiscard]] bool has_peer(PeerId peer) const { return _peers.count(peer) != 0; }
	/// True if an owner's stream can arrive: its peer is connected, or the server relays.
	[[nodiscard]] bool can_receive(PeerId owner) const { return has_peer(owner) || _is_link_relayed; }
	/// The owners whose streams the server relays to this peer, in ascending order.
	[[nodiscard]] std::vector<PeerId> relayed_owners() const { return _relayed.owners(); }
	/// Queues CLOSE packets for all streams.
	void close(double now);

	/// Sets the settings of the outgoing stream, except the tick length, which begin_tick sets. In a session, max_packet_size
	/// includes ENGINE_HEADER bytes, which the engine puts before each packet. Returns false and changes nothing if they are not valid.
	/// max_latency is limited to MAX_LATENCY_TICKS.
	bool set_settings(StreamSettings settings);
	/// Sets whether the server (peer 1) forwards the streams of all owners. Clients then send to the server only. If the server
	/// does not relay, they request the streams of all owners, as without relaying. A change restarts all streams.
	void set_relay(bool relay);
	[[nodiscard]] bool relay() const { return _relay; }
	static constexpr size_t ENGINE_HEADER = 12;
	/// Reports that the transport refused a packet of `size` bytes to a peer because it is too large. Reduces the maximum packet size
	/// to three quarters of that, but not below StreamSettings::MIN_PACKET_SIZE, until the session connects again. Returns it.
	size_t packet_refused(PeerId peer, size_t size);
	/// See Receiver::set_margin_limits.
	void set_margin_limits(double min, double max);

	/// Maximum number of bodies in the stream of a peer. It bounds the memory that a peer can make us allocate.
	static constexpr size_t MAX_BODIES = 65536;
	/// Adds a body, or changes its owner.
	void set_owner(uint32_t body, PeerId owner);
	void remove_body(uint32_t body) { remove_body(body, false); }
	/// Removes a body whose object is freed: peers see it up to its last pose, then Receiver::end reports BodyEnd::FREED.
	void free_body(uint32_t body) { remove_body(body, true); }

	/// Begins a tick and advances media time by `length` seconds, limited to TICK_RANGE. Ignores a length that is not positive.
	void begin_tick(double now, double length);
	/// True while a peer receives the outgoing stream. Only then do bodies have to be observed, once per tick.
	[[nodiscard]] bool is_sending() const { return _sender.has_value(); }
	/// Records the pose of an owned body at this tick. Returns false if the pose is invalid: peers then see the last one.
	/// `planar` applies to a body without a pose in the current stream, see Sender::add_body.
	bool observe(uint32_t body, const cga::Pose<double> &pose, bool planar = false);
	/// Records that the body is still at its last pose. Returns false if the current stream has no pose of it yet.
	bool observe(uint32_t body) { return _sender && _sender->observe(body, time()); }
	/// Makes an owned body jump to its next pose without interpolation.
	void teleport(uint32_t body);
	/// See Sender::set_priority. It lasts until the body is removed or changes its owner. Returns false if this peer does not own the body.
	bool set_priority(uint32_t body, int priority);
	/// Ends the tick: queues the packets that are due, or closes the outgoing streams if they have not been needed for a while.
	void end_tick();

	/// Advances playback to `now` and queues requests and acknowledgements. Call it once per frame.
	void advance(double now);
	/// The incoming stream of an owner, relayed or not; null until its first snapshot has arrived.
	[[nodiscard]] const Receiver *stream(PeerId peer) const;
	/// Number of bodies in the incoming stream of a peer. A stream of more than MAX_BODIES is refused, and requested again after pauses
	/// of 0.25 to 30 s.
	[[nodiscard]] size_t stream_size(PeerId peer) const;
	/// The media time of the outgoing stream, or the media time shown of another peer's stream; 0 if there is no stream.
	[[nodiscard]] double media_time(PeerId peer) const;

	/// Processes a packet from a connected peer. Packets without this session's envelope are ignored.
	void accept(PeerId peer, const uint8_t *bytes, size_t size, double now);
	[[nodiscard]] Outbox &outbox() { return _outbox; }

	/// Calls report(peer, report) for peers whose packets were rejected, at most every half second per peer.
	template <class ReportTo>
	void report_rejections(ReportTo &&report) {
		// Collect the reports first, as the callee may change the session.
		std::vector<std::pair<PeerId, Rejections::Report>> reports;
		for (auto &[id, peer] : _peers) {
			if (const auto due = peer.rejections.take_report(_now)) {
				reports.emplace_back(id, *due);
			}
		}
		for (const auto &entry : reports) {
			report(entry.first, entry.second);
		}
	}
	[[nodiscard]] SessionStatistics statistics(PeerId peer, double now);
	/// Totals over all peers. The counts of late and rejected packets include peers that have left.
	[[nodiscard]] SessionStatistics total_statistics(double now);

private:
	/// Returns the steady time.
	double set_now(double now);
	[[nodiscard]] double time() const { return _first_tick + double(_tick) * _settings.tick; } // seconds, outgoing stream
	void remove_body(uint32_t body, bool freed);
	[[nodiscard]] StreamSettings sender_settings() const;
	void end_stream(PeerId id, Peer &peer);
	void end_if_refused(PeerId id, Peer &peer, const PacketResult &result);
	PacketResult accept_open(PeerId id, Peer &peer, uint8_t link, const uint8_t *bytes, size_t size);
	void start_requested();
	void start_stream(PeerId id, Peer &peer);
	void close_subscription(PeerId id, Peer &peer);
	void unsubscribe(PeerId id, Peer &peer);
	void send(PeerId id, Peer &peer, PacketKind kind, uint8_t link, const uint8_t *bytes, size_t size);
	void send_open(PeerId id, Peer &peer, uint8_t link, uint8_t flags, uint16_t token);
	void send_close(PeerId id, Peer &peer, uint8_t link, CloseRole role);
	void send_motion();
	PacketResult accept_motion(PeerId id, Peer &peer, uint8_t link, const uint8_t *bytes, size_t size, double now);
	PacketResult accept_ack(PeerId id, Peer &peer, uint8_t link, const uint8_t *bytes, size_t size, double now);
	PacketResult accept_close(PeerId id, Peer &peer, uint8_t link, const uint8_t *bytes, size_t size);

	// Relaying (session_relay.cpp).
	[[nodiscard]] bool is_relaying() const { return _relay && _self == RelayedStreams::SERVER; }
	[[nodiscard]] bool is_relayed(PeerId sender) const { return _is_link_relayed && sender == RelayedStreams::SERVER; }
	void update_relay();
	PacketResult note_relay(PeerId id, Peer &peer, bool relay);
	void end_relayed(PeerId id);
	void send_relayed();
	void acknowledge_relayed(Peer &server);

	StreamSettings _settings;
	size_t _size_limit = StreamSettings::MAX_PACKET_SIZE; // of the transport, as far as known
	PeerId _self = 0;
	std::vector<PeerId> _connected;
	std::map<PeerId, Peer> _peers; // by id: the peers in _connected
	BodyOwners _owners;
	size_t _owned = 0; // number of bodies that this peer owns
	double _owned_at = -1e9; // local time when it last owned one
	std::optional<Sender> _sender; // while a peer is subscribed
	double _first_tick = 0.0; // time() when the tick length last changed
	int64_t _tick = 0; // ticks since _first_tick
	SteadyClock _clock; // the local one
	double _now = 0.0; // steady local time of the last call
	double _running_time = 0.0; // local time without the time in which the process stood still
	double _min_margin = 0.0;
	double _max_margin = -1.0;
	uint64_t _rejected = 0; // total over all peers
	uint64_t _late = 0; // late windows of streams that have ended
	bool _relay = false;
	bool _is_link_relayed = false; // we are a client and request a relayed stream from the server
	Relay _relayer; // if we are the server
	double _relayed_at = 0.0; // _running_time when it last sent
	bool _has_forwarded = false; // since the last `advance`
	RelayedStreams _relayed; // if we are a client
	Outbox _outbox;
	std::vector<uint8_t> _ack;
};

} // namespace net
