#pragma once

#include "godot/net/target_selection.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

namespace ga_godot {

/// The group that all MotorSynchronizers are in.
inline constexpr const char *SYNCHRONIZER_GROUP = "_ga_godot_motor_synchronizers";

/// What is wrong with the set-up of a MotorSynchronizer, as far as the scene shows it: a sentence or two for each fault.
[[nodiscard]] godot::PackedStringArray find_setup_faults(const godot::Node &synchronizer, const TargetSelection &selection);

} // namespace ga_godot
