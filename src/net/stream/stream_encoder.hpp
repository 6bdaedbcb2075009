#pragma once

#include "net/motion/motion_plan.hpp"
#include "net/stream/stream_header.hpp"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace net {

/// Turns the poses of many bodies into windows of motion, each coded against the window before it. Times in ticks.
class StreamEncoder {
public:
	StreamEncoder(float position_tolerance, float rotation_tolerance, cga::Mode mode);

	/// False if there is such a body, or the pose is not finite or out of range.
	bool add_body(uint32_t id, double time, const cga::Pose<double> &pose);
	bool remove_body(uint32_t id, double time);
	[[nodiscard]] bool has_body(uint32_t id) const { return _index.count(id) != 0; }
	[[nodiscard]] size_t body_count() const { return _index.size(); }
	/// False if there is no such body, or the pose is not finite or out of range.
	bool observe(uint32_t id, double time, const cga::Pose<double> &pose);
	/// The next pose is not interpolated to.
	bool jump(uint32_t id);

	/// True if a body's motion since the last window is not that of rest, or bodies came, went or jumped.
	[[nodiscard]] bool has_news() const { return _news; }
	/// Bodies that moved in the last window.
	[[nodiscard]] size_t moving_count() const { return _moving; }

	/// Appends the window (begin, begin + ticks], begin being the end of the last one, to `bytes`.
	void encode_window(double begin, int ticks, std::vector<uint8_t> &bytes);
	/// Eight bits that depend on all of the state.
	[[nodiscard]] uint8_t check() const { return check_bits(_check); }
	/// Appends everything a receiver needs to decode the next window: the models and all bodies.
	void encode_state(std::vector<uint8_t> &bytes);

	[[nodiscard]] const StreamGrid &grid() const { return _grid; }

private:
	struct Body {
		uint32_t id = 0;
		BodyState state;
		std::vector<MotionSample> samples; // since the last window
		bool added = false; // in this window, at `change_time`
		bool jump_next = false;
		bool jumped = false; // in this window, at `change_time`
		bool removed = false;
		double change_time = 0.0;
		double removal_time = 0.0;
		double seen_time = 0.0; // of the last pose that a window took in
	};

	void find_gaps(double begin, int ticks);
	void encode_changes(RangeEncoder &coder, double begin, int ticks);
	void encode_motion(RangeEncoder &coder, Body &body, double begin, int ticks, bool &neighbour_active);
	void encode_span(RangeEncoder &coder, Body &body, double begin, int ticks, size_t first, size_t count, size_t available, bool &neighbour_active);
	[[nodiscard]] bool is_news(const Body &body, const cga::Pose<double> &pose) const;

	StreamGrid _grid;
	MotionPlanner _planner;
	MotionModels _models;
	MotionCode _motion;
	std::vector<Body> _bodies;
	std::unordered_map<uint32_t, size_t> _index; // into _bodies
	int _last_ticks = 0;
	size_t _moving = 0;
	uint32_t _check = 0;
	bool _news = false;
};

} // namespace net
