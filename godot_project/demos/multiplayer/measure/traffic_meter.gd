extends RefCounted
## What has come from the server, in bytes and packets without the 28 bytes of IP and UDP a packet: by ENet's own
## counters; where a proxy makes the network bad, by the proxy's, before anything is lost.

const UdpProxy := preload("../network/udp_proxy.gd")

var bytes := 0
var packets := 0
## Packets that were lost on the way.
var lost := 0
## Bytes that arrived.
var arrived := 0

var _host: ENetConnection
var _proxy: UdpProxy
var _discounted := 0


## [param proxy] may be null.
func _init(host: ENetConnection, proxy: UdpProxy) -> void:
	_host = host
	_proxy = proxy


## Leaves out a packet that is no part of what is measured, with so many bytes.
func discount(packet_bytes: int) -> void:
	_discounted += packet_bytes


## Reads the counters.
func update() -> void:
	var arrived_packets := int(_host.pop_statistic(ENetConnection.HOST_TOTAL_RECEIVED_PACKETS))
	arrived += int(_host.pop_statistic(ENetConnection.HOST_TOTAL_RECEIVED_DATA))
	if _proxy == null:
		packets += arrived_packets
		bytes = arrived - _discounted
		return
	var counts := _proxy.get_counts()
	packets = counts.down_packets
	bytes = counts.down_bytes - _discounted
	lost = counts.down_lost
