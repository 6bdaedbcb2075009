extends "res://tests/framework/network_test.gd"
## The scripts of docs/security.md: motion is replicated over encrypted connections, and peers
## without the server's certificate are not let in.

const PAGE := "docs/security.md"
const SCRIPT := "(?ms)^```gdscript %s\\n(.*?)^```$"
const SERVER_NAME := "my-game"

var _key := Crypto.new().generate_rsa(2048)
var _certificate := _make_certificate(_key)


func test_motion_over_dtls() -> void:
	if not _has_dtls():
		# Never an unencrypted connection instead.
		var script := _compile("dtls.gd")
		for side: String in ["server", "client"]:
			expect_error("ENet DTLS support not available in this build.")
			expect_null(_make(script, side, NetworkBranch.find_free_port()), side)
		return
	await _expect_encrypted("dtls.gd", false)


func test_motion_over_tls() -> void:
	expect_error("TLS handshake error: -9984")  # of the client with another certificate
	await _expect_encrypted("tls.gd", true)


func _expect_encrypted(file: String, is_websocket: bool) -> void:
	var script := _compile(file)
	var port := NetworkBranch.find_free_port(is_websocket)
	var server := make_branch("Server")
	server.api.multiplayer_peer = _make(script, "server", port)
	var client := make_branch("Client")
	client.api.multiplayer_peer = _make(script, "client", port)
	for branch in branches:
		branch.add_bodies(2)
		branch.start()
	await wait_until(client.is_joined, "the client to connect")
	await expect_motion(0.3, [client])
	# Neither without encryption, nor with another server's certificate.
	var plain := make_branch("Plain")
	plain.join(port, is_websocket)
	var other := make_branch("Other")
	_certificate = _make_certificate(Crypto.new().generate_rsa(2048))
	other.api.multiplayer_peer = _make(script, "client", port)
	await move(server, 1.0)
	expect_true(not plain.is_joined(), "a client without encryption is not let in")
	expect_true(not other.is_joined(), "a client with another certificate is not let in")
	expect_equal(server.api.get_peers().size(), 1, "peers of the server")
	await expect_motion(0.3, [client])


func _make(script: GDScript, side: String, port: int) -> MultiplayerPeer:
	if side == "server":
		return script.call(&"make_server", port, _key, _certificate)
	return script.call(&"make_client", NetworkBranch.LOCALHOST, port, SERVER_NAME, _certificate)


func _make_certificate(key: CryptoKey) -> X509Certificate:
	return Crypto.new().generate_self_signed_certificate(key, "CN=%s,O=Test,C=CH" % SERVER_NAME)


## Packages of some distributions use a library without DTLS.
func _has_dtls() -> bool:
	return Engine.get_version_info()["build"] == "official"


func _compile(file: String) -> GDScript:
	var repository := ProjectSettings.globalize_path("res://").trim_suffix("/").get_base_dir()
	var text := FileAccess.get_file_as_string(repository.path_join(PAGE))
	var script := GDScript.new()
	script.source_code = (
		RegEx.create_from_string(SCRIPT % file.replace(".", "\\.")).search(text).get_string(1)
	)
	expect_equal(script.reload(), OK, "compiling %s" % file)
	return script
