#include "godot/net/motor_synchronizer.hpp"

#include <godot_cpp/classes/performance.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/callable.hpp>

#include <algorithm>

// Figures for people: from scripts, and as monitors in the editor's debugger.

namespace ga_godot {

using godot::Array;
using godot::Callable;
using godot::Dictionary;
using godot::Performance;
using godot::String;
using godot::StringName;
using godot::Variant;
using godot::vformat;

static constexpr const char *MONITORED[] = { "bytes_per_second", "packets_per_second", "loss", "round_trip", "playback_delay", "late", "rejected" };

struct MotorSynchronizer::Figures {
	double sent_bytes = 0.0, sent_packets = 0.0, received_bytes = 0.0, received_packets = 0.0; // a second
	double loss = 0.0, round_trip = 0.0, playback_delay = 0.0; // the worst
	uint64_t late = 0, rejected = 0, foreign = 0;

	Dictionary to_dictionary() const {
		Dictionary result;
		result["bytes_per_second"] = sent_bytes + received_bytes;
		result["packets_per_second"] = sent_packets + received_packets;
		result["sent_bytes_per_second"] = sent_bytes;
		result["received_bytes_per_second"] = received_bytes;
		result["loss"] = loss;
		result["round_trip"] = round_trip;
		result["playback_delay"] = playback_delay;
		result["late"] = int64_t(late);
		result["rejected"] = int64_t(rejected);
		result["foreign"] = int64_t(foreign);
		return result;
	}
};

MotorSynchronizer::Figures MotorSynchronizer::figures_of(int32_t p_id, Peer &r_peer) {
	const double now = clock();
	Figures figures;
	figures.sent_bytes = r_peer.sent.get_bytes_per_second(now);
	figures.sent_packets = r_peer.sent.get_packets_per_second(now);
	figures.received_bytes = r_peer.received.get_bytes_per_second(now);
	figures.received_packets = r_peer.received.get_packets_per_second(now);
	if (r_peer.stream) {
		const net::StreamStatistics stream = r_peer.stream->statistics();
		figures.loss = stream.loss;
		figures.round_trip = stream.round_trip;
		figures.playback_delay = stream.playback_delay;
		figures.late = stream.late_windows;
	}
	if (r_peer.subscribed) {
		const net::ReceiverStatistics receiver = _sender->statistics(uint32_t(p_id));
		figures.loss = std::max(figures.loss, receiver.loss);
		figures.round_trip = std::max(figures.round_trip, receiver.round_trip);
	}
	figures.rejected = r_peer.rejected;
	figures.foreign = r_peer.foreign_bodies;
	return figures;
}

MotorSynchronizer::Figures MotorSynchronizer::total_figures() {
	Figures total;
	for (auto &[id, peer] : _peers) {
		const Figures figures = figures_of(id, peer);
		total.sent_bytes += figures.sent_bytes;
		total.sent_packets += figures.sent_packets;
		total.received_bytes += figures.received_bytes;
		total.received_packets += figures.received_packets;
		total.loss = std::max(total.loss, figures.loss);
		total.round_trip = std::max(total.round_trip, figures.round_trip);
		total.playback_delay = std::max(total.playback_delay, figures.playback_delay);
		total.late += figures.late;
		total.foreign += figures.foreign;
	}
	// Those of peers that have left stay in the sum.
	total.late += _late;
	total.rejected = _rejected;
	return total;
}

double MotorSynchronizer::get_media_time(int64_t p_peer) const {
	if (p_peer == _self) {
		return _sender ? _sender->media_time(media_time()) : 0.0;
	}
	const auto found = _peers.find(int32_t(p_peer));
	const bool is_shown = found != _peers.end() && found->second.stream && found->second.stream->is_ready();
	return is_shown ? found->second.stream->media_time() : 0.0;
}

Dictionary MotorSynchronizer::get_statistics() {
	Dictionary result = total_figures().to_dictionary();
	Dictionary peers;
	for (auto &[id, peer] : _peers) {
		peers[id] = figures_of(id, peer).to_dictionary();
	}
	result["peers"] = peers;
	return result;
}

void MotorSynchronizer::add_monitors() {
	Performance *performance = Performance::get_singleton();
	_monitors = vformat("ga_godot/%s/", get_name());
	for (int64_t number = 2; performance->has_custom_monitor(_monitors + String(MONITORED[0])); number++) {
		_monitors = vformat("ga_godot/%s %d/", get_name(), number);
	}
	for (const char *key : MONITORED) {
		performance->add_custom_monitor(_monitors + String(key), Callable(this, "_get_monitor"), Array{ StringName(key) });
	}
}

void MotorSynchronizer::remove_monitors() {
	Performance *performance = Performance::get_singleton();
	for (const char *key : MONITORED) {
		const String monitor = _monitors + String(key);
		if (performance->has_custom_monitor(monitor)) {
			performance->remove_custom_monitor(monitor);
		}
	}
	_monitors = String();
}

Variant MotorSynchronizer::_get_monitor(const StringName &p_key) {
	return total_figures().to_dictionary()[p_key];
}

} // namespace ga_godot
