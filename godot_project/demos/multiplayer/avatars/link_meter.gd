extends RefCounted
## Counts the datagrams and bytes that a process sends and receives, by ENet's counters, without the
## 28 bytes of IP and UDP headers per datagram.

const TrafficMeter := preload("../measure/traffic_meter.gd")

const SENT_BYTES := ENetConnection.HOST_TOTAL_SENT_DATA
const SENT_PACKETS := ENetConnection.HOST_TOTAL_SENT_PACKETS

var _host: ENetConnection
## Reads the counters of what is received.
var _meter: TrafficMeter
var _begun_at := 0.0
var _bytes := 0
var _packets := 0


func _init(host: ENetConnection, meter: TrafficMeter) -> void:
	_host = host
	_meter = meter


## Starts to count.
func begin() -> void:
	_meter.update()
	_bytes = _meter.arrived
	_packets = _meter.arrived_packets
	_host.pop_statistic(SENT_BYTES)
	_host.pop_statistic(SENT_PACKETS)
	_begun_at = _get_seconds()


## The counts since [method begin], and the seconds.
func get_report() -> Dictionary:
	_meter.update()
	return {
		"seconds": _get_seconds() - _begun_at,
		"sent_bytes": _host.pop_statistic(SENT_BYTES),
		"sent_datagrams": _host.pop_statistic(SENT_PACKETS),
		"received_bytes": _meter.arrived - _bytes,
		"received_datagrams": _meter.arrived_packets - _packets,
	}


static func _get_seconds() -> float:
	return Time.get_ticks_usec() * 1e-6
