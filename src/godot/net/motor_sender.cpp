#include "godot/net/motor_sender.hpp"

#include "net/pose_codec.hpp"

namespace ga_godot {

using godot::Dictionary;
using godot::PackedByteArray;
using godot::String;
using godot::Transform3D;
using godot::TypedArray;
using godot::vformat;

static constexpr int64_t RECEIVER_LIMIT = int64_t(1) << 32;

static bool is_body(int64_t id) {
	return id >= 0 && id < int64_t(net::ID_LIMIT);
}

static bool is_receiver(int64_t receiver) {
	return receiver >= 0 && receiver < RECEIVER_LIMIT;
}

void MotorSender::set_ticks_per_second(double hertz) {
	ERR_FAIL_COND_MSG(!net::TICK_RATE_RANGE.contains(hertz), range_message("MotorSender", "ticks_per_second", hertz, net::TICK_RATE_RANGE, "Hz"));
	set_number(&net::StreamSettings::tick, 1.0 / hertz, net::TICK_RANGE, "the length of a tick", "seconds");
}

bool MotorSender::add_body(int64_t id, const Transform3D &transform) {
	ERR_FAIL_COND_V_MSG(!is_body(id), false, vformat("MotorSender.add_body: id is %d, but must be 0 to 2147483647.", id));
	ERR_FAIL_COND_V_MSG(_sender.has_body(uint32_t(id)), false, vformat("MotorSender.add_body: body %d exists already.", id));
	const PoseResult pose = pose_from_transform(transform);
	ERR_FAIL_COND_V_MSG(!pose, false, vformat("MotorSender.add_body: the transform of body %d %s.", id, cga::describe(pose.error())));
	ERR_FAIL_COND_V_MSG(!_sender.add_body(uint32_t(id), *pose), false, vformat("MotorSender.add_body: the transform of body %d is out of range: too far from the origin, or its scale is too small or too large.", id));
	return true;
}

bool MotorSender::remove_body(int64_t id) {
	return is_body(id) && _sender.remove_body(uint32_t(id));
}

bool MotorSender::has_body(int64_t id) const {
	return is_body(id) && _sender.has_body(uint32_t(id));
}

bool MotorSender::observe(int64_t id, double time, const Transform3D &transform) {
	ERR_FAIL_COND_V_MSG(!has_body(id), false, vformat("MotorSender.observe: body %d does not exist; call add_body() first.", id));
	ERR_FAIL_COND_V_MSG(!net::is_valid_time(time), false, time_message("MotorSender.observe", time));
	const PoseResult pose = pose_from_transform(transform);
	ERR_FAIL_COND_V_MSG(!pose, false, vformat("MotorSender.observe: the transform of body %d %s.", id, cga::describe(pose.error())));
	ERR_FAIL_COND_V_MSG(!_sender.observe(uint32_t(id), time, *pose), false, vformat("MotorSender.observe: the transform of body %d at %f s is out of range: too far from the origin, or its scale is too small or too large.", id, time));
	return true;
}

bool MotorSender::teleport(int64_t id) {
	ERR_FAIL_COND_V_MSG(!has_body(id), false, vformat("MotorSender.teleport: body %d does not exist.", id));
	return _sender.teleport(uint32_t(id));
}

bool MotorSender::set_priority(int64_t id, int64_t priority) {
	ERR_FAIL_COND_V_MSG(!has_body(id), false, vformat("MotorSender.set_priority: body %d does not exist.", id));
	ERR_FAIL_COND_V_MSG(!net::PRIORITY_RANGE.contains(double(priority)), false, vformat("MotorSender.set_priority: the priority is %d, but must be 0 to 8.", priority));
	return _sender.set_priority(uint32_t(id), int(priority));
}

void MotorSender::add_receiver(int64_t receiver, double time) {
	ERR_FAIL_COND_MSG(!is_receiver(receiver), vformat("MotorSender.add_receiver: the receiver is %d, but must be 0 to 4294967295.", receiver));
	ERR_FAIL_COND_MSG(!net::is_valid_time(time), time_message("MotorSender.add_receiver", time));
	_sender.add_receiver(uint32_t(receiver), time);
}

void MotorSender::remove_receiver(int64_t receiver) {
	if (is_receiver(receiver)) {
		_sender.remove_receiver(uint32_t(receiver));
	}
}

bool MotorSender::has_receiver(int64_t receiver) const {
	return is_receiver(receiver) && _sender.has_receiver(uint32_t(receiver));
}

TypedArray<Dictionary> MotorSender::flush(double time) {
	TypedArray<Dictionary> packets;
	ERR_FAIL_COND_V_MSG(!net::is_valid_time(time), packets, time_message("MotorSender.flush", time));
	_sender.flush(time);
	for (const net::OutgoingPacket &outgoing : _sender.packets()) {
		Dictionary packet;
		packet["receiver"] = int64_t(outgoing.receiver);
		packet["bytes"] = to_packed(_sender.bytes() + outgoing.begin, outgoing.size);
		packets.push_back(packet);
	}
	return packets;
}

String MotorSender::accept(int64_t receiver, const PackedByteArray &packet, double time) {
	ERR_FAIL_COND_V_MSG(!net::is_valid_time(time), "the time is out of range", time_message("MotorSender.accept", time));
	if (!has_receiver(receiver)) {
		return net::describe(net::PacketError::UNKNOWN_RECEIVER);
	}
	const net::PacketResult result = _sender.accept(uint32_t(receiver), packet.ptr(), size_t(packet.size()), time, false);
	return result ? String() : String(net::describe(result.error()));
}

Dictionary MotorSender::get_statistics(int64_t receiver) const {
	ERR_FAIL_COND_V_MSG(!has_receiver(receiver), Dictionary(), vformat("MotorSender.get_statistics: receiver %d does not exist.", receiver));
	const net::ReceiverStatistics statistics = _sender.statistics(uint32_t(receiver));
	Dictionary result;
	result["bytes_sent"] = int64_t(statistics.bytes_sent);
	result["packets_sent"] = int64_t(statistics.packets_sent);
	result["chunks_repeated"] = int64_t(statistics.chunks_repeated);
	result["loss"] = statistics.loss;
	result["round_trip"] = statistics.round_trip;
	result["line_rate"] = statistics.line_rate;
	result["relaxation"] = statistics.relaxation;
	return result;
}

void MotorSender::_bind_methods() {
	using godot::ClassDB;
	using godot::D_METHOD;

	bind_stream_properties();
	bind_property("hertz", guarded<&MotorSender::set_ticks_per_second>(), guarded<&MotorSender::get_ticks_per_second>(), godot::PropertyInfo(godot::Variant::FLOAT, "ticks_per_second", godot::PROPERTY_HINT_RANGE, "1,240,1,or_greater,suffix:Hz"));
	ClassDB::bind_method(D_METHOD("add_body", "id", "transform"), guarded<&MotorSender::add_body>());
	ClassDB::bind_method(D_METHOD("remove_body", "id"), guarded<&MotorSender::remove_body>());
	ClassDB::bind_method(D_METHOD("has_body", "id"), guarded<&MotorSender::has_body>());
	ClassDB::bind_method(D_METHOD("get_body_count"), guarded<&MotorSender::get_body_count>());
	ClassDB::bind_method(D_METHOD("observe", "id", "time", "transform"), guarded<&MotorSender::observe>());
	ClassDB::bind_method(D_METHOD("teleport", "id"), guarded<&MotorSender::teleport>());
	ClassDB::bind_method(D_METHOD("set_priority", "id", "priority"), guarded<&MotorSender::set_priority>());
	ClassDB::bind_method(D_METHOD("add_receiver", "receiver", "time"), guarded<&MotorSender::add_receiver>());
	ClassDB::bind_method(D_METHOD("remove_receiver", "receiver"), guarded<&MotorSender::remove_receiver>());
	ClassDB::bind_method(D_METHOD("has_receiver", "receiver"), guarded<&MotorSender::has_receiver>());
	ClassDB::bind_method(D_METHOD("flush", "time"), guarded<&MotorSender::flush>());
	ClassDB::bind_method(D_METHOD("accept", "receiver", "packet", "time"), guarded<&MotorSender::accept, IN_USE>());
	ClassDB::bind_method(D_METHOD("get_statistics", "receiver"), guarded<&MotorSender::get_statistics>());
	ClassDB::bind_method(D_METHOD("get_moving_count"), guarded<&MotorSender::get_moving_count>());
}

} // namespace ga_godot
