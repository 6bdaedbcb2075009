extends RefCounted
## What ENet's own counters say about a connection: bytes and packets received, without the 28 bytes
## of IP and UDP a packet.

var bytes := 0
var packets := 0

var _host: ENetConnection


func _init(host: ENetConnection) -> void:
	_host = host


## Reads the counters; call it every frame.
func update() -> void:
	bytes += int(_host.pop_statistic(ENetConnection.HOST_TOTAL_RECEIVED_DATA))
	packets += int(_host.pop_statistic(ENetConnection.HOST_TOTAL_RECEIVED_PACKETS))
