extends Node
## A UDP proxy that impairs the network between clients and a server: it loses, delays, reorders and
## duplicates packets in both directions, independently for each client. It listens on the loopback
## interface. It runs in its own thread, so that it is independent of the frame rate, and adds about
## half a millisecond of delay.

const LineConditions := preload("line_conditions.gd")
const UdpRelay := preload("udp_relay.gd")

var _relay := UdpRelay.new()
var _thread := Thread.new()


## Starts to forward packets to a server. Clients connect to 127.0.0.1 at [method get_port].
func open(server_address: String, server_port: int, seed_value: int) -> Error:
	var error := _relay.open(server_address, server_port, seed_value)
	# The thread runs the relay rather than this node: an object cannot be freed while a thread runs
	# its method.
	return error if error != OK else _thread.start(_relay.run)


func get_port() -> int:
	return _relay.get_port()


## Affects packets that enter the proxy from now on. The proxy keeps a reference: pass a new object
## for each change.
func set_conditions(conditions: LineConditions) -> void:
	_relay.set_conditions(conditions)


func get_counts() -> UdpRelay.Counts:
	return _relay.get_counts()


func close() -> void:
	if _thread.is_started():
		_relay.stop()
		_thread.wait_to_finish()


## Closes here rather than on NOTIFICATION_EXIT_TREE, so that the proxy still forwards the client's
## disconnect message.
func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE:
		close()
