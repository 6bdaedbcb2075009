extends Node
## A bad network between clients and a server on UDP: listens on a port of this machine alone, and loses, delays,
## reorders and repeats what it passes on, both ways, for every client apart. It works in a thread of its own, so that
## frames neither wait for it nor delay it; all it takes itself is about half a millisecond.

const LineConditions := preload("line_conditions.gd")
const UdpRelay := preload("udp_relay.gd")

var _relay := UdpRelay.new()
var _thread := Thread.new()


## Begins to pass on to that server. [method get_port] tells where clients find it, on 127.0.0.1.
func open(server_address: String, server_port: int, seed_value: int) -> Error:
	var error := _relay.open(server_address, server_port, seed_value)
	# The relay is the thread's object, not this node: an object cannot be freed while a thread runs in it.
	return error if error != OK else _thread.start(_relay.run)


func get_port() -> int:
	return _relay.get_port()


## Holds from the next packet on. The proxy keeps the object: give a new one for other conditions.
func set_conditions(conditions: LineConditions) -> void:
	_relay.set_conditions(conditions)


func get_counts() -> UdpRelay.Counts:
	return _relay.get_counts()


func close() -> void:
	if _thread.is_started():
		_relay.stop()
		_thread.wait_to_finish()


## Not when it leaves the tree: what its client says when that leaves shall still be passed on.
func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE:
		close()
