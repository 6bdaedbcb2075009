extends Node3D
## The multiplayer demo: a server, a client, or the lobby, depending on the command line
## (options.gd). It has its own multiplayer API, so that it runs anywhere in the scene tree.

const Client := preload("client.gd")
const ClientView := preload("view/client_view.gd")
const Lobby := preload("view/lobby.gd")
const MotorLink := preload("replication/motor_link.gd")
const Options := preload("options.gd")
const PoseLink := preload("replication/pose_link.gd")
const Server := preload("server.gd")
const Session := preload("session.gd")
const SynchronizerLink := preload("replication/synchronizer_link.gd")

var _options: Options
var _session: Session
var _lobby: Lobby


func _ready() -> void:
	_options = Options.parse(OS.get_cmdline_user_args())
	if not _options.error.is_empty():
		printerr("multiplayer demo: ", _options.error)
		get_tree().quit(2)
		return
	var api := SceneMultiplayer.new()
	# Clients communicate only with the server.
	api.server_relay = false
	get_tree().set_multiplayer(api, get_path())
	match _options.role:
		"server":
			_start_server()
		"client":
			_start_client()
		_:
			_open_lobby("")


func _exit_tree() -> void:
	get_tree().set_multiplayer(null, get_path())


func _start_server() -> void:
	_add_session()
	var server := Server.new(_options, _session, _make_links())
	add_child(server)
	var error := server.open()
	if not error.is_empty():
		printerr(error)
		get_tree().quit(1)
	elif _has_window():
		_show_text("Server on port %d. Close this window to stop it." % _options.port)


func _start_client() -> void:
	_add_session()
	var client := Client.new(_options, _session, _make_links())
	client.closed.connect(_on_client_closed)
	add_child(client)
	if _has_window():
		add_child(ClientView.new(client, _options))
	var error := client.open()
	if not error.is_empty():
		_on_client_closed(error)


func _on_client_closed(reason: String) -> void:
	if _has_window() and _options.screenshot.is_empty() and _options.seconds <= 0.0:
		_open_lobby.call_deferred(reason)
	else:
		get_tree().quit()


## Shows the lobby, with a message if there is one.
func _open_lobby(message: String) -> void:
	for child: Node in get_children():
		child.queue_free()
		remove_child(child)
	if not _has_window():
		printerr("multiplayer demo: without a window, --role=server or --role=client is required.")
		get_tree().quit(2)
		return
	_lobby = Lobby.new(_options, message)
	_lobby.chosen.connect(_on_lobby_chosen)
	add_child(_lobby)


func _on_lobby_chosen() -> void:
	remove_child(_lobby)
	_lobby.queue_free()
	_start_client()


func _add_session() -> void:
	_session = Session.new()
	_session.name = "Session"
	add_child(_session)


## One link per method.
func _make_links() -> Dictionary[String, PoseLink]:
	var links: Dictionary[String, PoseLink] = {
		"motors": MotorLink.new(), "synchronizer": SynchronizerLink.new()
	}
	for method: String in links:
		links[method].name = method.capitalize()
		add_child(links[method])
	return links


func _show_text(text: String) -> void:
	var label := Label.new()
	label.text = text
	label.theme_type_variation = &"HeadingLabel"
	label.position = Vector2(32.0, 32.0)
	add_child(label)


func _has_window() -> bool:
	return DisplayServer.get_name() != "headless"
