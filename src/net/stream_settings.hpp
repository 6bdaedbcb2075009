#pragma once

#include "cga/motor/interpolate.hpp"

#include <cstdint>

namespace net {

/// What the sender of a stream of poses decides; receivers are told.
struct StreamSettings {
	/// Largest distance, in metres, between where a body is shown and where it was: at its centre, and at points on its
	/// axes as far out as `rotation_tolerance` makes it count as much.
	double position_tolerance = 0.005;
	/// Largest angle, in degrees, between the rotation shown and the true one.
	double rotation_tolerance = 1.4;
	/// How far behind the sender receivers show the motion at most, in seconds; network delay comes on top.
	double max_latency = 0.2;
	/// At most this many windows are sent a second. A longer window costs fewer bytes.
	double send_rate = 20.0;
	/// The base path between two samples; a curvature may be sent on top.
	cga::Mode mode = cga::Mode::SEPARATE;
	/// Length of a tick in seconds: windows begin and end, and motion bends, at whole ticks.
	double tick = 1.0 / 60.0;

	/// True if a stream of these settings goes on with the others. (The rate is the sender's own affair.)
	[[nodiscard]] bool is_same_stream(const StreamSettings &other) const {
		return position_tolerance == other.position_tolerance && rotation_tolerance == other.rotation_tolerance && max_latency == other.max_latency && mode == other.mode && tick == other.tick;
	}
};

/// What receivers take at most to look at what has arrived, in seconds: a frame.
inline constexpr double FRAME = 0.017;

/// Datagrams are never longer than this: larger ones would be split on the way, and losing a part loses all.
inline constexpr int MAX_PACKET_BYTES = 1350;

} // namespace net
