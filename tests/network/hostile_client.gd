extends SceneTree
## A client of the multiplayer demo that joins like any other and then sends the server what it has no right to, or what
## is no packet at all, GA_GODOT_BAD_PACKETS times a second: noise, noise behind a true beginning, packets of the
## server's cut short, damaged and sent back, motion of bodies that are not its own, answers and goodbyes that nobody
## waits for, oversized ones.
##
## The arguments after `--` are those of the demo.

const SCENE := "res://demos/multiplayer/multiplayer.tscn"
const KINDS := 8
## The first byte of an envelope (src/net/delivery/envelope.hpp), without the kind.
const MARK := 0x44
const BYE := 1
const MOTION := 2
const ANSWER := 3
const ENVELOPE := 4
const MAX_CAPTURED := 200
const MAX_A_FRAME := 2000
## One of so many is oversized: it goes as dozens of datagrams.
const OVERSIZED_EVERY := 2000
const OVERSIZED := 20000

var _rate := float(OS.get_environment("GA_GODOT_BAD_PACKETS"))
var _demo: Node
var _api: SceneMultiplayer
var _captured: Array[PackedByteArray] = []
var _random := RandomNumberGenerator.new()
var _noise := PackedByteArray()
var _forger := MotorSender.new()
var _due := 0.0
var _sent := 0


func _initialize() -> void:
	_random.seed = 5
	for i: int in OVERSIZED:
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
	# It begins once it has seen what to imitate.
	if _captured.size() < 20 or not _api.get_peers().has(1):
		return false
	_due = minf(_due + delta * _rate, MAX_A_FRAME)
	while _due >= 1.0:
		_due -= 1.0
		_sent += 1
		_api.send_bytes(_make_packet(), 1, MultiplayerPeer.TRANSFER_MODE_UNRELIABLE)
	return false


func _finalize() -> void:
	print("Sent %d bad packets." % _sent)


func _on_peer_packet(_peer: int, packet: PackedByteArray) -> void:
	if packet.size() > ENVELOPE and _captured.size() < MAX_CAPTURED:
		_captured.append(packet)


func _make_packet() -> PackedByteArray:
	if _sent % OVERSIZED_EVERY == 0:
		return _with_envelope(MOTION, _noise)
	var seen := _captured[_random.randi() % _captured.size()]
	match _sent % KINDS:
		0:
			return _take_noise()
		1:
			return _with_envelope(MOTION, _take_noise())
		2:
			return _with_envelope(ANSWER, _take_noise())
		3:
			# Not its own stream's, which it may end as often as it likes.
			return _with_envelope(BYE, PackedByteArray([2 + _random.randi() % 250]))
		4:
			return seen.slice(0, 1 + _random.randi() % seen.size())
		5:
			return seen
		6:
			var damaged := seen.duplicate()
			damaged[_random.randi() % damaged.size()] ^= 1 << (_random.randi() & 7)
			return damaged
		_:
			return _forge_motion()


func _forge_motion() -> PackedByteArray:
	for packet: Dictionary in _forger.flush(_sent / 60.0):
		var bytes: PackedByteArray = packet["bytes"]
		return _with_envelope(MOTION, bytes)
	return _with_envelope(MOTION, _take_noise())


## The server's own key, and a stream's number that may or may not be the one in use.
func _with_envelope(kind: int, content: PackedByteArray) -> PackedByteArray:
	var packet := _captured[0].slice(0, ENVELOPE)
	packet[0] = MARK | kind
	if _random.randi() & 1:
		packet[3] = _random.randi() & 255
	packet.append_array(content)
	return packet


func _take_noise() -> PackedByteArray:
	var begin := _random.randi() % (OVERSIZED - 400)
	return _noise.slice(begin, begin + 1 + _random.randi() % 300)
