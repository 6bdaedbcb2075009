#pragma once

#include "cga/motor/interpolate.hpp"
#include "cga/motor/matrix_pose.hpp"
#include "cga/motor/pose.hpp"

#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/quaternion.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

// Conversions between the engine's types and those of src/cga, which compute in double precision.

namespace ga_godot {

cga::Vector3<double> to_glm(const godot::Vector3 &vector);
cga::Quaternion<double> to_glm(const godot::Quaternion &quaternion);

/// Values beyond the range of float, which far extrapolation can produce, are clamped to the largest finite float.
godot::Vector3 to_godot(const cga::Vector3<double> &vector);
godot::Quaternion to_godot(const cga::Quaternion<double> &quaternion);
godot::Transform3D to_godot(const cga::Pose<double> &pose);

/// The transform in 12 floats, in the layout of MultiMesh.buffer.
godot::Transform3D transform_from_row(const float *row);

/// src/cga and src/playground read and write UTF-8.
std::string to_utf8(const godot::String &text);
godot::String to_godot(const std::string &text);

godot::PackedByteArray to_packed(const uint8_t *bytes, size_t size);

bool is_finite(const godot::Vector3 &vector);
bool is_finite(const godot::Quaternion &quaternion);

using PoseResult = cga::Result<cga::Pose<double>, cga::MatrixError>;

/// The pose of a transform with a uniform, positive scale.
PoseResult pose_from_transform(const godot::Transform3D &transform);
/// The nearest pose to a transform, whose scale may be non-uniform.
PoseResult nearest_pose_from_transform(const godot::Transform3D &transform);

/// Whether a number passed by a script is a value of cga::Mode.
bool is_mode(int64_t mode);

} // namespace ga_godot
