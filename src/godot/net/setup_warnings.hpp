#pragma once

#include "godot/net/target_selection.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string.hpp>

namespace ga_godot {

class MotorSynchronizer;

/// The group of all MotorSynchronizers in the tree.
inline constexpr const char *SYNCHRONIZER_GROUP = "_ga_godot_motor_synchronizers";

/// Configuration warnings for a MotorSynchronizer, found by inspecting its scene; one or two sentences each.
[[nodiscard]] godot::PackedStringArray find_setup_faults(const MotorSynchronizer &synchronizer, const TargetSelection &selection);

// The warnings of these are printed at run time, too.

[[nodiscard]] godot::String automatic_name_fault(const godot::Node &node);
/// Empty if the send rate, in hertz, is not above the rate of physics ticks.
[[nodiscard]] godot::String send_rate_fault(double send_rate);
/// Describes why the engine's tick rate does not fit a max_latency, or returns an empty string.
[[nodiscard]] godot::String tick_rate_fault(double max_latency);
/// Empty if the main thread processes the node.
[[nodiscard]] godot::String thread_fault(const godot::Node &node);
/// Empty if the node and its parent are not one a Node2D and the other a Node3D.
[[nodiscard]] godot::String dimension_fault(const godot::Node &node);

} // namespace ga_godot
