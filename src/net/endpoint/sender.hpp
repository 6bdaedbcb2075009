#pragma once

#include "net/endpoint/outgoing_stream.hpp"
#include "net/stream/steady_clock.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

namespace net {

struct ReceiverStatistics {
	uint64_t bytes_sent = 0;
	uint64_t packets_sent = 0;
	uint64_t chunks_repeated = 0;
	double loss = 0.0; ///< recent fraction of chunks that had to be retransmitted
	double round_trip = 0.0; ///< seconds, smoothed; 0 before the first acknowledgement
	double line_rate = 0.0; ///< bytes per second that its line carries; 0 if it carries all that is sent
	double relaxation = 1.0; ///< factor by which errors may exceed the tolerances, because the line does not carry more
};

/// Sends the poses of one authority's bodies to any number of receivers. It performs no I/O: the caller takes packets after
/// `flush` and passes acknowledgements to `accept`. Times are in seconds. `time` is the clock of the motion, which may stand still;
/// `now` is the clock of the network, on which round trips and silence are measured. They may be the same. Both may jump (see
/// SteadyClock): if `time` steps back by more than a second, media time goes on from where it is. After a step forward of more than 4096
/// ticks the stream goes on with a snapshot. Invalid times (see is_valid_time) are ignored.
///
/// Each window is encoded once for all receivers, as a delta from the previous window. Lost windows are retransmitted; a
/// receiver that is new or too far behind gets a snapshot. Receivers whose lines are much worse than those of the others get an encoding
/// of their own, with shorter windows and larger errors, so that they do not cost the others anything.
class Sender {
public:
	/// Settings that are not valid are replaced with the defaults.
	explicit Sender(const StreamSettings &settings) :
			_settings(settings.is_valid() ? settings : StreamSettings()) {
		_streams.push_back(std::make_unique<OutgoingStream>(_settings));
	}

	/// Adds a body at a pose. False if the id is taken or the pose is not finite or out of range. A planar body moves in the plane
	/// z = 0 and rotates about z: other coordinates of its poses are ignored.
	/// It exists from `time` on; by default, from the last flush on.
	bool add_body(uint32_t id, const cga::Pose<double> &pose, bool planar = false, std::optional<double> time = std::nullopt);
	/// `freed`: its object was freed; receivers then report BodyEnd::FREED. Returns false if the body does not exist.
	bool remove_body(uint32_t id, bool freed = false) {
		return is_running() ? for_each_encoder([&](StreamEncoder &encoder) { return encoder.remove_body(id, ticks(_time), freed); }) : _idle_bodies.erase(id) != 0;
	}
	[[nodiscard]] bool has_body(uint32_t id) const { return is_running() ? main().encoder().has_body(id) : _idle_bodies.count(id) != 0; }
	[[nodiscard]] size_t body_count() const { return is_running() ? main().encoder().body_count() : _idle_bodies.size(); }

	/// Records the pose of a body at `time`; times must not decrease. False, with no change, if the body does not exist or
	/// the pose is not finite or out of range.
	bool observe(uint32_t id, double time, const cga::Pose<double> &pose);
	/// Records that the body is still at its last pose. Returns false if the body does not exist.
	bool observe(uint32_t id, double time);
	/// Makes the body jump to its next observed pose without interpolation. Returns false if the body does not exist.
	bool teleport(uint32_t id) {
		return is_running() ? for_each_encoder([&](StreamEncoder &encoder) { return encoder.jump(id); }) : has_body(id);
	}
	/// If a line carries less than the motion needs, errors grow up to 2^BodyState::MAX_COARSENESS tolerances; that of a body is 2^priority
	/// times smaller than one of priority 0, but not below the tolerance. Clamps the priority to PRIORITY_RANGE. Returns false if the body
	/// does not exist.
	bool set_priority(uint32_t id, int priority);

	void add_receiver(uint32_t receiver, double time, double now);
	void add_receiver(uint32_t receiver, double time) { add_receiver(receiver, time, time); }
	void remove_receiver(uint32_t receiver);
	[[nodiscard]] bool has_receiver(uint32_t receiver) const { return stream_of(receiver) != nullptr; }

	/// Builds the packets that are due. Call it every tick, after all poses up to `time` have been observed.
	void flush(double time, double now);
	void flush(double time) { flush(time, time); }
	/// The packets of the last flush, valid until the next.
	[[nodiscard]] const std::vector<OutgoingPacket> &packets() const { return _packets; }
	[[nodiscard]] const uint8_t *bytes() const { return _bytes.data(); }

	/// Makes windows end at `time` and at all multiples of `period` seconds before and after, as far as max_latency allows.
	void align(double time, double period) { _grid = WindowGrid{ ticks(_clock.at(time)), period / _settings.tick }; }
	/// Processes a packet from a receiver. Requests to align windows, which apply to all receivers, are ignored unless `can_align`.
	PacketResult accept(uint32_t receiver, const uint8_t *packet, size_t size, double now, bool can_align = true);

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
	[[nodiscard]] size_t moving_count() const { return is_running() ? main().encoder().moving_count() : 0; }

private:
	struct IdleBody {
		cga::Pose<double> pose; // the last one
		bool planar = false;
		int priority = 0;
	};

	[[nodiscard]] OutgoingStream &main() { return *_streams.front(); }
	[[nodiscard]] const OutgoingStream &main() const { return *_streams.front(); }
	[[nodiscard]] bool is_running() const { return main().is_running(); }
	/// The stream that a receiver gets; null for an unknown receiver.
	[[nodiscard]] OutgoingStream *stream_of(uint32_t receiver) const;
	/// Calls change(encoder) for the encoder of each stream and returns the result for the first. Requires is_running().
	template <class Change>
	bool for_each_encoder(Change &&change) {
		const bool result = change(main().encoder());
		for (size_t i = 1; i < _streams.size(); ++i) {
			(void)change(_streams[i]->encoder());
		}
		return result;
	}
	/// Drops a stream without receivers, if there is another.
	void merge();
	/// Moves receivers between the streams, according to their lines. Requires is_running().
	void balance();
	void move(uint32_t receiver, OutgoingStream &from, OutgoingStream &to);

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
	void take_alignment(const AlignItem &request, double now);

	StreamSettings _settings;
	std::vector<std::unique_ptr<OutgoingStream>> _streams; // the first always; a second one for receivers with worse lines
	std::unordered_map<uint32_t, IdleBody> _idle_bodies; // while there is no encoder
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
	int64_t _last_flush = 0; // ticks
	double _step = 1.0; // ticks between flushes
	std::optional<WindowGrid> _grid; // at which windows end
	uint8_t _alignment = 0; // number of the last request to align
	double _aligned_at = -1e9; // time of that request
	double _balanced_at = -1e9; // when `balance` last ran
};

} // namespace net
