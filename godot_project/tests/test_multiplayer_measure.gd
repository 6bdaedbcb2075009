extends "res://tests/framework/test_case.gd"
## How the multiplayer demo's HUD measures its error: truths by bytes, the probe that takes them, the gauge.

const ErrorGauge := preload("res://demos/multiplayer/measure/error_gauge.gd")
const PoseLink := preload("res://demos/multiplayer/replication/pose_link.gd")
const Truth := preload("res://demos/multiplayer/measure/truth.gd")
const TruthProbe := preload("res://demos/multiplayer/measure/truth_probe.gd")

const BODIES := 20


## Shows every body where [method _pose] has it at a tick, moved by an error.
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


func test_a_truth_comes_back_from_its_bytes() -> void:
	var truth := _probe_truth(30)
	var bytes := truth.to_bytes()
	expect_true(bytes.size() < 800, "a truth of %d bytes" % bytes.size())
	var copy := Truth.from_bytes(bytes, BODIES)
	expect_equal(copy.tick, truth.tick, "tick")
	expect_equal(copy.ids, truth.ids, "numbers")
	for i: int in truth.ids.size():
		expect_transform_near(
			copy.get_pose(i, 1.5), _pose(truth.ids[i], 31.5), 1e-4, "pose between two ticks"
		)


func test_bytes_that_are_no_truth_are_refused() -> void:
	var bytes := _probe_truth(30).to_bytes()
	expect_null(Truth.from_bytes(bytes.slice(0, -1), BODIES), "one byte short")
	expect_null(Truth.from_bytes(PackedByteArray(), BODIES), "nothing")
	bytes.encode_u16(Truth.HEADER, BODIES)
	expect_null(Truth.from_bytes(bytes, BODIES), "a body that does not exist")


func test_a_probe_takes_different_moving_bodies_and_rests_unwatched() -> void:
	var truth := _probe_truth(45)
	expect_equal(truth.ids.size(), Truth.MAX_BODIES, "bodies")
	for i: int in truth.ids.size():
		expect_true(truth.ids[i] % 2 == 1, "body %d moving" % truth.ids[i])
		expect_equal(truth.ids.count(truth.ids[i]), 1, "times that body %d is told" % truth.ids[i])
	var unwatched := TruthProbe.new()
	for tick: int in 60:
		expect_null(unwatched.observe(tick, _poses(tick)), "truth for nobody")


func test_the_gauge_finds_the_error_at_the_shown_time() -> void:
	var gauge := ErrorGauge.new()
	var link := _make_link()
	link.error = Vector3(0.003, 0.0, 0.0)
	gauge.take(_probe_truth(30), link)
	for frame: int in 60:
		link.show_tick(20.0 + frame * 0.7)
		gauge.update(link)
	expect_true(gauge.has_errors(), "errors")
	expect_near(gauge.get_figures().x, 0.003, 1e-5, "median")
	expect_near(gauge.get_figures().y, 0.003, 1e-5, "largest")


func test_the_gauge_takes_the_constant_delay_from_an_untimed_link() -> void:
	var gauge := ErrorGauge.new()
	var link := _make_link()
	link.is_timed = false
	for tick: int in range(15, 300, 15):
		var truth := _probe_truth(tick)
		link.show_tick(tick + 1.0)
		gauge.take(truth, link)
	expect_near(gauge.get_figures().y, 0.0, 1e-5, "largest error of a link that is one tick behind")


func test_a_gauge_does_not_hold_truths_for_ever() -> void:
	var gauge := ErrorGauge.new()
	var link := _make_link()
	link.show_tick(0.0)
	for i: int in 100:
		gauge.take(_probe_truth(30), link)
	link.show_tick(31.0)
	gauge.update(link)
	expect_true(gauge.has_errors(), "errors of the last ones")
	gauge.clear()
	expect_true(not gauge.has_errors(), "nothing left after clear()")


func _make_link() -> FakeLink:
	var link := FakeLink.new()
	link.make_pose = _pose
	link.open(BODIES)
	add_node(link)
	return link


## The truth that a watched probe tells from a tick on.
func _probe_truth(tick: int) -> Truth:
	var probe := TruthProbe.new()
	probe.watchers.append(2)
	for i: int in TruthProbe.PAUSE + Truth.TICKS:
		var now := tick - TruthProbe.PAUSE + 1 + i
		var truth := probe.observe(now, _poses(now))
		if truth != null:
			return truth
	return null


func _poses(tick: int) -> Dictionary[int, Transform3D]:
	var poses: Dictionary[int, Transform3D] = {}
	for id: int in BODIES:
		poses[id] = _pose(id, tick)
	return poses


## Every second body moves evenly and turns.
func _pose(id: int, tick: float) -> Transform3D:
	if id % 2 == 0:
		return Transform3D(Basis.IDENTITY, Vector3(id, 0.0, 0.0))
	return Transform3D(Basis(Vector3.UP, tick * 0.02), Vector3(id, tick * 0.05, 0.0))
