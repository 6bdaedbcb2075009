extends "motion.gd"
## Client 1 is of another version, whose packets have the version `version` in the `layer` "session"
## or "stream".

const OtherVersion := preload("other_version_peer.gd")


func _wrap(peer: ENetMultiplayerPeer) -> MultiplayerPeer:
	if index != 1:
		return peer
	return OtherVersion.new(peer, text("layer") == "stream", int(number("version")))
