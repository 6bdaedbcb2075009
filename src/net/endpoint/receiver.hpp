#pragma once

#include "net/delivery/chunk_buffer.hpp"
#include "net/delivery/chunk_ring.hpp"
#include "net/delivery/fragment_buffer.hpp"
#include "net/delivery/playback_clock.hpp"
#include "net/motion/motion_track.hpp"
#include "net/stream/snapshot_header.hpp"
#include "net/stream/steady_clock.hpp"
#include "net/stream/stream_decoder.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
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

struct BodyEvent {
	enum Kind : uint8_t {
		ADDED,
		REMOVED
	};
	Kind kind;
	uint32_t id;
};

/// A body as it is shown. Each appearance of a body (when it is added, not when it jumps) has a life number: lives of one process are
/// numbered from 1, in ascending order over all streams.
struct ShownBody {
	cga::Pose<double> pose;
	uint64_t life = 0;
	bool is_early = false; ///< playback has not reached the first known motion: this is its first pose
};

/// Whether and how a life has ended.
enum class BodyEnd : uint8_t {
	NONE,
	REMOVED,
	FREED, ///< removed because its object was freed
};

/// Receives one authority's stream: takes packets in any order, keeps a jitter buffer for each body, and shows all bodies at
/// one media time. It performs no I/O. `now` is in seconds on the receiver's own clock, which may
/// jump (see SteadyClock); an invalid time counts as that of the previous call.
class Receiver {
public:
	/// Rejects streams with more than `max_bodies` bodies.
	explicit Receiver(size_t max_bodies = 65536) :
			_max_bodies(max_bodies) {}

	/// Processes a packet. A rejected packet leaves the decoded motion unchanged. Duplicates are allowed.
	PacketResult accept(const uint8_t *packet, size_t size, double now);
	/// Replaces `packet` with acknowledgements and requests, or clears it if none are due. Call it once per frame, after the
	/// frame's packets.
	void take_ack(std::vector<uint8_t> &packet, double now);

	/// True once a snapshot has arrived.
	[[nodiscard]] bool is_ready() const { return _decoder.has_value(); }
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
	[[nodiscard]] BodyEnd end(uint32_t id, uint64_t life) const;
	static constexpr double END_MEMORY = 2.0;
	/// The last pose of a life that has ended (see `end`).
	[[nodiscard]] std::optional<cga::Pose<double>> last_pose(uint32_t id, uint64_t life) const;
	/// The life of the body at known_time(); 0 if it does not exist then.
	[[nodiscard]] uint64_t life_at_known_end(uint32_t id) const;
	/// Ids of the bodies shown.
	[[nodiscard]] std::vector<uint32_t> bodies() const;
	/// Replaces `events` with the bodies that were added and removed since the last call, in order.
	void take_events(std::vector<BodyEvent> &events) {
		events.clear();
		events.swap(_events);
	}

	/// Number of bodies in the stream. Of a stream with more than max_bodies, whose snapshot was rejected, the number that the snapshot
	/// declared, or max_bodies + 1 if it is larger than any snapshot may be.
	[[nodiscard]] size_t stream_size() const { return _refused_size > 0 ? _refused_size : (_decoder ? _decoder->body_count() : 0); }
	/// True if the last snapshot was rejected because it has more than max_bodies bodies.
	[[nodiscard]] bool is_refused() const { return _refused_size > 0; }

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
	struct Ending {
		uint32_t id;
		BodyEnd kind;
		double tick;
		std::optional<cga::Pose<double>> pose; // the last one
	};

	/// `is_copy`: a newer window arrived in the same packet.
	void count_loss(uint16_t number, bool is_copy, double now);
	PacketResult check_fragments();
	void take_fragment(const FragmentItem &fragment, double now);
	PacketResult finish_snapshot(double now);
	void show_snapshot(bool continues);
	[[nodiscard]] bool is_next_snapshot() const;
	[[nodiscard]] bool is_behind(const SnapshotHeader &next) const;
	[[nodiscard]] bool needs_snapshot(double now) const;
	void decode_windows(double now);
	void show(BodyMotion &motion);
	void add(MotionTrack &track, BodyMotion &motion);
	void set_limits();
	/// The delay implied by the sender's max_latency, regardless of current network conditions.
	[[nodiscard]] double usual_delay() const { return std::max(_header.settings.max_latency - FRAME, 0.0); }
	[[nodiscard]] double tick() const { return _header.settings.tick; }

	size_t _max_bodies;
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
	SteadyClock _local_clock; // of `now`
	std::unordered_map<uint32_t, MotionTrack> _tracks;
	std::map<uint64_t, Ending> _ends; // by life: recent ones and those that playback has not reached
	std::vector<BodyEvent> _events;
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
	double _fragment_time = -1e9; // when the last new fragment arrived
	double _request_time = -1e9;
	uint16_t _newest_chunk = 0;
	double _newest_chunk_time = -1e9; // when it arrived
	double _min_margin = 0.0;
	double _max_margin = -1.0; // negative: max_latency
	StreamStatistics _statistics;
};

} // namespace net
