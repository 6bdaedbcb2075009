extends RefCounted
## Start pose and color of each cube, the same on the server and on all clients. Scene "cubes": a
## round tower, a wall, a pyramid and a cloud of falling cubes, repeated for every 250 cubes. Scene
## "push": a field of cubes on the floor. Scene "avatars" has no cubes.

## Edge of a cube, in meters.
const EDGE := 0.5
const SET_SIZE := 250
const SET_SPACING := 17.0
const PITCH := EDGE * 1.04

const TOWER_RING := 16
const WALL_WIDTH := 14
const FIELD_PITCH := 0.8
## Half the side of the arena of the avatars, in meters.
const AVATAR_HALF_EXTENT := 3.4
## Shares of a set; the rest forms the cloud.
const TOWER_SHARE := 0.38
const WALL_SHARE := 0.25
const PYRAMID_SHARE := 0.22

const TOWER_COLORS: Array[Color] = [Color("1f7a8c"), Color("3ec6b8")]
const WALL_COLORS: Array[Color] = [Color("d9622b"), Color("ffb454")]
const PYRAMID_COLORS: Array[Color] = [Color("b23a6b"), Color("f28ba8")]
const CLOUD_COLORS: Array[Color] = [Color("e9e4d8"), Color("f7f5ef")]
const FIELD_COLORS: Array[Color] = [Color("ffcf5c"), Color("f2545b"), Color("7b5cf0")]

var poses: Array[Transform3D] = []
var colors := PackedColorArray()
## Half the side of the square arena, in meters.
var half_extent := 0.0


func _init(scene: String, count: int) -> void:
	if scene == "push":
		_add_field(count)
	elif scene == "avatars":
		half_extent = AVATAR_HALF_EXTENT
	else:
		_add_sets(count)


func _add_sets(count: int) -> void:
	var sets := ceili(count / float(SET_SIZE))
	var columns := ceili(sqrt(sets))
	half_extent = 11.0 + SET_SPACING * 0.5 * (columns - 1)
	for i: int in sets:
		var column := i % columns - (columns - 1) * 0.5
		var row := floorf(i / float(columns)) - (ceilf(sets / float(columns)) - 1.0) * 0.5
		_add_set(Vector3(column, 0.0, row) * SET_SPACING, mini(SET_SIZE, count - i * SET_SIZE))


func _add_field(count: int) -> void:
	var side := ceili(sqrt(count))
	var half_side := (side - 1) * 0.5
	half_extent = maxf(11.0, half_side * FIELD_PITCH + 4.0)
	for i: int in count:
		var cell := Vector3(i % side - half_side, 0.0, floorf(i / float(side)) - half_side)
		var weight := cell.length() / maxf(half_side * sqrt(2.0), 1.0)
		_add(
			Transform3D(Basis.IDENTITY, cell * FIELD_PITCH + Vector3(0.0, EDGE * 0.5, 0.0)),
			FIELD_COLORS,
			weight
		)


func _add_set(center: Vector3, count: int) -> void:
	var tower := roundi(count * TOWER_SHARE)
	var wall := roundi(count * WALL_SHARE)
	var pyramid := roundi(count * PYRAMID_SHARE)
	_add_tower(center + Vector3(-4.2, 0.0, -1.4), tower)
	_add_wall(center + Vector3(3.6, 0.0, -3.4), wall)
	_add_pyramid(center + Vector3(1.6, 0.0, 3.6), pyramid)
	_add_cloud(center, count - tower - wall - pyramid)


func _add_tower(base: Vector3, count: int) -> void:
	var radius := TOWER_RING * PITCH * 1.03 / TAU
	var layers := ceili(count / float(TOWER_RING))
	for i: int in count:
		var layer := floori(i / float(TOWER_RING))
		var angle := TAU * (i % TOWER_RING + 0.5 * (layer % 2)) / TOWER_RING
		var position := (
			base + Vector3(cos(angle) * radius, EDGE * (layer + 0.5), sin(angle) * radius)
		)
		_add(
			Transform3D(Basis(Vector3.UP, -angle), position),
			TOWER_COLORS,
			layer / maxf(layers - 1, 1)
		)


func _add_wall(base: Vector3, count: int) -> void:
	var layers := ceili(count / float(WALL_WIDTH))
	var rotation := Basis(Vector3.UP, -0.5)
	for i: int in count:
		var layer := floori(i / float(WALL_WIDTH))
		var along := (i % WALL_WIDTH - WALL_WIDTH * 0.5 + 0.5 * (layer % 2)) * PITCH
		var position := base + rotation * Vector3(along, EDGE * (layer + 0.5), 0.0)
		_add(Transform3D(rotation, position), WALL_COLORS, layer / maxf(layers - 1, 1))


func _add_pyramid(base: Vector3, count: int) -> void:
	var side := 1
	while side * (side + 1) * (2 * side + 1) < 6 * count:
		side += 1
	var rotation := Basis(Vector3.UP, 0.35)
	var rows := side
	var layer := 0
	var remaining := count
	while remaining > 0:
		for i: int in mini(remaining, rows * rows):
			var cell := (
				Vector3(i % rows, 0.0, floorf(i / float(rows)))
				- Vector3(rows - 1, 0.0, rows - 1) * 0.5
			)
			var position := (
				base + rotation * (cell * PITCH) + Vector3(0.0, EDGE * (layer + 0.5), 0.0)
			)
			_add(Transform3D(rotation, position), PYRAMID_COLORS, layer / maxf(side - 1, 1))
		remaining -= mini(remaining, rows * rows)
		rows = maxi(rows - 1, 1)
		layer += 1


func _add_cloud(base: Vector3, count: int) -> void:
	for i: int in count:
		# A sunflower spiral, and a different axis for each cube.
		var angle := i * 2.39996
		var distance := 0.9 * sqrt(i + 0.5)
		var position := base + Vector3(cos(angle) * distance, 5.0 + 0.12 * i, sin(angle) * distance)
		var axis := Vector3(sin(i * 1.7), cos(i * 2.3), sin(i * 0.9 + 1.0)).normalized()
		_add(Transform3D(Basis(axis, i * 0.8), position), CLOUD_COLORS, i / maxf(count - 1, 1))


func _add(pose: Transform3D, stops: Array[Color], weight: float) -> void:
	poses.append(pose)
	# Small differences in brightness make the cubes of a structure distinguishable.
	var shade := 0.06 * sin(poses.size() * 12.9898)
	var along := clampf(weight, 0.0, 1.0) * (stops.size() - 1)
	var stop := mini(floori(along), stops.size() - 2)
	var color := stops[stop].lerp(stops[stop + 1], along - stop)
	colors.append(color.lightened(shade) if shade > 0.0 else color.darkened(-shade))
