@tool
extends RefCounted
## A handle as seen by a camera.

const ViewRay := preload("view_ray.gd")
const ViewScale := preload("view_scale.gd")

## Length of arms, in pixels.
const ARM := 60.0

## The node that draws the object. The handle is in its local space.
var node: GANode3D
## A dictionary from GAScene.get_handles().
var handle: Dictionary
## Screen positions of the handle and of the start of the line to it.
var position: Vector2
var stem: Vector2
## Whether the handle is in front of the camera.
var is_visible: bool


func _init(p_node: GANode3D, p_handle: Dictionary, camera: Camera3D) -> void:
	node = p_node
	handle = p_handle
	var space := node.global_transform
	var from: Vector3 = handle["stem"]
	if handle["is_arm"]:
		var length := (
			ARM
			* ViewScale.PlaygroundStyle.scale()
			* ViewScale.pixel(camera, space * from)
			/ space.basis.x.length()
		)
		handle["position"] = from + (handle["position"] as Vector3 - from) * length
	var world_position := space * (handle["position"] as Vector3)
	is_visible = not camera.is_position_behind(world_position)
	if is_visible:
		position = camera.unproject_position(world_position)
		stem = (
			position
			if camera.is_position_behind(space * from)
			else camera.unproject_position(space * from)
		)


func key() -> String:
	return handle["key"]


func is_same(other: RefCounted) -> bool:
	return (
		other != null
		and other.get(&"node") == node
		and (other.get(&"handle") as Dictionary)["key"] == handle["key"]
	)


## The handles of the entry that a node draws; none if it is hidden.
static func of(of_node: GANode3D, camera: Camera3D) -> Array[RefCounted]:
	var found: Array[RefCounted] = []
	var scene := of_node.scene
	if (
		scene == null
		or not scene.has_entry(of_node.entry)
		or not scene.get_entry_attribute(of_node.entry, "visible")
	):
		return found
	if not of_node.is_visible_in_tree() or ViewRay.is_degenerate(of_node.global_transform):
		return found
	var right := of_node.global_transform.affine_inverse().basis * camera.global_basis.x
	for each in scene.get_handles(of_node.entry, right):
		found.append(new(of_node, each, camera))
	return found
