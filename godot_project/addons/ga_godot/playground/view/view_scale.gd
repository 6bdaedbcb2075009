@tool
extends RefCounted
## Converts between pixels and lengths in the scene.

const PlaygroundStyle := preload("../theme/playground_style.gd")

## The pick radius of the mouse, in pixels.
const REACH := 9.0
## The minimum spacing of the snapping grid, in pixels.
const GRID := 3.0
const COARSE_ANGLE := deg_to_rad(15.0)
const FINE_ANGLE := deg_to_rad(0.1)


## The size of a pixel in meters, at the depth of a place.
static func pixel(camera: Camera3D, place: Vector3) -> float:
	var depth := maxf(-(camera.global_transform.affine_inverse() * place).z, camera.near)
	var middle := Vector2(camera.get_viewport().get_visible_rect().size) / 2.0
	return camera.project_position(middle, depth).distance_to(
		camera.project_position(middle + Vector2.RIGHT, depth)
	)


## A power of ten below a pixel, so that dragged numbers have no more digits than are visible.
static func fine_step(of_pixel: float) -> float:
	return pow(10.0, floorf(log(maxf(of_pixel, 1e-9)) / log(10.0)))


## A power of ten of at least GRID pixels, for snapping.
static func coarse_step(of_pixel: float) -> float:
	return pow(10.0, ceilf(log(maxf(of_pixel * GRID, 1e-9)) / log(10.0)))


## 1, 2 or 5 times a power of ten, about as long as that many pixels.
static func round_length(of_pixel: float, pixels: float) -> float:
	var length := maxf(of_pixel * pixels, 1e-9)
	var power := pow(10.0, floorf(log(length) / log(10.0)))
	for times: float in [5.0, 2.0]:
		if length >= times * power:
			return times * power
	return power
