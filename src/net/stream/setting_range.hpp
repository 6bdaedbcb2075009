#pragma once

namespace net {

/// The values of a setting that senders and receivers accept, inclusive.
struct SettingRange {
	double min;
	double max;

	/// False for NaN.
	[[nodiscard]] constexpr bool contains(double value) const { return value >= min && value <= max; }
	/// The same for a setting that was rounded to float32, as in a packet: true for each rounded value in the range.
	[[nodiscard]] constexpr bool contains(float value) const { return value >= float(min) && value <= float(max); }
};

// This table is the only one: properties, packets and the documentation of the settings follow it.
inline constexpr SettingRange POSITION_TOLERANCE_RANGE{ 1e-6, 1e6 }; ///< meters
inline constexpr SettingRange POSITION_TOLERANCE_2D_RANGE{ 1e-6, 1e6 }; ///< pixels
inline constexpr SettingRange ROTATION_TOLERANCE_RANGE{ 0.01, 30.0 }; ///< degrees
inline constexpr SettingRange MAX_LATENCY_RANGE{ 0.001, 10.0 }; ///< seconds
/// A receiver keeps so many ticks of motion: max_latency is at most this many ticks.
inline constexpr double MAX_LATENCY_TICKS = 2048.0;
inline constexpr SettingRange SEND_RATE_RANGE{ 0.01, 10000.0 }; ///< windows per second
inline constexpr SettingRange TICK_RANGE{ 1e-4, 1.0 }; ///< seconds
inline constexpr SettingRange TICK_RATE_RANGE{ 1.0, 10000.0 }; ///< 1 / TICK_RANGE, in hertz
inline constexpr SettingRange PACKET_SIZE_RANGE{ 256.0, 65000.0 }; ///< bytes
inline constexpr SettingRange PRIORITY_RANGE{ 0.0, 8.0 }; ///< of a body, in octaves of its error, see StreamEncoder::set_priority
inline constexpr SettingRange DELAY_RANGE{ 0.0, 10.0 }; ///< seconds; limits of a receiver's playback delay, and the blend time
inline constexpr SettingRange MAX_BODIES_RANGE{ 1.0, 16777215.0 }; ///< a snapshot has 24 bits for their number
/// Of MotorCodec. The minimum is 2 sqrt(6) / (2^24 - 2) radians: below it, float32 is too coarse.
inline constexpr SettingRange CODEC_ROTATION_TOLERANCE_RANGE{ 1.7e-5, 180.0 }; ///< degrees

} // namespace net
