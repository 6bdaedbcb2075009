#pragma once

#include "cga/motor/interpolate.hpp"
#include "cga/motor/pose.hpp"

#include <godot_cpp/variant/quaternion.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <string>

// Between the engine's types and those of src/cga. Poses are double here: the engine's floats go in and come out,
// nothing is rounded between.

namespace ga_godot {

cga::Vector3<double> to_glm(const godot::Vector3 &p_vector);
cga::Quaternion<double> to_glm(const godot::Quaternion &p_quaternion);

/// Beyond the range of float (extrapolation far out) the largest float, never infinity.
godot::Vector3 to_godot(const cga::Vector3<double> &p_vector);
godot::Quaternion to_godot(const cga::Quaternion<double> &p_quaternion);
godot::Transform3D to_godot(const cga::Pose<double> &p_pose);

/// A transform from 12 floats in the layout of a MultiMesh's 3D transforms.
godot::Transform3D transform_from_row(const float *p_row);

/// Text in UTF-8, as src/cga reads and writes it.
std::string to_utf8(const godot::String &p_text);
godot::String to_godot(const std::string &p_utf8);

bool is_finite(const godot::Vector3 &p_vector);
bool is_finite(const godot::Quaternion &p_quaternion);

/// The pose of a transform with uniform positive scale. Otherwise returns what is wrong and what to do, as the end of
/// a sentence about the transform, and leaves r_pose alone; null on success.
const char *pose_from_transform(const godot::Transform3D &p_transform, cga::Pose<double> &r_pose);

/// As above, but a transform that is scaled differently along its axes gives the nearest pose; r_is_uniform tells.
const char *nearest_pose_from_transform(const godot::Transform3D &p_transform, cga::Pose<double> &r_pose, bool &r_is_uniform);

/// Whether a script's number is one of MultivectorLerp's modes.
bool is_mode(int64_t p_mode);

} // namespace ga_godot
