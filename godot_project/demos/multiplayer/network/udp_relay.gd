extends RefCounted
## The relay of [code]udp_proxy.gd[/code]: forwards packets between clients and a server through
## impaired lines. [method run] runs in its own thread; the other methods are thread-safe.

const ImpairedLine := preload("impaired_line.gd")
const LineConditions := preload("line_conditions.gd")

const LOOPBACK := "127.0.0.1"
## Microseconds between two polls of the sockets.
const POLL_INTERVAL := 400
## Size of the buffer for packets of the server, in bytes, for what arrives while a busy machine
## does not run the thread. The default of 64 KiB holds a quarter of a second of
## MultiplayerSynchronizer's packets. Beyond it, the engine drops packets and prints "Buffer full".
const RECEIVE_BUFFER := 1 << 22
## Maximum number of clients. The relay ignores more.
const MAX_ROUTES := 32
## Seconds without a packet from a client after which its route is removed.
const MAX_SILENCE := 20.0
## Difference between the seeds of two lines.
const SEED_STEP := 7919


## The lines of one client.
class Route:
	var client: PacketPeerUDP
	var server := PacketPeerUDP.new()
	var up: ImpairedLine
	var down: ImpairedLine
	var heard_at := 0.0
	## Packets passed to the client's socket, and those that the socket refused.
	var delivered := 0
	var refused := 0


## Packets and bytes that entered the lines, including lost ones.
class Counts:
	var up_packets := 0
	var up_bytes := 0
	var down_packets := 0
	var down_bytes := 0
	## Packets to clients that were lost or dropped in the line, or refused by the socket.
	var down_lost := 0
	## Packets passed to the sockets of clients.
	var down_delivered := 0
	## Local ports of the sockets that receive the server's packets.
	var ports := PackedInt32Array()

	func add(route: Route) -> void:
		up_packets += route.up.packets
		up_bytes += route.up.bytes
		down_packets += route.down.packets
		down_bytes += route.down.bytes
		down_lost += route.down.lost + route.down.overflowed + route.refused
		down_delivered += route.delivered
		ports.append(route.server.get_local_port())


var _listener := UDPServer.new()
var _server_address: String
var _server_port: int
var _seed: int
# Guards the following variables and the sockets.
var _mutex := Mutex.new()
var _is_stopped := false
var _conditions := LineConditions.new()
var _routes: Array[Route] = []
var _route_count := 0


## Starts to listen at [method get_port].
func open(server_address: String, server_port: int, seed_value: int) -> Error:
	_server_address = IP.resolve_hostname(server_address)
	_server_port = server_port
	_seed = seed_value
	if _server_address.is_empty():
		return ERR_CANT_RESOLVE
	_listener.max_pending_connections = MAX_ROUTES
	return _listener.listen(0, LOOPBACK)


func get_port() -> int:
	return _listener.get_local_port()


## Affects packets that arrive from now on, in both directions of all clients. Keeps a reference:
## pass a new object for each change.
func set_conditions(conditions: LineConditions) -> void:
	_mutex.lock()
	_conditions = conditions
	for route: Route in _routes:
		route.up.conditions = conditions
		route.down.conditions = conditions
	_mutex.unlock()


## The sum over the current clients.
func get_counts() -> Counts:
	var counts := Counts.new()
	_mutex.lock()
	for route: Route in _routes:
		counts.add(route)
	_mutex.unlock()
	return counts


## Forwards packets until [method stop].
func run() -> void:
	while _serve(Time.get_ticks_usec() * 1e-6):
		OS.delay_usec(POLL_INTERVAL)


## Stops [method run], after forwarding the pending packets of clients, such as disconnect messages.
func stop() -> void:
	_mutex.lock()
	_is_stopped = true
	for route: Route in _routes:
		_forward(route, INF)
	_routes.clear()
	_listener.stop()
	_mutex.unlock()


## Polls the sockets once. Returns false after [method stop].
func _serve(now: float) -> bool:
	_mutex.lock()
	var is_running := not _is_stopped
	if is_running:
		_accept_clients(now)
		_forward_all(now)
	_mutex.unlock()
	return is_running


func _accept_clients(now: float) -> void:
	_listener.poll()
	while _listener.is_connection_available():
		var client := _listener.take_connection()
		if _routes.size() < MAX_ROUTES:
			_add_client(client, now)


func _forward_all(now: float) -> void:
	for index: int in range(_routes.size() - 1, -1, -1):
		var route := _routes[index]
		_forward(route, now)
		if now - route.heard_at > MAX_SILENCE:
			_routes.remove_at(index)


func _forward(route: Route, now: float) -> void:
	while route.client.get_available_packet_count() > 0:
		route.up.put(route.client.get_packet(), now)
		route.heard_at = now
	while route.server.get_available_packet_count() > 0:
		route.down.put(route.server.get_packet(), now)
	for packet: PackedByteArray in route.up.take(now):
		route.server.put_packet(packet)
	for packet: PackedByteArray in route.down.take(now):
		if route.client.put_packet(packet) == OK:
			route.delivered += 1
		else:
			route.refused += 1


func _add_client(client: PacketPeerUDP, now: float) -> void:
	var route := Route.new()
	route.client = client
	route.server.bind(0, "*", RECEIVE_BUFFER)
	route.server.set_dest_address(_server_address, _server_port)
	route.up = ImpairedLine.new(_seed + SEED_STEP * 2 * _route_count)
	route.down = ImpairedLine.new(_seed + SEED_STEP * (2 * _route_count + 1))
	route.up.conditions = _conditions
	route.down.conditions = _conditions
	route.heard_at = now
	_route_count += 1
	_routes.append(route)
