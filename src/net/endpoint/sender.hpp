#pragma once

#include "net/delivery/delivery.hpp"
#include "net/endpoint/window_grid.hpp"
#include "net/stream/steady_clock.hpp"
#include "net/stream/stream_encoder.hpp"
#include "net/stream/stream_settings.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

namespace net {

/// A packet for one receiver.
struct OutgoingPacket {
	uint32_t receiver = 0;
	size_t begin = 0; ///< offset in Sender::bytes()
	size_t size = 0;
};

struct ReceiverStatistics {
	uint64_t bytes_sent = 0;
	uint64_t packets_sent = 0;
	uint64_t chunks_repeated = 0;
	double loss = 0.0; ///< recent fraction of chunks that had to be retransmitted
	double round_trip = 0.0; ///< seconds, smoothed; 0 before the first acknowledgement
};

/// Sends the poses of one authority's bodies to any number of receivers. It performs no I/O: the caller takes packets after
/// `flush` and passes acknowledgements to `accept`. Times are in seconds. `time` is the clock of the motion, which may stand still;
/// `now` is the clock of the network, on which round trips and silence are measured. They may be the same. Both may jump (see
/// SteadyClock): if `time` steps back by more than a second, media time goes on from where it is. After a step forward of more than 4096
/// ticks the stream goes on with a snapshot. Invalid times (see is_valid_time) are ignored.
///
/// Each window is encoded once for all receivers, as a delta from the previous window. Lost windows are retransmitted; a
/// receiver that is new or too far behind gets a snapshot.
class Sender {
public:
	/// Settings that are not valid are replaced with the defaults.
	explicit Sender(const StreamSettings &settings) :
			_settings(settings.is_valid() ? settings : StreamSettings()) {}

	/// Adds a body at a pose. False if the id is taken or the pose is not finite or out of range. A planar body moves in the plane
	/// z = 0 and rotates about z: other coordinates of its poses are ignored.
	/// It exists from `time` on; by default, from the last flush on.
	bool add_body(uint32_t id, const cga::Pose<double> &pose, bool planar = false, std::optional<double> time = std::nullopt);
	/// `freed`: its object was freed; receivers then report BodyEnd::FREED. Returns false if the body does not exist.
	bool remove_body(uint32_t id, bool freed = false) { return _encoder ? _encoder->remove_body(id, ticks(_time), freed) : _idle_bodies.erase(id) != 0; }
	[[nodiscard]] bool has_body(uint32_t id) const { return _encoder ? _encoder->has_body(id) : _idle_bodies.count(id) != 0; }
	[[nodiscard]] size_t body_count() const { return _encoder ? _encoder->body_count() : _idle_bodies.size(); }

	/// Records the pose of a body at `time`; times must not decrease. False, with no change, if the body does not exist or
	/// the pose is not finite or out of range.
	bool observe(uint32_t id, double time, const cga::Pose<double> &pose);
	/// Records that the body is still at its last pose. Returns false if the body does not exist.
	bool observe(uint32_t id, double time);
	/// Makes the body jump to its next observed pose without interpolation. Returns false if the body does not exist.
	bool teleport(uint32_t id) { return _encoder ? _encoder->jump(id) : has_body(id); }

	void add_receiver(uint32_t receiver, double time, double now);
	void add_receiver(uint32_t receiver, double time) { add_receiver(receiver, time, time); }
	void remove_receiver(uint32_t receiver);
	[[nodiscard]] bool has_receiver(uint32_t receiver) const { return _peers.count(receiver) != 0; }

	/// Builds the packets that are due. Call it every tick, after all poses up to `time` have been observed.
	void flush(double time, double now);
	void flush(double time) { flush(time, time); }
	/// The packets of the last flush, valid until the next.
	[[nodiscard]] const std::vector<OutgoingPacket> &packets() const { return _packets; }
	[[nodiscard]] const uint8_t *bytes() const { return _bytes.data(); }

	/// Makes windows end at `time` and at all multiples of `period` seconds before and after, as far as max_latency allows.
	void align(double time, double period) { _grid = WindowGrid{ ticks(_clock.at(time)), period / _settings.tick }; }
	/// Processes a packet from a receiver.
	PacketResult accept(uint32_t receiver, const uint8_t *packet, size_t size, double now);

	/// Sends the receiver a snapshot instead of anything that is in flight.
	void resend_all(uint32_t receiver);

	/// New settings apply from the next window on. A change of any setting but send_rate and max_packet_size restarts
	/// the stream. Returns false and changes nothing if they are not valid.
	bool set_settings(const StreamSettings &settings);
	[[nodiscard]] const StreamSettings &settings() const { return _settings; }
	[[nodiscard]] ReceiverStatistics statistics(uint32_t receiver) const;
	/// Converts a time on the sender's clock to media time (see Receiver::media_time); 0 before the first observation or flush.
	[[nodiscard]] double media_time(double time) const { return _clock.is_running() ? _clock.at(time) - _origin : 0.0; }
	/// Number of bodies that moved in the last window.
	[[nodiscard]] size_t moving_count() const { return _encoder ? _encoder->moving_count() : 0; }

private:
	struct IdleBody {
		cga::Pose<double> pose; // the last one
		bool planar = false;
	};

	struct Peer {
		Delivery delivery;
		uint64_t bytes_sent = 0;
		uint64_t packets_sent = 0;
	};

	/// Converts a steady time to media time in ticks.
	[[nodiscard]] double ticks(double time) const { return (time - _origin) / _settings.tick; }
	/// Sets the pose of a body while there is no encoder. Returns false if it is not finite or out of range.
	[[nodiscard]] bool set_idle_pose(IdleBody &body, const cga::Pose<double> &pose) const;
	/// Converts a time of the motion to a steady time.
	double follow(double time);
	/// Media time begins at a steady time.
	void begin_at(double time);
	/// Starts the stream at the first tick at which all poses are known.
	void start_encoder(int64_t last_flush);
	void stop_encoder();
	[[nodiscard]] double max_window() const;
	void take_alignment(const AlignItem &request, double now);
	[[nodiscard]] bool is_window_due(int64_t now) const;
	/// The first chunk that a receiver may still need.
	[[nodiscard]] uint32_t oldest_needed() const;
	void close_window(int64_t end);
	void start_snapshots();
	[[nodiscard]] std::shared_ptr<Snapshot> make_snapshot();
	void send_all();

	StreamSettings _settings;
	std::optional<StreamEncoder> _encoder; // only while there are receivers
	bool _is_starting = false; // the encoder waits for the poses of its first tick
	std::unordered_map<uint32_t, IdleBody> _idle_bodies; // while there is no encoder
	ChunkRing _ring;
	std::map<uint32_t, Peer> _peers;
	std::vector<uint8_t> _window;
	std::vector<uint8_t> _bytes;
	std::vector<OutgoingPacket> _packets;
	PacketContent _content;
	uint8_t _snapshot_number = 0; // of the last snapshot; starts at random, to differ from those of an earlier sender
	bool _has_snapshot_number = false;
	SteadyClock _clock; // of the motion
	SteadyClock _network_clock;
	double _time = 0.0; // of the last flush, steady
	double _observed = 0.0; // steady time of the last pose
	double _now = 0.0;
	double _origin = 0.0; // steady time of tick 0
	int64_t _window_begin = 0; // ticks
	int64_t _last_flush = 0; // ticks
	int64_t _changed_since = -1; // tick; -1: nothing has changed
	double _step = 1.0; // ticks between flushes
	std::optional<WindowGrid> _grid; // at which windows end
	uint8_t _alignment = 0; // number of the last request to align
	double _aligned_at = -1e9; // time of that request
	double _chunks_per_tick = 0.0; // in the last window
};

} // namespace net
