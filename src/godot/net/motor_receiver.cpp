#include "godot/net/motor_receiver.hpp"

#include "godot/algebra/conversions.hpp"
#include "godot/net/packet_reason.hpp"
#include "net/pose_codec.hpp"

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace ga_godot {

using godot::Dictionary;
using godot::PackedByteArray;
using godot::PackedInt32Array;
using godot::Ref;
using godot::String;
using godot::Transform3D;
using godot::vformat;

MotorReceiver::MotorReceiver() {
	clear();
}

void MotorReceiver::clear() {
	_receiver = net::Receiver(size_t(_max_bodies));
	_events.clear();
	_next_event = 0;
	limits_changed();
}

void MotorReceiver::set_max_bodies(int64_t count) {
	ERR_FAIL_COND_MSG(!net::MAX_BODIES_RANGE.contains(double(count)), range_message("MotorReceiver", "max_bodies", double(count), net::MAX_BODIES_RANGE, "bodies"));
	ERR_FAIL_COND_MSG(_receiver.statistics().packets_received > 0, "MotorReceiver: set max_bodies before the first packet, or call clear() first.");
	_max_bodies = count;
	clear();
}

String MotorReceiver::accept(const PackedByteArray &packet, double now) {
	ERR_FAIL_COND_V_MSG(!net::is_valid_time(now), "the time is out of range", time_message("MotorReceiver.accept", now));
	const net::PacketResult result = _receiver.accept(packet.ptr(), size_t(packet.size()), now);
	return result ? String() : packet_reason(result.error(), _receiver.other_version());
}

PackedByteArray MotorReceiver::take_ack(double now) {
	ERR_FAIL_COND_V_MSG(!net::is_valid_time(now), PackedByteArray(), time_message("MotorReceiver.take_ack", now));
	_receiver.take_ack(_ack, now);
	return to_packed(_ack.data(), _ack.size());
}

void MotorReceiver::advance(double now) {
	ERR_FAIL_COND_MSG(!net::is_valid_time(now), time_message("MotorReceiver.advance", now));
	_receiver.advance(now);
	_receiver.take_events(_taken);
	_events.insert(_events.end(), _taken.begin(), _taken.end());
	if (_is_emitting) {
		return; // A handler of a signal calls this method. The call that emits it emits these events too, in their order.
	}
	const Ref<MotorReceiver> self(this); // A handler may release the last reference.
	_is_emitting = true;
	while (_next_event < _events.size()) {
		const net::BodyEvent event = _events[_next_event++];
		emit_signal(event.kind == net::BodyEvent::ADDED ? "body_added" : "body_removed", int64_t(event.id));
	}
	_is_emitting = false;
	_events.clear();
	_next_event = 0;
}

std::optional<cga::Pose<double>> MotorReceiver::find_pose(int64_t id) const {
	return id >= 0 && id < int64_t(net::ID_LIMIT) ? _receiver.pose(uint32_t(id)) : std::nullopt;
}

Transform3D MotorReceiver::get_transform(int64_t id) const {
	const auto pose = find_pose(id);
	ERR_FAIL_COND_V_MSG(!pose, Transform3D(), vformat("MotorReceiver.get_transform: body %d does not exist at the media time shown. Check has_body() first, or follow the signals.", id));
	return to_godot(*pose);
}

PackedInt32Array MotorReceiver::get_bodies() const {
	const std::vector<uint32_t> ids = _receiver.bodies();
	PackedInt32Array result;
	result.resize(int64_t(ids.size()));
	for (size_t i = 0; i < ids.size(); i++) {
		result.set(int64_t(i), int32_t(ids[i]));
	}
	return result;
}

void MotorReceiver::limits_changed() {
	_receiver.set_margin_limits(get_min_delay(), get_jitter_allowance());
}

Dictionary MotorReceiver::get_statistics() const {
	const net::StreamStatistics statistics = _receiver.statistics();
	Dictionary result;
	result["bytes_received"] = int64_t(statistics.bytes_received);
	result["packets_received"] = int64_t(statistics.packets_received);
	result["packets_rejected"] = int64_t(statistics.packets_rejected);
	result["late"] = int64_t(statistics.late_windows);
	result["playback_delay"] = statistics.playback_delay;
	result["jitter"] = statistics.jitter;
	result["round_trip"] = statistics.round_trip;
	result["loss"] = statistics.loss;
	return result;
}

void MotorReceiver::_bind_methods() {
	using godot::ClassDB;
	using godot::D_METHOD;
	using godot::MethodInfo;
	using godot::PropertyInfo;
	using godot::Variant;

	bind_property("count", guarded<&MotorReceiver::set_max_bodies>(), guarded<&MotorReceiver::get_max_bodies>(), PropertyInfo(Variant::INT, "max_bodies", godot::PROPERTY_HINT_RANGE, "1,65536,1,or_greater"));
	bind_playback_properties();
	ClassDB::bind_method(D_METHOD("accept", "packet", "now"), guarded<&MotorReceiver::accept, IN_USE>());
	ClassDB::bind_method(D_METHOD("take_ack", "now"), guarded<&MotorReceiver::take_ack>());
	ClassDB::bind_method(D_METHOD("is_ready"), guarded<&MotorReceiver::is_ready>());
	ClassDB::bind_method(D_METHOD("advance", "now"), guarded<&MotorReceiver::advance>());
	ClassDB::bind_method(D_METHOD("get_transform", "id"), guarded<&MotorReceiver::get_transform>());
	ClassDB::bind_method(D_METHOD("has_body", "id"), guarded<&MotorReceiver::has_body>());
	ClassDB::bind_method(D_METHOD("get_bodies"), guarded<&MotorReceiver::get_bodies>());
	ClassDB::bind_method(D_METHOD("get_media_time"), guarded<&MotorReceiver::get_media_time>());
	ClassDB::bind_method(D_METHOD("get_known_time"), guarded<&MotorReceiver::get_known_time>());
	ClassDB::bind_method(D_METHOD("clear"), guarded<&MotorReceiver::clear>());
	ClassDB::bind_method(D_METHOD("get_statistics"), guarded<&MotorReceiver::get_statistics>());
	ADD_SIGNAL(MethodInfo("body_added", PropertyInfo(Variant::INT, "id")));
	ADD_SIGNAL(MethodInfo("body_removed", PropertyInfo(Variant::INT, "id")));
}

} // namespace ga_godot
