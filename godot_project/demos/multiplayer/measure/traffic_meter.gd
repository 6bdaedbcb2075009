extends RefCounted
## Counts packets and bytes from the server, without the 28 bytes of IP and UDP headers per packet.
## It uses the counters of ENet, or those of the proxy, which include lost packets.
##
## Packets are lost in the proxy, which simulates loss, but also on a busy machine: the system drops
## what a process does not read in time. ENet reports neither. The meter counts both.

const SocketDrops := preload("../network/socket_drops.gd")
const UdpProxy := preload("../network/udp_proxy.gd")

## Seconds between two readings of the system's tables.
const DROP_INTERVAL := 0.25

var bytes := 0
var packets := 0
## Lost packets, which are also counted in [member packets]; known only with a proxy.
var lost := 0
## Received bytes and packets.
var arrived := 0
var arrived_packets := 0

var _host: ENetConnection
var _proxy: UdpProxy
var _discounted := 0
## Packets that the proxy had delivered in the previous frame. ENet has read them by now, unless the
## system has dropped them.
var _delivered := 0
var _dropped_after_proxy := 0
var _dropped_before_proxy := 0
var _next_drop_reading := 0.0


## [param proxy] may be null.
func _init(host: ENetConnection, proxy: UdpProxy) -> void:
	_host = host
	_proxy = proxy


## Excludes the bytes of a packet that is not part of the replication.
func discount(packet_bytes: int) -> void:
	_discounted += packet_bytes


## Reads the counters.
func update() -> void:
	arrived_packets += int(_host.pop_statistic(ENetConnection.HOST_TOTAL_RECEIVED_PACKETS))
	arrived += int(_host.pop_statistic(ENetConnection.HOST_TOTAL_RECEIVED_DATA))
	if _proxy == null:
		packets = arrived_packets
		bytes = arrived - _discounted
		return
	var counts := _proxy.get_counts()
	packets = counts.down_packets + _dropped_before_proxy
	bytes = counts.down_bytes - _discounted
	lost = counts.down_lost + _dropped_before_proxy + _dropped_after_proxy


## Counts what the system dropped. Call it once per frame, after [method update].
func count_drops() -> void:
	if _proxy == null:
		return
	var counts := _proxy.get_counts()
	_dropped_after_proxy = maxi(_dropped_after_proxy, _delivered - arrived_packets)
	_delivered = counts.down_delivered
	var now := Time.get_ticks_usec() * 1e-6
	if now >= _next_drop_reading:
		_next_drop_reading = now + DROP_INTERVAL
		_dropped_before_proxy = maxi(_dropped_before_proxy, SocketDrops.count(counts.ports))
