#pragma once

#include "net/delivery/chunk_buffer.hpp"
#include "net/delivery/chunk_ring.hpp"
#include "net/delivery/fragment_buffer.hpp"
#include "net/delivery/playback_clock.hpp"
#include "net/endpoint/body_tracks.hpp"
#include "net/endpoint/receiver_budget.hpp"
#include "net/stream/snapshot_header.hpp"
#include "net/stream/steady_clock.hpp"
#include "net/stream/stream_decoder.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace net {

struct StreamStatistics {
	uint64_t bytes_received = 0;
	uint64_t packets_received = 0;
	uint64_t packets_rejected = 0;
	uint64_t late_windows = 0; ///< windows that arrived after playback had reached their begin
	double playback_delay = 0.0; ///< seconds behind the newest media time that can have arrived
	double jitter = 0.0; ///< seconds between the earliest and the latest recent arrivals
	double round_trip = 0.0; ///< seconds, as measured by the sender; 0 before it reports one
	double loss = 0.0; ///< recent fraction of chunks that arrived after or with a newer window
};

/// A body as it is shown. Each appearance of a body (when it is added, not when it jumps) has a life number: lives of one process are
/// numbered from 1, in ascending order over all streams.
struct ShownBody {
	cga::Pose<double> pose;
	uint64_t life = 0;
	bool is_early = false; ///< playback has not reached the first known motion: this is its first pose
};

/// Receives one authority's stream: takes packets in any order, keeps a jitter buffer for each body, and shows all bodies at
/// one media time. It performs no I/O. `now` is in seconds on the receiver's own clock, which may
/// jump (see SteadyClock); an invalid time counts as that of the previous call.
///
/// No sender is trusted. Memory, on 64-bit machines: the packets of the receive window (ChunkBuffer), and for each of max_bodies bodies
/// at most 1.2 kB to decode them, 2 tracks of 0.1 kB and 12 segments of 0.2 kB (see BodyTracks), and 0.1 kB for a snapshot that is
/// arriving. That is 4 kB a body, 270 MB for 65,536 bodies, of which bodies at rest take 35 MB. While a window is decoded, its
/// segments take up to 13 MB, and 3.3 kB for each body, at most 120 MB. Work is bounded by budgets that real time refills
/// (ReceiverBudget): windows and snapshots wait for them, and a stream that has waited for ReceiverBudget::MAX_WAIT seconds is refused.
class Receiver {
public:
	/// Rejects streams with more than `max_bodies` bodies. `budget` limits the work of all receivers that share it.
	explicit Receiver(size_t max_bodies = 65536, std::shared_ptr<WorkBudget> budget = nullptr) :
			_max_bodies(max_bodies), _bodies(max_bodies), _budget(std::move(budget)) {}

	/// Processes a packet. A rejected packet leaves the decoded motion unchanged. Duplicates are allowed.
	PacketResult accept(const uint8_t *packet, size_t size, double now);
	/// Replaces `packet` with acknowledgements and requests, or clears it if none are due. Call it once per frame, after the
	/// frame's packets.
	void take_ack(std::vector<uint8_t> &packet, double now);

	/// True once a snapshot has arrived.
	[[nodiscard]] bool is_ready() const { return _decoder.has_value(); }
	/// Decodes what has waited for the budget or the end of the frame, as `advance` does. Fails as `accept` does.
	PacketResult decode_waiting(double now);
	/// Advances playback to `now`. Media time runs backwards only after the sender stood still.
	void advance(double now);
	/// The media time shown: seconds on the sender's clock since its stream began.
	[[nodiscard]] double media_time() const { return _clock.media_time(); }
	/// The media time that playback will show at `now`, without advancing it.
	[[nodiscard]] double media_time_at(double now) const { return _clock.media_time_at(_local_clock.at(now)); }
	/// The media time up to which all motion has arrived.
	[[nodiscard]] double known_time() const { return _window_end * tick(); }

	/// The pose of a body at media_time(). Returns std::nullopt if the body does not exist then.
	[[nodiscard]] std::optional<cga::Pose<double>> pose(uint32_t id) const { return pose_at(id, media_time()); }
	/// The pose of a body at another media time, not before media_time().
	[[nodiscard]] std::optional<cga::Pose<double>> pose_at(uint32_t id, double media_time) const;
	/// The body at media_time(). Returns std::nullopt if it does not exist then.
	[[nodiscard]] std::optional<ShownBody> shown(uint32_t id) const;
	/// The first known pose of the first life from `min_life` on. It may be shown only later, but is not earlier than media_time().
	[[nodiscard]] std::optional<ShownBody> first_known(uint32_t id, uint64_t min_life) const;
	/// How a life of the body ended, once playback has reached its end, and for END_MEMORY seconds of media time from then on;
	/// otherwise NONE.
	[[nodiscard]] BodyEnd end(uint32_t id, uint64_t life) const { return _bodies.end(id, life, media_time() / tick()); }
	static constexpr double END_MEMORY = 2.0;
	/// The last pose of a life that has ended (see `end`).
	[[nodiscard]] std::optional<cga::Pose<double>> last_pose(uint32_t id, uint64_t life) const { return _bodies.last_pose(id, life); }
	/// The life of the body at known_time(); 0 if it does not exist then.
	[[nodiscard]] uint64_t life_at_known_end(uint32_t id) const;
	/// Ids of the bodies shown.
	[[nodiscard]] std::vector<uint32_t> bodies() const { return _bodies.bodies(media_time() / tick()); }
	/// Replaces `events` with the bodies that were added and removed since the last call, in order.
	void take_events(std::vector<BodyEvent> &events) { _bodies.take_events(events); }
	/// The jitter buffers of the bodies.
	[[nodiscard]] const BodyTracks &tracks() const { return _bodies; }

	/// Number of bodies in the stream. Of a stream with more than max_bodies, whose snapshot was rejected, the number that the snapshot
	/// declared, or max_bodies + 1 if it is larger than any snapshot may be.
	[[nodiscard]] size_t stream_size() const { return _refused_size > 0 ? _refused_size : body_count(); }
	/// True if the stream is refused: its last snapshot has more than max_bodies bodies, or it takes too much work, which `accept` has
	/// reported as TOO_MUCH_WORK. In the latter case, packets are ignored for a pause of 0.25 to 30 s, twice as long each time; then a
	/// snapshot is requested.
	[[nodiscard]] bool is_refused() const { return _refused_size > 0 || _budget.is_refused(); }
	[[nodiscard]] const ReceiverBudget &budget() const { return _budget; }
	/// Changes the maximum number of bodies; those of the stream remain.
	void set_max_bodies(size_t max_bodies);
	/// Number of bodies for which the receiver holds memory: those of the stream, and an estimate for a snapshot that is arriving.
	[[nodiscard]] size_t held_bodies() const;

	/// The version of the last snapshot that was rejected because of its version.
	[[nodiscard]] uint8_t other_version() const { return _other_version; }

	/// Limits of the playback delay, in seconds: at least `min`, at most the stream's max_latency plus `max`. By default,
	/// `max` is the stream's max_latency.
	void set_margin_limits(double min, double max);
	[[nodiscard]] const StreamSettings &settings() const { return _header.settings; }
	[[nodiscard]] const StreamStatistics &statistics() const { return _statistics; }

	/// Keeps the last windows from now on, as chunks for packets of `max_packet_size` bytes, so that a ForwardedStream can send them.
	/// Chunks before `oldest_needed` may be dropped.
	void record(size_t max_packet_size, uint32_t oldest_needed = 0xffffffff) {
		_record_size = max_packet_size;
		_record_needed = oldest_needed;
		if (!_record) {
			_record.emplace();
		}
	}
	/// The windows decoded since the last snapshot and earlier ones; null unless they are recorded.
	[[nodiscard]] const ChunkRing *recorded() const { return _record ? &*_record : nullptr; }
	/// The sender's maximum window length when the last snapshot was made, in seconds.
	[[nodiscard]] double max_window() const { return double(_header.window); }
	/// Number of snapshots decoded. The windows recorded before a snapshot do not continue after it.
	[[nodiscard]] uint32_t snapshot_count() const { return _snapshot_count; }
	/// Appends a snapshot of the state at known_time(). Requires is_ready().
	void encode_snapshot(std::vector<uint8_t> &bytes);
	/// True if a body exists at known_time() for which matches(id) is true.
	template <class Matches>
	[[nodiscard]] bool has_body_if(Matches &&matches) const {
		for (size_t i = 0; _decoder && i < _decoder->body_count(); ++i) {
			if (matches(_decoder->id(i))) {
				return true;
			}
		}
		return false;
	}

private:
	/// `is_copy`: a newer window arrived in the same packet.
	void count_loss(uint16_t number, bool is_copy, double now);
	void free_unusual_memory();
	/// Refuses a stream that exceeds the budget.
	PacketResult refuse(double now);
	/// Decodes what has arrived, as far as the budget allows. `is_prompt`: more packets of this frame may follow.
	PacketResult decode(double now, bool is_prompt);
	[[nodiscard]] bool must_wait(double now) const;
	[[nodiscard]] size_t body_count() const { return _decoder ? _decoder->body_count() : 0; }
	PacketResult check_fragments();
	void take_fragment(const FragmentItem &fragment, double now);
	PacketResult finish_snapshot(double now);
	[[nodiscard]] bool is_next_snapshot() const;
	[[nodiscard]] bool is_behind(const SnapshotHeader &next) const;
	[[nodiscard]] bool needs_snapshot(double now) const;
	/// Returns false if windows have to wait.
	bool decode_windows(double now);
	void set_limits();
	[[nodiscard]] double max_delay() const;
	/// The delay implied by the sender's max_latency, regardless of current network conditions.
	[[nodiscard]] double usual_delay() const { return std::max(_header.settings.max_latency - FRAME, 0.0); }
	[[nodiscard]] double tick() const { return _header.settings.tick; }

	size_t _max_bodies;
	uint8_t _other_version = 0;
	size_t _refused_size = 0; // bodies in the last snapshot, if there were too many
	PacketContent _content;
	ChunkBuffer _chunks;
	std::optional<StreamDecoder> _decoder; // set by the first snapshot
	SnapshotHeader _header;
	std::optional<ChunkRing> _record;
	size_t _record_size = 0; // maximum packet size
	uint32_t _record_needed = 0; // the oldest chunk needed
	uint32_t _snapshot_count = 0;
	double _window_end = 0.0; // ticks
	PlaybackClock _clock;
	BodyTracks _bodies;
	SteadyClock _local_clock; // of `now`
	std::vector<BodyMotion> _motions;
	std::vector<uint8_t> _window;

	FragmentBuffer _fragments; // the snapshot being received, or the last one
	bool _snapshot_done = false; // the last snapshot has been decoded, or skipped as late
	uint8_t _last_snapshot = 0; // number of the last decoded snapshot
	bool _broken = false; // decoding cannot continue without a new snapshot
	bool _ack_due = false;
	bool _snapshot_ack_due = false;
	bool _has_heard = false;
	double _progress_time = 0.0; // when a window was last decoded or a new fragment arrived; initially the first packet
	double _chunk_time = -1e9; // when a chunk last arrived
	double _fragment_time = -1e9; // when the last new fragment arrived
	double _request_time = -1e9;
	uint16_t _newest_chunk = 0;
	double _newest_chunk_time = -1e9; // when it arrived
	ReceiverBudget _budget;
	double _min_margin = 0.0;
	double _max_margin = -1.0; // negative: max_latency
	StreamStatistics _statistics;
};

} // namespace net
