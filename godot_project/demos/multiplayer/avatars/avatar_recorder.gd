extends RefCounted
## Records the avatars that a client shows, one file for each: the client's own avatar to the given
## path, that of slot N to the path with ".N". The format is that of pose_recorder.gd.

const Avatar := preload("avatar.gd")
const AvatarGroup := preload("avatar_group.gd")
const PoseRecorder := preload("../measure/pose_recorder.gd")

var _recorders: Dictionary[int, PoseRecorder] = {}
var _rows := PackedFloat32Array()
var _own_peer: int
## Wall clock at the zero of the own avatar's seconds.
var _base := NAN


## [param roster] holds [slot, peer, name] for each player.
func _init(path: String, own_peer: int, roster: Array) -> void:
	_own_peer = own_peer
	_rows.resize(Avatar.PARTS.size() * 12)
	for player: Array in roster:
		var peer: int = player[1]
		var file := path if peer == own_peer else "%s.%d" % [path, player[0]]
		_recorders[peer] = PoseRecorder.new(file, Avatar.PARTS.size())


## Records the current poses. Call it once per frame.
func record(group: AvatarGroup) -> void:
	var now := Time.get_unix_time_from_system()
	for peer: int in _recorders:
		var avatar := group.get_avatar(peer)
		if avatar == null or not avatar.parts[0].visible:
			continue
		for part: int in avatar.parts.size():
			PoseRecorder.set_rows(_rows, part, avatar.parts[part].transform)
		if peer == _own_peer:
			# The poses belong to the seconds of the avatar, not to the moment of this call.
			_base = now - avatar.seconds if is_nan(_base) else _base
			_recorders[peer].write(_base + avatar.seconds, -1.0, _rows)
		else:
			_recorders[peer].write(now, -1.0, _rows)


func close() -> void:
	for recorder: PoseRecorder in _recorders.values():
		recorder.close()
