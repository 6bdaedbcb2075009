#pragma once

#include "cga/motor/interpolate.hpp"
#include "net/stream/setting_range.hpp"

#include <cstddef>
#include <cstdint>

namespace net {

/// Settings of a stream of poses. The sender chooses them; snapshots carry them to receivers.
struct StreamSettings {
	/// Maximum distance between a body as shown and as it was, in meters: at its center, and on its axes at the lever arm,
	/// which StreamGrid derives from the two tolerances.
	double position_tolerance = 0.005;
	/// position_tolerance for planar bodies, in pixels. The pose of a planar body is given in meters, see planar_unit().
	double position_tolerance_2d = 0.5;
	/// Maximum angle between the rotation shown and the actual one, in degrees.
	double rotation_tolerance = 1.4;
	/// Playback delay of receivers, in seconds, without the delay of the network.
	double max_latency = 0.2;
	/// Maximum number of windows per second. Longer windows cost fewer bytes.
	double send_rate = 20.0;
	/// The base path of a segment, to which its curvature is added.
	cga::Mode mode = cga::Mode::SEPARATE;
	/// Length of a tick, in seconds. Windows and segments begin and end at whole ticks.
	double tick = 1.0 / 60.0;
	/// Maximum size of a packet in bytes, from MIN_PACKET_SIZE to MAX_PACKET_SIZE: what the transport sends as one datagram.
	size_t max_packet_size = 1100;

	static constexpr auto MIN_PACKET_SIZE = size_t(PACKET_SIZE_RANGE.min);
	static constexpr auto MAX_PACKET_SIZE = size_t(PACKET_SIZE_RANGE.max);
	/// What a session may take from each packet for its own headers.
	static constexpr size_t MAX_PACKET_OVERHEAD = 32;

	/// True if all settings are in their ranges (setting_range.hpp), as in each stream that receivers accept.
	[[nodiscard]] bool is_valid() const {
		return POSITION_TOLERANCE_RANGE.contains(position_tolerance) && POSITION_TOLERANCE_2D_RANGE.contains(position_tolerance_2d) && ROTATION_TOLERANCE_RANGE.contains(rotation_tolerance) && MAX_LATENCY_RANGE.contains(max_latency) && max_latency <= MAX_LATENCY_TICKS * tick && SEND_RATE_RANGE.contains(send_rate) && TICK_RANGE.contains(tick) && mode <= cga::Mode::SEPARATE && max_packet_size >= MIN_PACKET_SIZE - MAX_PACKET_OVERHEAD && max_packet_size <= MAX_PACKET_SIZE;
	}

	/// The length of a pixel in meters for planar bodies: both tolerances of the position are the same length. Sender and
	/// receivers compute the same value.
	[[nodiscard]] double planar_unit() const { return double(float(position_tolerance)) / double(float(position_tolerance_2d)); }

	/// True if a stream can continue when its settings change to `other`. Only send_rate and max_packet_size may differ.
	[[nodiscard]] bool is_same_stream(const StreamSettings &other) const {
		return position_tolerance == other.position_tolerance && position_tolerance_2d == other.position_tolerance_2d && rotation_tolerance == other.rotation_tolerance && max_latency == other.max_latency && mode == other.mode && tick == other.tick;
	}
};

/// Time until a receiver processes what has arrived: one frame at 60 Hz, in seconds.
inline constexpr double FRAME = 0.017;

} // namespace net
