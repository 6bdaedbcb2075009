extends RefCounted
## What ENet's own counters say about a connection: bytes and packets received, without the 28 bytes
## of IP and UDP a packet.

const WINDOW := 1.0

var bytes := 0
var packets := 0
## Over the last second.
var bytes_per_second := 0.0
var packets_per_second := 0.0

var _host: ENetConnection
var _window_bytes := 0
var _window_packets := 0
var _window_start := 0.0


func _init(host: ENetConnection) -> void:
	_host = host


## Reads the counters at [param local] seconds; call it every frame.
func update(local: float) -> void:
	var new_bytes := int(_host.pop_statistic(ENetConnection.HOST_TOTAL_RECEIVED_DATA))
	var new_packets := int(_host.pop_statistic(ENetConnection.HOST_TOTAL_RECEIVED_PACKETS))
	bytes += new_bytes
	packets += new_packets
	_window_bytes += new_bytes
	_window_packets += new_packets
	var elapsed := local - _window_start
	if elapsed >= WINDOW:
		bytes_per_second = _window_bytes / elapsed
		packets_per_second = _window_packets / elapsed
		_window_bytes = 0
		_window_packets = 0
		_window_start = local


## Begins to count anew.
func restart(local: float) -> void:
	update(local)
	bytes = 0
	packets = 0
