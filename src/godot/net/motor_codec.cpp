#include "godot/net/motor_codec.hpp"

#include "godot/algebra/conversions.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>
#include <cstring>

namespace ga_godot {

using godot::Array;
using godot::Dictionary;
using godot::PackedByteArray;
using godot::PackedInt32Array;
using godot::String;
using godot::Transform3D;
using godot::TypedArray;
using godot::vformat;

void MotorCodec::set_position_tolerance(double p_metres) {
	ERR_FAIL_COND_MSG(!std::isfinite(p_metres) || !(p_metres > 0.0), vformat("MotorCodec: position_tolerance is in metres and positive, not %f.", p_metres));
	_tolerance.position = float(p_metres);
}

double MotorCodec::get_position_tolerance() const {
	return _tolerance.position;
}

void MotorCodec::set_rotation_tolerance(double p_degrees) {
	ERR_FAIL_COND_MSG(!std::isfinite(p_degrees) || !(float(p_degrees) >= net::MIN_ROTATION_TOLERANCE), vformat("MotorCodec: rotation_tolerance is in degrees and at least %f, not %f.", net::MIN_ROTATION_TOLERANCE, p_degrees));
	_tolerance.rotation = float(p_degrees);
}

double MotorCodec::get_rotation_tolerance() const {
	return _tolerance.rotation;
}

PackedByteArray MotorCodec::encode(const PackedInt32Array &p_ids, const TypedArray<Transform3D> &p_transforms) {
	const int64_t count = p_ids.size();
	ERR_FAIL_COND_V_MSG(p_transforms.size() != count, PackedByteArray(), vformat("MotorCodec.encode: %d ids but %d transforms; give one transform for each id.", count, p_transforms.size()));
	_bodies.resize(size_t(count));
	for (int64_t i = 0; i < count; i++) {
		const int32_t id = p_ids[i];
		ERR_FAIL_COND_V_MSG(id < 0, PackedByteArray(), vformat("MotorCodec.encode: id %d at index %d is negative.", id, i));
		cga::Pose<double> pose;
		const char *fault = pose_from_transform(p_transforms[i], pose);
		ERR_FAIL_COND_V_MSG(fault != nullptr, PackedByteArray(), vformat("MotorCodec.encode: the transform at index %d (id %d) %s.", i, id, fault));
		_bodies[size_t(i)] = { uint32_t(id), cga::pose_cast<float>(pose) };
	}
	const net::CodecStatus status = net::encode(_bodies.data(), _bodies.size(), _tolerance, _packet);
	ERR_FAIL_COND_V_MSG(status.error != nullptr, PackedByteArray(), vformat("MotorCodec.encode: %s (index %d).", status.error, int64_t(status.index)));
	PackedByteArray packet;
	packet.resize(int64_t(_packet.size()));
	if (!_packet.empty()) {
		std::memcpy(packet.ptrw(), _packet.data(), _packet.size());
	}
	return packet;
}

Dictionary MotorCodec::decode(const PackedByteArray &p_packet) {
	Dictionary result;
	const net::CodecStatus status = net::decode(p_packet.size() > 0 ? p_packet.ptr() : nullptr, size_t(p_packet.size()), _bodies);
	if (status.error != nullptr) {
		result["error"] = vformat("%s (body %d)", status.error, int64_t(status.index));
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

	ClassDB::bind_method(D_METHOD("set_position_tolerance", "metres"), &MotorCodec::set_position_tolerance);
	ClassDB::bind_method(D_METHOD("get_position_tolerance"), &MotorCodec::get_position_tolerance);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "position_tolerance", godot::PROPERTY_HINT_RANGE, "0.0001,0.1,0.0001,or_greater,suffix:m"), "set_position_tolerance", "get_position_tolerance");
	ClassDB::bind_method(D_METHOD("set_rotation_tolerance", "degrees"), &MotorCodec::set_rotation_tolerance);
	ClassDB::bind_method(D_METHOD("get_rotation_tolerance"), &MotorCodec::get_rotation_tolerance);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "rotation_tolerance", godot::PROPERTY_HINT_RANGE, "0.01,5,0.01,or_greater,suffix:°"), "set_rotation_tolerance", "get_rotation_tolerance");
	ClassDB::bind_method(D_METHOD("encode", "ids", "transforms"), &MotorCodec::encode);
	ClassDB::bind_method(D_METHOD("decode", "packet"), &MotorCodec::decode);
}

} // namespace ga_godot
