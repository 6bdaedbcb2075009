extends "crowd.gd"
## The transport refuses packets of more than `limit` bytes.

const LimitedPeer := preload("limited_peer.gd")

var _limited: LimitedPeer


func _wrap(peer: ENetMultiplayerPeer) -> MultiplayerPeer:
	_limited = LimitedPeer.new(peer, int(number("limit")))
	return _limited


func _report(report: Dictionary) -> void:
	report["refused"] = _limited.refused
	report["largest"] = _limited.largest
