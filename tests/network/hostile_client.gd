extends SceneTree
## A client of the multiplayer demo that joins normally, then attacks the server with
## GA_GODOT_BAD_PACKETS per second: random bytes with and without a valid envelope, the server's
## packets truncated, damaged and sent back, motion of bodies that it does not own, unexpected
## acknowledgements and close packets, oversized packets. Well-formed packets as well: a stream of
## the server's cubes, floods of OPEN packets with claims to relay, requests to align windows.
##
## Takes the arguments of the demo after `--`.

const SCENE := "res://demos/multiplayer/multiplayer.tscn"
const KINDS := 8
## The first byte of an envelope, without the kind (src/net/session/envelope.hpp).
const MARK := 0x44
const OPEN := 0
const CLOSE := 1
const MOTION := 2
const ACK := 3
## Bytes of an envelope.
const ENVELOPE_SIZE := 4
const MAX_CAPTURED := 200
const MAX_PER_FRAME := 2000
## Every such packet is oversized: ENet splits it into dozens of datagrams.
const OVERSIZED_INTERVAL := 2000
const OVERSIZED_SIZE := 20000
## One packet of so many is well-formed.
const WELL_FORMED_INTERVAL := 16
## Seconds in which it sends only the stream of the cubes, which other packets would damage.
const IMPOSTOR_SECONDS := 1.0
## Item in an acknowledgement that requests other ends of windows (docs/wire-format.md).
const ALIGN := 0xc4

var _rate := float(OS.get_environment("GA_GODOT_BAD_PACKETS"))
var _demo: Node
var _api: SceneMultiplayer
var _captured: Array[PackedByteArray] = []
var _random := RandomNumberGenerator.new()
var _noise := PackedByteArray()
var _forger := MotorSender.new()
## Sends the server's cubes, which it learns from the server's stream, as if this client owned them.
var _impostor := MotorSender.new()
var _listener := MotorReceiver.new()
var _link := 0
var _seconds_attacked := 0.0
var _due := 0.0
var _sent := 0


func _initialize() -> void:
	_random.seed = 5
	for i: int in OVERSIZED_SIZE:
		_noise.append(_random.randi() & 255)
	for id: int in 50:
		_forger.add_body(
			_random.randi() & 0x7fffffff, Transform3D(Basis.IDENTITY, Vector3(0.0, 50.0, 0.0))
		)
	_forger.add_receiver(1, 0.0)
	var packed: PackedScene = load(SCENE)
	_demo = packed.instantiate()
	root.add_child(_demo)


func _process(delta: float) -> bool:
	if _api == null:
		_api = _demo.multiplayer as SceneMultiplayer
		_api.peer_packet.connect(_on_peer_packet)
	# Starts when it has captured packets to imitate.
	if _captured.size() < 20 or not _api.get_peers().has(1):
		return false
	_send_as_authority()
	_seconds_attacked += delta
	if _seconds_attacked < IMPOSTOR_SECONDS:
		return false
	_due = minf(_due + delta * _rate, MAX_PER_FRAME)
	while _due >= 1.0:
		_due -= 1.0
		_sent += 1
		_api.send_bytes(_make_packet(), 1, MultiplayerPeer.TRANSFER_MODE_UNRELIABLE)
	return false


func _finalize() -> void:
	print("Sent %d bad packets." % _sent)


func _on_peer_packet(_peer: int, packet: PackedByteArray) -> void:
	if packet.size() > ENVELOPE_SIZE and packet[0] & 0xf0 == MARK & 0xf0:
		_listen(packet)
	if packet.size() > ENVELOPE_SIZE and _captured.size() < MAX_CAPTURED:
		_captured.append(packet)


func _make_packet() -> PackedByteArray:
	if _sent % OVERSIZED_INTERVAL == 0:
		return _with_envelope(MOTION, _noise)
	if _sent % WELL_FORMED_INTERVAL == 0:
		return _make_well_formed()
	var captured := _captured[_random.randi() % _captured.size()]
	match _sent % KINDS:
		0:
			return _take_noise()
		1:
			return _with_envelope(MOTION, _take_noise())
		2:
			return _with_envelope(ACK, _take_noise())
		3:
			# Not the number of its own stream, which it is allowed to close.
			return _with_envelope(CLOSE, PackedByteArray([2 + _random.randi() % 250]))
		4:
			return captured.slice(0, 1 + _random.randi() % captured.size())
		5:
			return captured
		6:
			var damaged := captured.duplicate()
			damaged[_random.randi() % damaged.size()] ^= 1 << (_random.randi() & 7)
			return damaged
		_:
			return _forge_motion()


func _forge_motion() -> PackedByteArray:
	for packet: Dictionary in _forger.flush(_sent / 60.0):
		var bytes: PackedByteArray = packet["bytes"]
		return _with_envelope(MOTION, bytes)
	return _with_envelope(MOTION, _take_noise())


func _listen(packet: PackedByteArray) -> void:
	var content := packet.slice(ENVELOPE_SIZE)
	match packet[0] & 3:
		OPEN:
			_link = packet[3]
		MOTION:
			if not _listener.is_ready():
				_listener.accept(content, _seconds())
		ACK:
			if packet[3] == _link and _impostor.has_receiver(1):
				_impostor.accept(1, content, _seconds())
	if _listener.is_ready() and not _impostor.has_receiver(1):
		_listener.advance(_seconds())
		for id: int in _listener.get_bodies():
			_impostor.add_body(id, Transform3D(Basis.IDENTITY, Vector3(0.0, 90.0, 0.0)))
		_impostor.add_receiver(1, _seconds())


func _make_well_formed() -> PackedByteArray:
	if _random.randi() & 1:
		return _with_envelope(OPEN, PackedByteArray([_random.randi() & 1]))
	var request := PackedByteArray([ALIGN, _random.randi() & 255])
	request.resize(8)
	request.encode_u32(2, 100000)
	request.encode_s16(6, _random.randi_range(-900, 900))
	return _with_envelope(ACK, request)


func _send_as_authority() -> void:
	if not _impostor.has_receiver(1):
		return
	for packet: Dictionary in _impostor.flush(_seconds()):
		var bytes: PackedByteArray = packet["bytes"]
		_api.send_bytes(
			_with_envelope(MOTION, bytes, _link), 1, MultiplayerPeer.TRANSFER_MODE_UNRELIABLE
		)


func _seconds() -> float:
	return Time.get_ticks_usec() * 1e-6


## Prepends an envelope with the server's key and a stream number that may be in use.
func _with_envelope(kind: int, content: PackedByteArray, link := -1) -> PackedByteArray:
	var packet := _captured[0].slice(0, ENVELOPE_SIZE)
	packet[0] = MARK | kind
	if link >= 0:
		packet[3] = link
	elif _random.randi() & 1:
		packet[3] = _random.randi() & 255
	packet.append_array(content)
	return packet


func _take_noise() -> PackedByteArray:
	var begin := _random.randi() % (OVERSIZED_SIZE - 400)
	return _noise.slice(begin, begin + 1 + _random.randi() % 300)
