#pragma once

#include "godot/thread_guard.hpp"
#include "net/pose_codec.hpp"

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <cstdint>
#include <vector>

namespace ga_godot {

/// Poses of many bodies in one packet, as quantized motors; doc_classes/MotorCodec.xml documents it.
class MotorCodec : public godot::RefCounted, public OneThread<MotorCodec> {
	GDCLASS(MotorCodec, godot::RefCounted)

public:
	void set_position_tolerance(double meters);
	double get_position_tolerance() const { return _tolerance.position; }
	void set_rotation_tolerance(double degrees);
	double get_rotation_tolerance() const { return _tolerance.rotation; }

	godot::PackedByteArray encode(const godot::PackedInt32Array &ids, const godot::TypedArray<godot::Transform3D> &transforms);
	godot::Dictionary decode(const godot::PackedByteArray &packet);

protected:
	static void _bind_methods();

private:
	net::Tolerance _tolerance;
	// Kept between calls, so that a steady stream of packets allocates only what it returns.
	std::vector<net::BodyPose> _bodies;
	std::vector<uint8_t> _packet;
};

} // namespace ga_godot
