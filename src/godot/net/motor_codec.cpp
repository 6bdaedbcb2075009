#include "godot/net/motor_codec.hpp"

#include "godot/algebra/conversions.hpp"
#include "godot/bind_property.hpp"
#include "godot/net/range_message.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace ga_godot {

using godot::Dictionary;
using godot::PackedByteArray;
using godot::PackedInt32Array;
using godot::Transform3D;
using godot::TypedArray;
using godot::vformat;

void MotorCodec::set_position_tolerance(double meters) {
	ERR_FAIL_COND_MSG(!net::POSITION_TOLERANCE_RANGE.contains(meters), range_message("MotorCodec", "position_tolerance", meters, net::POSITION_TOLERANCE_RANGE, "meters"));
	_tolerance.position = float(meters);
}

void MotorCodec::set_rotation_tolerance(double degrees) {
	ERR_FAIL_COND_MSG(!net::CODEC_ROTATION_TOLERANCE_RANGE.contains(degrees), range_message("MotorCodec", "rotation_tolerance", degrees, net::CODEC_ROTATION_TOLERANCE_RANGE, "degrees"));
	_tolerance.rotation = float(degrees);
}

PackedByteArray MotorCodec::encode(const PackedInt32Array &ids, const TypedArray<Transform3D> &transforms) {
	const int64_t count = ids.size();
	ERR_FAIL_COND_V_MSG(transforms.size() != count, PackedByteArray(), vformat("MotorCodec.encode: %d ids but %d transforms; give one transform for each id.", count, transforms.size()));
	_bodies.resize(size_t(count));
	for (int64_t i = 0; i < count; i++) {
		const int32_t id = ids[i];
		ERR_FAIL_COND_V_MSG(id < 0, PackedByteArray(), vformat("MotorCodec.encode: id %d at index %d is negative.", id, i));
		const PoseResult pose = pose_from_transform(transforms[i]);
		ERR_FAIL_COND_V_MSG(!pose, PackedByteArray(), vformat("MotorCodec.encode: the transform at index %d (id %d) %s.", i, id, cga::describe(pose.error())));
		_bodies[size_t(i)] = { uint32_t(id), cga::pose_cast<float>(*pose) };
	}
	const net::CodecResult encoded = net::encode(_bodies.data(), _bodies.size(), _tolerance, _packet);
	ERR_FAIL_COND_V_MSG(!encoded, PackedByteArray(), vformat("MotorCodec.encode: %s (index %d).", net::describe(encoded.error().fault), int64_t(encoded.error().index)));
	return to_packed(_packet.data(), _packet.size());
}

Dictionary MotorCodec::decode(const PackedByteArray &packet) {
	Dictionary result;
	const net::CodecResult decoded = net::decode(packet.size() > 0 ? packet.ptr() : nullptr, size_t(packet.size()), _bodies);
	if (!decoded) {
		result["error"] = vformat("%s (body %d)", net::describe(decoded.error().fault), int64_t(decoded.error().index));
		return result;
	}
	PackedInt32Array ids;
	ids.resize(int64_t(_bodies.size()));
	TypedArray<Transform3D> transforms;
	transforms.resize(int64_t(_bodies.size()));
	for (size_t i = 0; i < _bodies.size(); i++) {
		ids.set(int64_t(i), int32_t(_bodies[i].id));
		transforms[int64_t(i)] = to_godot(cga::pose_cast<double>(_bodies[i].pose));
	}
	result["ids"] = ids;
	result["transforms"] = transforms;
	return result;
}

void MotorCodec::_bind_methods() {
	using godot::ClassDB;
	using godot::D_METHOD;
	using godot::PropertyInfo;
	using godot::Variant;

	bind_property("meters", guarded<&MotorCodec::set_position_tolerance>(), guarded<&MotorCodec::get_position_tolerance>(), PropertyInfo(Variant::FLOAT, "position_tolerance", godot::PROPERTY_HINT_RANGE, "0.0001,0.1,0.0001,or_greater,suffix:m"));
	bind_property("degrees", guarded<&MotorCodec::set_rotation_tolerance>(), guarded<&MotorCodec::get_rotation_tolerance>(), PropertyInfo(Variant::FLOAT, "rotation_tolerance", godot::PROPERTY_HINT_RANGE, "0.01,5,0.01,or_greater,suffix:°"));
	ClassDB::bind_method(D_METHOD("encode", "ids", "transforms"), guarded<&MotorCodec::encode>());
	ClassDB::bind_method(D_METHOD("decode", "packet"), guarded<&MotorCodec::decode>());
}

} // namespace ga_godot
