extends Node3D
## An avatar: head and two hands, which the player's client owns. As with a headset, they move in
## [method _process]; here a script moves them: the head looks around, the hands gesture and rest.

const PARTS: PackedStringArray = ["Head", "LeftHand", "RightHand"]
## Avatars on a circle, and the radius of that circle and of the next one, in meters.
const CIRCLE := 8
const RADII: PackedFloat32Array = [2.4, 1.1]
const HEAD := Vector3(0.0, 1.6, 0.0)
const HAND := Vector3(0.32, 1.15, -0.35)
## Radius of the gestures in meters, and their rate in radians per second: up to 2 m/s.
const REACH := 0.28
const GESTURE_RATE := 6.5

var parts: Array[Node3D] = []
## Seconds since the avatar began to move.
var seconds := 0.0

var _slot: int


## [param slot] counts from 1. [param peer] is the client that owns the avatar; [param is_own],
## whether it is this one.
func _init(slot: int, peer: int, is_own: bool) -> void:
	_slot = slot
	name = "Avatar%d" % peer
	var angle := TAU * (slot - 1) / CIRCLE
	var radius := RADII[(slot - 1) / CIRCLE % RADII.size()]
	transform = Transform3D(
		Basis(Vector3.UP, angle), Basis(Vector3.UP, angle) * Vector3(0.0, 0.0, radius)
	)
	for part: String in PARTS:
		var node := Node3D.new()
		node.name = part
		add_child(node)
		parts.append(node)
	set_multiplayer_authority(peer)
	set_process(is_own)
	_pose()


func _process(delta: float) -> void:
	seconds += delta
	_pose()


func _pose() -> void:
	# A different phase for each avatar.
	var time := seconds + _slot * 1.7
	var look := Vector3(0.25 * sin(time * 1.3), 0.7 * sin(time * 0.8), 0.1 * sin(time * 0.9))
	var sway := Vector3(0.12 * sin(time * 0.7), 0.03 * sin(time * 2.1), 0.1 * sin(time * 0.5))
	parts[0].transform = Transform3D(Basis.from_euler(look), HEAD + sway)
	for side: int in 2:
		parts[side + 1].transform = _get_hand_pose(time + side * 2.6, -1.0 if side == 0 else 1.0)


func _get_hand_pose(time: float, side: float) -> Transform3D:
	# Gestures of a few seconds, and rests between them.
	var strength := smoothstep(-0.2, 0.5, sin(time * 0.9))
	var turn := time * GESTURE_RATE
	var gesture := Vector3(cos(turn), sin(turn), 0.5 * sin(turn * 0.5)) * REACH * strength
	var drift := Vector3(0.05 * sin(time * 0.6), 0.04 * sin(time * 0.8), 0.05 * sin(time * 0.7))
	var bend := Vector3(0.5 * sin(turn * 0.5), 0.3 * sin(time), 0.8 * sin(turn)) * strength
	var rest := Vector3(HAND.x * side, HAND.y, HAND.z)
	return Transform3D(Basis.from_euler(bend), rest + drift + gesture)
