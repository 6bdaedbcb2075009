#include "godot/net/motor_receiver.hpp"

#include "godot/algebra/conversions.hpp"
#include "net/pose_codec.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>
#include <cstring>

namespace ga_godot {

using godot::Dictionary;
using godot::PackedByteArray;
using godot::PackedInt32Array;
using godot::String;
using godot::Transform3D;
using godot::vformat;

MotorReceiver::MotorReceiver() {
	clear();
}

void MotorReceiver::clear() {
	_receiver = std::make_unique<net::Receiver>(size_t(_max_bodies));
	limits_changed();
}

void MotorReceiver::set_most_bodies(int64_t p_count) {
	ERR_FAIL_COND_MSG(p_count < 1, vformat("MotorReceiver: most_bodies is at least 1, not %d.", p_count));
	ERR_FAIL_COND_MSG(_receiver->statistics().packets_received > 0, "MotorReceiver: set most_bodies before the first packet, or call clear() first.");
	_max_bodies = p_count;
	clear();
}

int64_t MotorReceiver::get_most_bodies() const {
	return _max_bodies;
}

String MotorReceiver::accept(const PackedByteArray &p_packet, double p_now) {
	ERR_FAIL_COND_V_MSG(!std::isfinite(p_now), "the time is not finite", "MotorReceiver.accept: the time is not finite.");
	const char *fault = _receiver->accept(p_packet.ptr(), size_t(p_packet.size()), p_now);
	return fault != nullptr ? String(fault) : String();
}

PackedByteArray MotorReceiver::take_ack(double p_now) {
	PackedByteArray answer;
	ERR_FAIL_COND_V_MSG(!std::isfinite(p_now), answer, "MotorReceiver.take_answer: the time is not finite.");
	if (_receiver->take_ack(_answer, p_now) && !_answer.empty()) {
		answer.resize(int64_t(_answer.size()));
		std::memcpy(answer.ptrw(), _answer.data(), _answer.size());
	}
	return answer;
}

bool MotorReceiver::is_ready() const {
	return _receiver->is_ready();
}

void MotorReceiver::advance(double p_now) {
	ERR_FAIL_COND_MSG(!std::isfinite(p_now), "MotorReceiver.advance: the time is not finite.");
	_receiver->advance(p_now);
	_receiver->take_events(_events);
	for (const net::BodyEvent &event : _events) {
		emit_signal(event.kind == net::BodyEvent::ADDED ? "body_added" : "body_removed", int64_t(event.id));
	}
}

Transform3D MotorReceiver::get_transform(int64_t p_id) const {
	cga::Pose<double> pose;
	const bool found = p_id >= 0 && p_id < int64_t(net::ID_LIMIT) && _receiver->pose(uint32_t(p_id), pose);
	ERR_FAIL_COND_V_MSG(!found, Transform3D(), vformat("MotorReceiver.get_transform: there is no body with id %d; has_body() and the signals tell which there are.", p_id));
	return to_godot(pose);
}

bool MotorReceiver::has_body(int64_t p_id) const {
	cga::Pose<double> pose;
	return p_id >= 0 && p_id < int64_t(net::ID_LIMIT) && _receiver->pose(uint32_t(p_id), pose);
}

PackedInt32Array MotorReceiver::get_bodies() const {
	std::vector<uint32_t> ids;
	_receiver->bodies(ids);
	PackedInt32Array result;
	result.resize(int64_t(ids.size()));
	for (size_t i = 0; i < ids.size(); i++) {
		result.set(int64_t(i), int32_t(ids[i]));
	}
	return result;
}

double MotorReceiver::get_media_time() const {
	return _receiver->is_ready() ? _receiver->media_time() : 0.0;
}

double MotorReceiver::get_known_time() const {
	return _receiver->is_ready() ? _receiver->known_time() : 0.0;
}

void MotorReceiver::limits_changed() {
	limit(*_receiver);
}

Dictionary MotorReceiver::get_statistics() const {
	const net::StreamStatistics statistics = _receiver->statistics();
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

	ClassDB::bind_method(D_METHOD("set_most_bodies", "count"), &MotorReceiver::set_most_bodies);
	ClassDB::bind_method(D_METHOD("get_most_bodies"), &MotorReceiver::get_most_bodies);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "most_bodies", godot::PROPERTY_HINT_RANGE, "1,65536,1,or_greater"), "set_most_bodies", "get_most_bodies");
	bind_playback_properties();
	ClassDB::bind_method(D_METHOD("accept", "packet", "now"), &MotorReceiver::accept);
	ClassDB::bind_method(D_METHOD("take_answer", "now"), &MotorReceiver::take_ack);
	ClassDB::bind_method(D_METHOD("is_ready"), &MotorReceiver::is_ready);
	ClassDB::bind_method(D_METHOD("advance", "now"), &MotorReceiver::advance);
	ClassDB::bind_method(D_METHOD("get_transform", "id"), &MotorReceiver::get_transform);
	ClassDB::bind_method(D_METHOD("has_body", "id"), &MotorReceiver::has_body);
	ClassDB::bind_method(D_METHOD("get_bodies"), &MotorReceiver::get_bodies);
	ClassDB::bind_method(D_METHOD("get_media_time"), &MotorReceiver::get_media_time);
	ClassDB::bind_method(D_METHOD("get_known_time"), &MotorReceiver::get_known_time);
	ClassDB::bind_method(D_METHOD("clear"), &MotorReceiver::clear);
	ClassDB::bind_method(D_METHOD("get_statistics"), &MotorReceiver::get_statistics);
	ADD_SIGNAL(MethodInfo("body_added", PropertyInfo(Variant::INT, "id")));
	ADD_SIGNAL(MethodInfo("body_removed", PropertyInfo(Variant::INT, "id")));
}

} // namespace ga_godot
