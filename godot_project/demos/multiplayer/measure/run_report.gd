extends RefCounted
## Reports the traffic that a client received during the scene to the tool that started the client.

const TrafficMeter := preload("traffic_meter.gd")

var _begun_at := 0.0
var _bytes := 0
var _packets := 0
var _lost := 0
var _values: Dictionary = {}


## Call when the scene begins.
func begin(meter: TrafficMeter) -> void:
	meter.update()
	_begun_at = _get_seconds()
	_bytes = meter.bytes
	_packets = meter.packets
	_lost = meter.lost


## Call when the scene has ended on the server.
func finish(method: String, meter: TrafficMeter) -> void:
	meter.update()
	_values = {
		"role": "client",
		"method": method,
		"seconds": _get_seconds() - _begun_at,
		"bytes": meter.bytes - _bytes,
		"packets": meter.packets - _packets,
		"lost": meter.lost - _lost,
		"total_packets": meter.packets,
	}


## Prints the report with additional counts. Call when the complete scene has been shown.
func print_json(counts: Dictionary) -> void:
	_values.merge(counts)
	print("REPORT ", JSON.stringify(_values))


static func _get_seconds() -> float:
	return Time.get_ticks_usec() * 1e-6
