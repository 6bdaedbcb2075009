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
	bool add_body(std::uint32_t id, double time, const cga::Pose<double> &pose);
	bool remove_body(std::uint32_t id, double time);
	[[nodiscard]] bool has_body(std::uint32_t id) const { return index_.count(id) != 0; }
	[[nodiscard]] std::size_t body_count() const { return index_.size(); }
	/// False if there is no such body, or the pose is not finite or out of range.
	bool observe(std::uint32_t id, double time, const cga::Pose<double> &pose);
	/// The next pose is not interpolated to.
	bool jump(std::uint32_t id);

	/// True if a body's motion since the last window is not that of rest, or bodies came, went or jumped.
	[[nodiscard]] bool has_news() const { return news_; }
	/// Bodies that moved in the last window.
	[[nodiscard]] std::size_t moving_count() const { return moving_; }

	/// Appends the window (begin, begin + ticks], begin being the end of the last one, to `bytes`.
	void encode_window(double begin, int ticks, std::vector<std::uint8_t> &bytes);
	/// Eight bits that depend on all of the state.
	[[nodiscard]] std::uint8_t check() const { return check_bits(check_); }
	/// Appends everything a receiver needs to decode the next window: the models and all bodies.
	void encode_state(std::vector<std::uint8_t> &bytes);

	[[nodiscard]] const StreamGrid &grid() const { return grid_; }

private:
	struct Body {
		std::uint32_t id = 0;
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
	void encode_span(RangeEncoder &coder, Body &body, double begin, int ticks, std::size_t first, std::size_t count, std::size_t available, bool &neighbour_active);
	[[nodiscard]] bool is_news(const Body &body, const cga::Pose<double> &pose) const;

	StreamGrid grid_;
	MotionPlanner planner_;
	MotionModels models_;
	MotionCode motion_;
	std::vector<Body> bodies_;
	std::unordered_map<std::uint32_t, std::size_t> index_; // into bodies_
	int last_ticks_ = 0;
	std::size_t moving_ = 0;
	std::uint32_t check_ = 0;
	bool news_ = false;
};

} // namespace net
