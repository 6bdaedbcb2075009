extends Node3D
## The multiplayer demo: a server, a client, or the lobby, depending on the command line
## (options.gd). It has its own multiplayer API, so that it runs anywhere in the scene tree.

const AvatarClient := preload("avatars/avatar_client.gd")
const AvatarServer := preload("avatars/avatar_server.gd")
const AvatarView := preload("avatars/avatar_view.gd")
const Client := preload("client.gd")
const ClientBase := preload("client_base.gd")
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
	# Clients communicate only with the server, except for avatars without MotorSynchronizer's relay.
	# A client gets the scene from the server, which decides.
	api.server_relay = (
		_options.role != "server" or (_options.scene == Options.AVATARS and not _options.relay)
	)
	get_tree().set_multiplayer(api, get_path())
	match _options.role:
		"server":
			_start_server()
		"client":
			_start_client()
		_:
			_open_lobby("")


## Frees the API once the nodes below have left the tree: before, Godot reports an error in release
## exports (godot#123751).
func _exit_tree() -> void:
	tree_exited.connect(get_tree().set_multiplayer.bind(null, get_path()), CONNECT_ONE_SHOT)


func _start_server() -> void:
	_add_session()
	var error := _open_avatar_server() if _is_avatars() else _open_server()
	if not error.is_empty():
		printerr(error)
		get_tree().quit(1)
	elif _has_window():
		_show_text("Server on port %d. Close this window to stop it." % _options.port)


func _open_server() -> String:
	var server := Server.new(_options, _session, _make_links())
	add_child(server)
	return server.open()


func _open_avatar_server() -> String:
	var server := AvatarServer.new(_options, _session)
	add_child(server)
	return server.open()


func _start_client() -> void:
	_add_session()
	var client: ClientBase
	var view: Node3D
	if _is_avatars():
		var avatar_client := AvatarClient.new(_options, _session)
		client = avatar_client
		view = AvatarView.new(avatar_client, _options) if _has_window() else null
	else:
		var cube_client := Client.new(_options, _session, _make_links())
		client = cube_client
		view = ClientView.new(cube_client, _options) if _has_window() else null
	client.name = "Client"
	client.closed.connect(_on_client_closed)
	client.scene_differs.connect(_on_scene_differs, CONNECT_DEFERRED)
	add_child(client)
	if view != null:
		add_child(view)
	var error := client.open()
	if not error.is_empty():
		_on_client_closed(error)


## The server has a scene of the other kind: starts again with its client.
func _on_scene_differs(scene: String) -> void:
	_options.scene = scene
	_remove_children()
	_start_client()


func _is_avatars() -> bool:
	return _options.scene == Options.AVATARS


func _on_client_closed(reason: String) -> void:
	if _has_window() and _options.screenshot.is_empty() and _options.seconds <= 0.0:
		_open_lobby.call_deferred(reason)
	else:
		get_tree().quit()


## Shows the lobby, with a message if there is one.
func _open_lobby(message: String) -> void:
	_remove_children()
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


func _remove_children() -> void:
	for child: Node in get_children():
		child.queue_free()
		remove_child(child)


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
