extends RefCounted
## Counts packets and bytes from the server, without the 28 bytes of IP and UDP headers per packet.
## It uses the counters of ENet, or those of the proxy, which include lost packets.

const UdpProxy := preload("../network/udp_proxy.gd")

var bytes := 0
var packets := 0
## Lost packets; known only with a proxy.
var lost := 0
## Received bytes.
var arrived := 0

var _host: ENetConnection
var _proxy: UdpProxy
var _discounted := 0


## [param proxy] may be null.
func _init(host: ENetConnection, proxy: UdpProxy) -> void:
	_host = host
	_proxy = proxy


## Excludes the bytes of a packet that is not part of the replication.
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
