#pragma once

#include "net/motion/motion_code.hpp"
#include "net/stream/packet_error.hpp"
#include "net/stream/stream_header.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace net {

/// The inverse of StreamEncoder: decodes a snapshot, then the windows after it in order. Any bytes are safe input. If decoding
/// fails, nothing changes. Times in ticks.
class StreamDecoder {
public:
	StreamDecoder(float position_tolerance, float rotation_tolerance, size_t max_bodies) :
			_grid(position_tolerance, rotation_tolerance), _max_bodies(max_bodies) {}

	/// Reads the output of StreamEncoder::encode_snapshot.
	PacketResult read_snapshot(const uint8_t *bytes, size_t size);
	/// Number of bodies that the last snapshot declared, even if it was rejected with TOO_MANY_BODIES.
	[[nodiscard]] size_t declared_count() const { return _declared_count; }
	/// Decodes the next window, which begins at `begin`, and replaces `motions` with its segments, those of each body in order of
	/// time. Returns the window's length in ticks; std::nullopt if it cannot be decoded or its checksum differs.
	[[nodiscard]] std::optional<int> decode_window(const uint8_t *bytes, size_t size, WindowCheck check, double begin, cga::Mode mode, std::vector<BodyMotion> &motions);

	/// Appends the state after the last window, as StreamEncoder::encode_snapshot does.
	void encode_snapshot(std::vector<uint8_t> &bytes);
	/// Eight-bit checksum of the state after the last window.
	[[nodiscard]] uint8_t check() const { return check_bits(_check); }

	/// The bodies at the end of the last window.
	[[nodiscard]] size_t body_count() const { return _bodies.size(); }
	[[nodiscard]] uint32_t id(size_t index) const { return _bodies[index].id; }
	[[nodiscard]] cga::Pose<double> pose(size_t index) const { return _bodies[index].state.pose(_grid); }

private:
	enum class Event : uint8_t {
		NONE,
		APPEARS,
		JUMPS
	};

	static constexpr int NEVER = MAX_TICKS + 1;

	struct Body {
		uint32_t id = 0;
		BodyState state{};
		Event event = Event::NONE; // in this window
		int event_tick = 0; // from the window's begin
		int removal_tick = NEVER; // from the window's begin
		bool freed = false; // if removed
		BodyState target{}; // state after a jump
	};

	bool decode_events(RangeDecoder &coder, int ticks);
	bool decode_motion(RangeDecoder &coder, Body &body, double begin, int ticks, cga::Mode mode, std::vector<BodyMotion> &motions);
	bool decode_span(RangeDecoder &coder, Body &body, double begin, int ticks, cga::Mode mode, std::vector<BodyMotion> &motions);

	StreamGrid _grid;
	size_t _max_bodies;
	size_t _declared_count = 0;
	MotionModels _models;
	MotionModels _new_models;
	std::vector<Body> _bodies;
	std::vector<Body> _new_bodies; // working copy while a window is decoded
	MotionCode _motion;
	bool _previous_active = false; // the previous body in the list moves in this window
	int _last_ticks = 0;
	uint32_t _check = 0;
};

} // namespace net
