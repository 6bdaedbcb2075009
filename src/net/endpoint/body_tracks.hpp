#pragma once

#include "net/motion/motion_track.hpp"
#include "net/stream/stream_decoder.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

namespace net {

struct BodyEvent {
	enum Kind : uint8_t {
		ADDED,
		REMOVED
	};
	Kind kind;
	uint32_t id;
};

/// Whether and how a life has ended.
enum class BodyEnd : uint8_t {
	NONE,
	REMOVED,
	FREED, ///< removed because its object was freed
};

/// The jitter buffers of the bodies of one stream, and the ends of their lives. Its memory is bounded, whatever the stream contains
/// and whether or not playback advances: see max_tracks and max_capacity. Times are in ticks.
class BodyTracks {
public:
	explicit BodyTracks(size_t max_bodies) :
			_max_bodies(max_bodies) {}
	BodyTracks(BodyTracks &&) = default;
	BodyTracks &operator=(BodyTracks &&) = default;

	void set_max_bodies(size_t max_bodies) { _max_bodies = max_bodies; }

	/// Assigns the motion to a life and appends it to the track of its body.
	void add(BodyMotion &motion);
	/// Makes the bodies of a snapshot, and no others, exist from `tick` on. If the snapshot continues known motion, bodies that did
	/// not exist appear then; otherwise, they have existed before.
	void show_snapshot(const StreamDecoder &decoder, double tick, bool continues);
	/// Drops all motion: playback continues at `tick` of another time line.
	void restart(double tick);
	/// Playback has reached `tick`: drops the bodies that have ended and, some time later, their ends. Ends are known for `end_memory`
	/// ticks.
	void advance(double tick, double end_memory);

	/// The track of a body; null if it is not known.
	[[nodiscard]] const MotionTrack *find(uint32_t id) const;
	/// How a life ended, if it did before `tick` and not longer ago than the last `end_memory`.
	[[nodiscard]] BodyEnd end(uint32_t id, uint64_t life, double tick) const;
	/// The last pose of a life that ends.
	[[nodiscard]] std::optional<cga::Pose<double>> last_pose(uint32_t id, uint64_t life) const;
	/// Ids of the bodies that exist at `tick`.
	[[nodiscard]] std::vector<uint32_t> bodies(double tick) const;
	void take_events(std::vector<BodyEvent> &events) {
		events.clear();
		events.swap(_events);
	}

	/// Number of tracks: of the bodies that exist at the end of known motion, and of those that playback still shows.
	[[nodiscard]] size_t count() const { return _tracks.size(); }
	[[nodiscard]] size_t max_tracks() const { return 2 * _max_bodies + 64; }
	/// Number of segments for which the tracks have allocated memory.
	[[nodiscard]] size_t capacity() const { return _capacity; }
	/// Beyond this, a track gets memory for MotionTrack::MIN_CAPACITY segments only.
	[[nodiscard]] size_t max_capacity() const { return 8 * _max_bodies + 4096; }
	/// Number of tracks that `advance` visits.
	[[nodiscard]] size_t busy_count() const { return _busy.size(); }

private:
	struct Track {
		MotionTrack motions;
		uint32_t snapshot = 0; // number of the last one that contains the body
		bool is_busy = false; // in _busy
	};
	using Tracks = std::unordered_map<uint32_t, Track>;

	struct Ending {
		uint32_t id;
		BodyEnd kind;
		double tick;
		std::optional<cga::Pose<double>> pose; // the last one
	};

	void add(Tracks::value_type &entry, BodyMotion &motion);
	void add_end(const MotionTrack &track, const BodyMotion &motion);
	void add_event(BodyEvent::Kind kind, uint32_t id);
	void mark_busy(Tracks::value_type &entry);
	void erase(uint32_t id);
	void drop_ended();

	size_t _max_bodies;
	Tracks _tracks;
	size_t _capacity = 0;
	std::vector<Tracks::value_type *> _busy; // those that time changes
	uint32_t _snapshot = 0; // number of snapshots
	std::map<uint64_t, Ending> _ends; // by life: recent ones and those that playback has not reached
	double _end_memory = 0.0;
	double _ends_checked = 0.0; // when ends were last dropped
	std::vector<BodyEvent> _events;
};

} // namespace net
