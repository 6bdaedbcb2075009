@tool
extends RefCounted
## Converts between pixels and lengths in the scene.

const PlaygroundStyle := preload("../theme/playground_style.gd")

## The pick radius of the mouse, in pixels.
const PICK_RADIUS := 9.0
## The minimum spacing of the snapping grid, in pixels.
const MIN_GRID_SPACING := 3.0
const COARSE_ANGLE := deg_to_rad(15.0)
const FINE_ANGLE := deg_to_rad(0.1)


## The size of a pixel in meters, at the depth of a position.
static func pixel(camera: Camera3D, position: Vector3) -> float:
	var depth := maxf(-(camera.global_transform.affine_inverse() * position).z, camera.near)
	var middle := Vector2(camera.get_viewport().get_visible_rect().size) / 2.0
	return camera.project_position(middle, depth).distance_to(
		camera.project_position(middle + Vector2.RIGHT, depth)
	)


## The largest power of ten that is at most the size of a pixel, so that dragged numbers have no
## more digits than are visible.
static func fine_step(pixel_size: float) -> float:
	return pow(10.0, floorf(log(maxf(pixel_size, 1e-9)) / log(10.0)))


## The smallest power of ten that is at least MIN_GRID_SPACING pixels, for snapping.
static func coarse_step(pixel_size: float) -> float:
	return pow(10.0, ceilf(log(maxf(pixel_size * MIN_GRID_SPACING, 1e-9)) / log(10.0)))


## The length of `pixels` pixels, rounded down to 1, 2 or 5 times a power of ten.
static func round_length(pixel_size: float, pixels: float) -> float:
	var length := maxf(pixel_size * pixels, 1e-9)
	var power := pow(10.0, floorf(log(length) / log(10.0)))
	for multiple: float in [5.0, 2.0]:
		if length >= multiple * power:
			return multiple * power
	return power
