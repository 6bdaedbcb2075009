#pragma once

#include "godot/net/target_selection.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

namespace ga_godot {

/// The group of all MotorSynchronizers in the tree.
inline constexpr const char *SYNCHRONIZER_GROUP = "_ga_godot_motor_synchronizers";

/// Configuration warnings for a MotorSynchronizer, found by inspecting its scene; one or two sentences each.
[[nodiscard]] godot::PackedStringArray find_setup_faults(const godot::Node &synchronizer, const TargetSelection &selection);

} // namespace ga_godot
