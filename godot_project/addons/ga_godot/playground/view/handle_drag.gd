@tool
extends RefCounted
## One drag of a handle. It becomes one action in the history unless it is canceled.

const PlaygroundDocument := preload("../document/playground_document.gd")
const ViewHandle := preload("view_handle.gd")
const ViewRay := preload("view_ray.gd")
const ViewScale := preload("view_scale.gd")

## The handle when the drag began.
var start: ViewHandle
var entry: String

var _document: PlaygroundDocument
var _before := ""
# Offset from the handle to the mouse, in pixels.
var _offset: Vector2


func _init(document: PlaygroundDocument, handle: ViewHandle, mouse: Vector2) -> void:
	_document = document
	start = handle
	entry = handle.node.entry
	_offset = mouse - handle.position
	_before = document.scene.document
	_document.begin_gesture()


## With `keeps_height`, a freely moving handle keeps its height.
func move(camera: Camera3D, mouse: Vector2, snaps: bool, keeps_height: bool) -> void:
	if (
		not is_instance_valid(start.node)
		or not start.node.is_inside_tree()
		or not _document.scene.has_entry(entry)
	):
		return
	var space := start.node.global_transform
	var ray := ViewRay.new(camera, mouse - _offset, space)
	var pixel := (
		ViewScale.pixel(camera, space * (start.handle["position"] as Vector3))
		/ space.basis.x.length()
	)
	var step := ViewScale.coarse_step(pixel) if snaps else ViewScale.fine_step(pixel)
	var angle := ViewScale.COARSE_ANGLE if snaps else ViewScale.FINE_ANGLE
	_document.scene.drag_handle(
		entry,
		start.handle,
		ray.origin,
		ray.direction,
		Vector3.UP if keeps_height else ray.view,
		step,
		angle
	)


func end() -> void:
	_document.end_gesture("Drag %s of %s" % [start.key(), entry])


func cancel() -> void:
	_document.scene.document = _before
	end()
