extends RefCounted
## Sends a stream to all clients that have confirmed their address.

const CookieHandshake := preload("cookie_handshake.gd")

const MAX_CLIENTS := 16
## A client that has been silent for this many seconds gets nothing more until it joins again.
const MAX_SILENCE := 5.0


## A confirmed address, which receives the stream as receiver [member id].
class Client:
	var id: int
	var ip: String
	var port: int
	var heard_at: float


var sender := MotorSender.new()

var _socket := PacketPeerUDP.new()
var _handshake := CookieHandshake.new()
var _clients: Dictionary[String, Client] = {}
var _last_id := 0


func listen(address: String) -> Error:
	return _socket.bind(0, address)


func get_port() -> int:
	return _socket.get_local_port()


func get_client_count() -> int:
	return _clients.size()


## Processes packets and sends those that are due. [param time] is that of the stream; [param now]
## that of a monotonic clock. Call it each tick.
func update(time: float, now: float) -> void:
	while _socket.get_available_packet_count() > 0:
		var packet := _socket.get_packet()
		_accept(packet, _socket.get_packet_ip(), _socket.get_packet_port(), time, now)
	for address: String in _clients.keys():
		if now - _clients[address].heard_at > MAX_SILENCE:
			sender.remove_receiver(_clients[address].id)
			_clients.erase(address)
	var by_id: Dictionary[int, Client] = {}
	for client: Client in _clients.values():
		by_id[client.id] = client
	for packet: Dictionary in sender.flush(time):
		var to: int = packet.receiver
		var bytes: PackedByteArray = packet.bytes
		_send(PackedByteArray([CookieHandshake.Kind.STREAM]) + bytes, by_id[to].ip, by_id[to].port)


func _accept(packet: PackedByteArray, ip: String, port: int, time: float, now: float) -> void:
	var address := "%s %d" % [ip, port]
	var client: Client = _clients.get(address)
	if client != null and not packet.is_empty() and packet[0] == CookieHandshake.Kind.STREAM:
		client.heard_at = now
		sender.accept(client.id, packet.slice(1), time)
	elif client == null and _clients.size() < MAX_CLIENTS:
		var cookie := _handshake.make_cookie(packet, ip, port, now)
		if not cookie.is_empty():
			_send(cookie, ip, port)
		elif _handshake.is_join(packet, ip, port, now):
			_add_client(address, ip, port, time, now)


func _add_client(address: String, ip: String, port: int, time: float, now: float) -> void:
	_last_id += 1
	var client := Client.new()
	client.id = _last_id
	client.ip = ip
	client.port = port
	client.heard_at = now
	_clients[address] = client
	sender.add_receiver(client.id, time)


func _send(packet: PackedByteArray, ip: String, port: int) -> void:
	_socket.set_dest_address(ip, port)
	_socket.put_packet(packet)
