extends Node3D
## The avatars of all players, replicated by one [MotorSynchronizer], on the server and on clients.

## Emitted when an avatar appears.
signal avatar_added(slot: int, player_name: String, avatar: Avatar)

const Avatar := preload("avatar.gd")

## Null before [method open].
var synchronizer: MotorSynchronizer

## By peer.
var _avatars: Dictionary[int, Avatar] = {}


func _init() -> void:
	name = "Avatars"


## [param relay]: whether the server forwards the motion of the clients, or Godot their packets.
func open(relay: bool) -> void:
	synchronizer = MotorSynchronizer.new()
	synchronizer.name = "Synchronizer"
	synchronizer.relay = relay
	add_child(synchronizer)


## Adds and removes avatars. [param roster] holds [slot, peer, name] for each player.
func show_roster(roster: Array) -> void:
	var present: Dictionary[int, bool] = {}
	for player: Array in roster:
		var peer: int = player[1]
		present[peer] = true
		if not _avatars.has(peer):
			_add(player[0] as int, peer, player[2] as String)
	for peer: int in _avatars.keys():
		if not present.has(peer):
			_avatars[peer].queue_free()
			_avatars.erase(peer)


## The peers that have an avatar.
func get_owners() -> Array[int]:
	return _avatars.keys()


func get_avatar(peer: int) -> Avatar:
	return _avatars.get(peer)


func _add(slot: int, peer: int, player_name: String) -> void:
	var avatar := Avatar.new(slot, peer, peer == multiplayer.get_unique_id())
	_avatars[peer] = avatar
	for part: Node3D in avatar.parts:
		synchronizer.add_target(part)
	add_child(avatar)
	avatar_added.emit(slot, player_name, avatar)
