extends "res://tests/framework/test_case.gd"
## The error that the multiplayer demo's HUD shows: the server's reference poses, the probe that
## samples them, and the gauge.

const ErrorGauge := preload("res://demos/multiplayer/measure/error_gauge.gd")
const PoseLink := preload("res://demos/multiplayer/replication/pose_link.gd")
const Truth := preload("res://demos/multiplayer/measure/truth.gd")
const TruthProbe := preload("res://demos/multiplayer/measure/truth_probe.gd")

const BODIES := 20


## Shows every body at its [method _pose] at a tick, plus an error.
class FakeLink:
	extends PoseLink

	var shown := 0.0
	var error := Vector3.ZERO
	var is_timed := true
	var make_pose: Callable

	func add_body(_id: int, _pose: Transform3D) -> void:
		pass

	func remove_body(_id: int) -> void:
		pass

	func add_receiver(_peer: int) -> void:
		pass

	func remove_receiver(_peer: int) -> void:
		pass

	func get_sent_tick() -> float:
		return NO_TICK

	func begin(_present_count: int) -> void:
		pass

	func end() -> void:
		pass

	func is_ready() -> bool:
		return true

	func get_shown_tick() -> float:
		return shown if is_timed else NO_TICK

	func get_delay() -> float:
		return 0.0

	func tune(_tolerance: float, _mode: MultivectorLerp.Mode) -> void:
		pass

	func get_counts() -> Dictionary[String, int]:
		return {}

	func show_tick(tick: float) -> void:
		shown = tick
		for id: int in bodies.size():
			var pose: Transform3D = make_pose.call(id, tick)
			bodies[id].transform = pose.translated(error)


func test_truth_survives_serialization() -> void:
	var truth := _probe_truth(30)
	var bytes := truth.to_bytes()
	expect_true(bytes.size() < 800, "the ground truth has %d bytes, less than 800" % bytes.size())
	var copy := Truth.from_bytes(bytes, BODIES)
	expect_equal(copy.tick, truth.tick, "tick")
	expect_equal(copy.ids, truth.ids, "numbers")
	for i: int in truth.ids.size():
		expect_transform_near(
			copy.get_pose(i, 1.5), _pose(truth.ids[i], 31.5), 1e-4, "pose between two ticks"
		)


func test_invalid_bytes_are_rejected() -> void:
	var bytes := _probe_truth(30).to_bytes()
	expect_null(Truth.from_bytes(bytes.slice(0, -1), BODIES), "ground truth of truncated bytes")
	expect_null(Truth.from_bytes(PackedByteArray(), BODIES), "ground truth of no bytes")
	bytes.encode_u16(Truth.HEADER, BODIES)
	expect_null(Truth.from_bytes(bytes, BODIES), "ground truth of a body that does not exist")


func test_probe_samples_distinct_moving_bodies_and_nothing_without_watchers() -> void:
	var truth := _probe_truth(45)
	expect_equal(truth.ids.size(), Truth.MAX_BODIES, "bodies")
	for i: int in truth.ids.size():
		expect_true(truth.ids[i] % 2 == 1, "body %d moving" % truth.ids[i])
		expect_equal(truth.ids.count(truth.ids[i]), 1, "occurrences of body %d" % truth.ids[i])
	var unwatched := TruthProbe.new()
	for tick: int in 60:
		expect_null(unwatched.observe(tick, _poses(tick)), "ground truth without watchers")


func test_gauge_measures_the_error_at_the_shown_time() -> void:
	var gauge := ErrorGauge.new()
	var link := _make_link()
	link.error = Vector3(0.003, 0.0, 0.0)
	gauge.take(_probe_truth(30), link)
	for frame: int in 60:
		link.show_tick(20.0 + frame * 0.7)
		gauge.update(link)
	expect_true(gauge.has_errors(), "errors")
	expect_near(gauge.get_statistics().x, 0.003, 1e-5, "median")
	expect_near(gauge.get_statistics().y, 0.003, 1e-5, "maximum")


func test_gauge_removes_the_constant_delay_of_an_untimed_link() -> void:
	var gauge := ErrorGauge.new()
	var link := _make_link()
	link.is_timed = false
	for tick: int in range(15, 300, 15):
		var truth := _probe_truth(tick)
		link.show_tick(tick + 1.0)
		gauge.take(truth, link)
	expect_near(
		gauge.get_statistics().y, 0.0, 1e-5, "maximum error of a link that is one tick behind"
	)


func test_gauge_holds_a_bounded_number_of_truths() -> void:
	var gauge := ErrorGauge.new()
	var link := _make_link()
	link.show_tick(0.0)
	for i: int in 100:
		gauge.take(_probe_truth(30), link)
	link.show_tick(31.0)
	gauge.update(link)
	expect_true(gauge.has_errors(), "errors relative to the latest ground truths")
	gauge.clear()
	expect_true(not gauge.has_errors(), "no errors after clear()")


func _make_link() -> FakeLink:
	var link := FakeLink.new()
	link.make_pose = _pose
	link.open(BODIES)
	add_node(link)
	return link


## The truth that a watched probe samples from a tick on.
func _probe_truth(tick: int) -> Truth:
	var probe := TruthProbe.new()
	probe.watchers.append(2)
	for i: int in TruthProbe.INTERVAL + Truth.TICKS:
		var now := tick - TruthProbe.INTERVAL + 1 + i
		var truth := probe.observe(now, _poses(now))
		if truth != null:
			return truth
	return null


func _poses(tick: int) -> Dictionary[int, Transform3D]:
	var poses: Dictionary[int, Transform3D] = {}
	for id: int in BODIES:
		poses[id] = _pose(id, tick)
	return poses


## Every second body moves and rotates at constant speed.
func _pose(id: int, tick: float) -> Transform3D:
	if id % 2 == 0:
		return Transform3D(Basis.IDENTITY, Vector3(id, 0.0, 0.0))
	return Transform3D(Basis(Vector3.UP, tick * 0.02), Vector3(id, tick * 0.05, 0.0))
