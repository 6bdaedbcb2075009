extends "res://tests/framework/network_test.gd"
## The script of docs/security.md: motion is replicated over DTLS, and peers without the server's
## certificate are not let in.

const PAGE := "docs/security.md"
const SCRIPT := "(?ms)^```gdscript dtls\\.gd\\n(.*?)^```$"
const SERVER_NAME := "my-game"
const FIRST_PORT := 27200
const LAST_PORT := 28900

var _key: CryptoKey
var _certificate: X509Certificate


func test_motion_over_dtls() -> void:
	var dtls := _compile()
	_key = Crypto.new().generate_rsa(2048)
	_certificate = _make_certificate(_key)
	var port := randi_range(FIRST_PORT, LAST_PORT)
	var server := make_branch("Server")
	server.api.multiplayer_peer = dtls.call(&"make_server", port, _key, _certificate)
	var client := make_branch("Client")
	client.api.multiplayer_peer = _make_client(dtls, port, _certificate)
	for branch in branches:
		branch.add_bodies(2)
		branch.start()
	await wait_until(client.is_joined, "the client to connect")
	await expect_motion(0.3, [client])
	# Neither without DTLS, nor with another server's certificate.
	var plain := make_branch("Plain")
	plain.join(port)
	var other := make_branch("Other")
	var other_key := Crypto.new().generate_rsa(2048)
	other.api.multiplayer_peer = _make_client(dtls, port, _make_certificate(other_key))
	await move(server, 1.0)
	expect_true(not plain.is_joined(), "a client without DTLS is not let in")
	expect_true(not other.is_joined(), "a client with another certificate is not let in")
	expect_equal(server.api.get_peers().size(), 1, "peers of the server")
	await expect_motion(0.3, [client])


func _make_client(dtls: Script, port: int, certificate: X509Certificate) -> MultiplayerPeer:
	return dtls.call(&"make_client", NetworkBranch.LOCALHOST, port, SERVER_NAME, certificate)


func _make_certificate(key: CryptoKey) -> X509Certificate:
	return Crypto.new().generate_self_signed_certificate(key, "CN=%s,O=Test,C=CH" % SERVER_NAME)


func _compile() -> GDScript:
	var repository := ProjectSettings.globalize_path("res://").trim_suffix("/").get_base_dir()
	var text := FileAccess.get_file_as_string(repository.path_join(PAGE))
	var script := GDScript.new()
	script.source_code = RegEx.create_from_string(SCRIPT).search(text).get_string(1)
	expect_equal(script.reload(), OK, "compiling dtls.gd")
	return script
