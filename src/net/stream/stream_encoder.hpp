#pragma once

#include "net/motion/motion_plan.hpp"
#include "net/stream/body_blocks.hpp"
#include "net/stream/stream_header.hpp"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace net {

/// Encodes the poses of many bodies into windows, each as a delta from the previous one. Times are in ticks.
class StreamEncoder {
public:
	StreamEncoder(float position_tolerance, float rotation_tolerance, cga::Mode mode) :
			_grid(position_tolerance, rotation_tolerance), _planner(_grid, mode) {}

	/// False if the id is taken or the pose is not finite or out of range. Of the poses of a planar body, only the planar part
	/// (BodyState::planar_part) is used.
	bool add_body(uint32_t id, double time, const cga::Pose<double> &pose, bool planar = false);
	/// Starts the stream at `tick`, before the first window: a snapshot contains all bodies added until then, at their
	/// poses at that tick. Poses observed between ticks are interpolated.
	void start_at(double tick);
	/// `freed`: its object was freed. Returns false if the body does not exist.
	bool remove_body(uint32_t id, double time, bool freed = false);
	[[nodiscard]] bool has_body(uint32_t id) const { return _index.count(id) != 0; }
	[[nodiscard]] size_t body_count() const { return _index.size(); }
	/// False if there is no such body or the pose is not finite or out of range.
	bool observe(uint32_t id, double time, const cga::Pose<double> &pose);
	/// Records that the body is still at its last pose. Returns false if the body does not exist.
	bool observe(uint32_t id, double time);
	/// Makes the body jump to its next pose without interpolation. Returns false if the body does not exist.
	bool jump(uint32_t id);
	/// Calls visit(id, last pose, planar, priority) for each body.
	template <class Visit>
	void visit_bodies(Visit &&visit) const {
		for (const auto &entry : _index) {
			const Body &body = _bodies[entry.second];
			visit(entry.first, body.latest, body.state.planar, int(body.priority));
		}
	}

	/// Makes tolerances and quantization steps of moving bodies 2^coarseness times larger in the windows that follow; 0 to
	/// BodyState::MAX_COARSENESS.
	void set_coarseness(int coarseness) { _motion.coarseness = coarseness; }
	[[nodiscard]] int coarseness() const { return _motion.coarseness; }
	/// In coarse windows, a body has an error 2^priority times smaller than one of priority 0, but not below the tolerance. Clamps the
	/// priority to PRIORITY_RANGE. Returns false if the body does not exist.
	bool set_priority(uint32_t id, int priority);

	/// True if, since the last window, a body moved or was added, removed or jumped.
	[[nodiscard]] bool has_changes() const { return _changed; }
	/// Number of bodies that moved in the last window.
	[[nodiscard]] size_t moving_count() const { return _moving; }

	/// Appends the window (begin, begin + ticks] to `bytes`. `begin` is the end of the previous window.
	void encode_window(double begin, int ticks, std::vector<uint8_t> &bytes);
	/// Eight-bit checksum of the state of all bodies after the last window.
	[[nodiscard]] uint8_t check() const { return check_bits(_check); }
	/// Appends the state that a receiver needs to decode the next window: the models and all bodies.
	void encode_snapshot(std::vector<uint8_t> &bytes);

	[[nodiscard]] const StreamGrid &grid() const { return _grid; }

private:
	struct Body {
		uint32_t id = 0;
		uint32_t hash = 0; // body_hash(), once receivers know the body
		BodyState state;
		cga::Pose<double> latest; // the last pose observed
		std::vector<MotionSample> samples; // samples not yet encoded
		bool added = false; // pending, or in this window, at `event_time`
		bool jump_next = false;
		bool jumped = false; // pending, at `event_time`
		bool removed = false;
		bool freed = false; // if removed
		uint8_t priority = 0;
		double event_time = 0.0;
		double removal_time = 0.0;
		double encoded_until = 0.0; // time of the last encoded sample

		[[nodiscard]] bool is_removed_by(double time) const { return removed && removal_time <= time; }
		[[nodiscard]] bool is_jumped_by(double time) const { return jumped && event_time <= time; }
		[[nodiscard]] bool has_event_by(double time) const { return added || is_jumped_by(time) || is_removed_by(time); }
	};

	/// Times that differ from a whole tick by less, in ticks, are rounded to it.
	static constexpr double SAME_TICK = 0.01;
	/// Rounding error of times, in ticks.
	static constexpr double SAME_TIME = 1e-6;

	[[nodiscard]] static int tick_in_window(double time, double begin, int ticks);
	/// Sets the latest pose. Returns false and changes nothing if it is not finite or out of range.
	bool set_latest(Body &body, const cga::Pose<double> &pose) const;
	bool observe(Body &body, double time);
	/// Puts a pending body at the end of those that receivers know.
	void include(size_t index);
	/// Removes a body. Receivers do the same: the last body takes its place.
	void erase(size_t index);
	/// Moves a body to another place in the list, whose body is dropped.
	void move_body(size_t from, size_t to);
	void find_gaps(double begin, int ticks);
	void encode_events(RangeEncoder &coder, size_t first_added, double begin, int ticks);
	void encode_bodies(RangeEncoder &coder, double begin, int ticks);
	void skip_motion(Body &body, double begin, int ticks);
	void encode_motion(RangeEncoder &coder, Body &body, double begin, int ticks);
	void encode_span(RangeEncoder &coder, Body &body, double begin, int ticks, size_t first, size_t count, size_t available);
	[[nodiscard]] bool is_changed(const Body &body, const cga::Pose<double> &pose) const;
	/// True if a body that was at rest has motion, or a rest correction, to be encoded up to `end`.
	[[nodiscard]] bool must_encode(const Body &body, double end) const;

	StreamGrid _grid;
	MotionPlanner _planner;
	MotionModels _models;
	MotionCode _motion;
	bool _previous_active = false; // the previous body in the list moves in this window
	std::vector<Body> _bodies; // those that receivers know, in their order, then those that a later window adds
	size_t _known = 0; // number of bodies that receivers know
	BodyBlocks _blocks; // of these
	std::unordered_map<uint32_t, size_t> _index; // into _bodies
	int _last_ticks = 0;
	int _last_coarseness = 0;
	size_t _moving = 0;
	uint32_t _check = 0;
	uint32_t _hash_sum = 0; // over the bodies that receivers know
	bool _changed = false;
};

} // namespace net
