#pragma once

#include "net/delivery/delivery.hpp"
#include "net/endpoint/window_grid.hpp"
#include "net/stream/stream_encoder.hpp"
#include "net/stream/stream_settings.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace net {

/// A packet for one receiver.
struct OutgoingPacket {
	uint32_t receiver = 0;
	size_t begin = 0; ///< offset in Sender::bytes()
	size_t size = 0;
};

/// One encoding of the motion of a sender's bodies, and its delivery to receivers. A copy continues the stream for some of the receivers,
/// which notice nothing of it. Times are in ticks, those of the network (`now`) in seconds.
///
/// If the line of a receiver does not carry the stream, the tolerances grow (`relaxation`) until it does.
class OutgoingStream {
public:
	struct Peer {
		Delivery delivery;
		uint64_t bytes_sent = 0;
		uint64_t packets_sent = 0;
		double joined_at = 0.0; ///< when it began to receive this stream
		double differs_since = -1.0; ///< since when its line has fitted the other stream better; -1: it has not
	};
	using Peers = std::map<uint32_t, Peer>;

	/// What a call of `flush` needs.
	struct Flush {
		int64_t tick; ///< up to which poses have been observed
		int64_t previous_tick; ///< of the previous flush
		double step; ///< expected ticks until the next
		double now;
		const std::optional<WindowGrid> &grid; ///< at which windows end
		uint8_t &snapshot_number; ///< of the last snapshot
	};

	explicit OutgoingStream(const StreamSettings &settings) :
			_settings(settings) {}

	/// Starts an encoder at `begin`; its bodies are to be added next.
	void start(double begin, double now);
	void stop() { _encoder.reset(); }
	[[nodiscard]] bool is_running() const { return _encoder.has_value(); }
	/// Requires is_running().
	[[nodiscard]] StreamEncoder &encoder() { return *_encoder; }
	[[nodiscard]] const StreamEncoder &encoder() const { return *_encoder; }
	void set_settings(const StreamSettings &settings) { _settings = settings; }

	[[nodiscard]] Peers &peers() { return _peers; }
	[[nodiscard]] const Peers &peers() const { return _peers; }

	/// Media time starts again, or there is no receiver.
	void set_window_begin(int64_t tick) { _window_begin = tick; }
	[[nodiscard]] int64_t window_begin() const { return _window_begin; }

	/// Closes the window if it is due, and makes the snapshots that are needed. Requires is_running().
	void flush(const Flush &flush);
	/// Appends the packets that are due for all receivers, and their bytes.
	void send(double now, std::vector<uint8_t> &bytes, std::vector<OutgoingPacket> &packets);
	void accept(Peer &peer, const PacketContent &content, double now) { peer.delivery.accept(content, _ring, now); }

	/// Maximum length of a window.
	[[nodiscard]] double max_window(double now) const;
	/// Seconds from the end of a window to the arrival of its last chunk that windows leave for the line of a peer; 0 for a peer that
	/// acknowledges nothing.
	[[nodiscard]] double network_time(const Peer &peer, double now) const;
	/// Seconds that a line needs for what waits to be sent to it, if that is what limits it.
	[[nodiscard]] double waiting_time(const Peer &peer) const;
	/// Bytes per second.
	[[nodiscard]] double rate() const { return _ring.rate(); }
	/// The factor by which errors may exceed the tolerances, 1 or more.
	[[nodiscard]] double relaxation() const { return _encoder ? double(1 << _encoder->coarseness()) : 1.0; }

private:
	[[nodiscard]] bool is_window_due(const Flush &flush) const;
	/// The first chunk that a receiver may still need.
	[[nodiscard]] uint32_t oldest_needed(double now) const;
	void close_window(int64_t end, double now);
	[[nodiscard]] double carried_rate(double now) const;
	void adapt(double seconds, double now);
	void start_snapshots(const Flush &flush);

	StreamSettings _settings;
	std::optional<StreamEncoder> _encoder; // only while there are receivers
	bool _is_starting = false; // the encoder waits for the poses of its first tick
	ChunkRing _ring;
	Peers _peers;
	std::vector<uint8_t> _window;
	int64_t _window_begin = 0;
	int64_t _changed_since = -1; // -1: nothing has changed
	double _relaxation = 0.0; // octaves by which errors may exceed the tolerances
	double _chunks_per_tick = 0.0; // in the last window
};

} // namespace net
