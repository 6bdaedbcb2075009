#include "godot/net/statistics_monitors.hpp"

#include <godot_cpp/classes/performance.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace ga_godot {

using godot::Array;
using godot::Callable;
using godot::Dictionary;
using godot::Performance;
using godot::String;
using godot::StringName;
using godot::vformat;

static constexpr const char *MONITORED[] = { "bytes_per_second", "packets_per_second", "loss", "round_trip", "playback_delay", "late", "rejected" };

Dictionary to_dictionary(const net::SessionStatistics &statistics) {
	Dictionary result;
	result["bytes_per_second"] = statistics.sent_bytes + statistics.received_bytes;
	result["packets_per_second"] = statistics.sent_packets + statistics.received_packets;
	result["sent_bytes_per_second"] = statistics.sent_bytes;
	result["received_bytes_per_second"] = statistics.received_bytes;
	result["loss"] = statistics.loss;
	result["round_trip"] = statistics.round_trip;
	result["line_rate"] = statistics.line_rate;
	result["relaxation"] = statistics.relaxation;
	result["playback_delay"] = statistics.playback_delay;
	result["late"] = int64_t(statistics.late);
	result["rejected"] = int64_t(statistics.rejected);
	result["unauthorized"] = int64_t(statistics.unauthorized);
	return result;
}

void StatisticsMonitors::add(const String &node_name, const Callable &read) {
	Performance *performance = Performance::get_singleton();
	_prefix = vformat("ga_godot/%s/", node_name);
	for (int64_t number = 2; performance->has_custom_monitor(_prefix + String(MONITORED[0])); number++) {
		_prefix = vformat("ga_godot/%s %d/", node_name, number);
	}
	for (const char *key : MONITORED) {
		// By name, because Godot 4.6 added a parameter: an older engine does not have the newer signature.
		performance->call("add_custom_monitor", _prefix + String(key), read, Array{ StringName(key) });
	}
}

void StatisticsMonitors::remove() {
	Performance *performance = Performance::get_singleton();
	for (const char *key : MONITORED) {
		const String monitor = _prefix + String(key);
		if (performance->has_custom_monitor(monitor)) {
			performance->remove_custom_monitor(monitor);
		}
	}
	_prefix = String();
}

} // namespace ga_godot
