@tool
extends "../chapter.gd"
## Prints how long changes take in a document of 200 entries, without limits.

const COUNT := 200
const TIMES := 20


func run() -> void:
	var entries: PackedStringArray = ["k", "1"]
	for index in COUNT - 1:
		match index % 4:
			0:
				entries.append_array(
					(
						["A%d" % index, "point(%d, 1, k)" % index]
						if index % 20 == 0
						else ["A%d" % index, "point(%d, 1, 2)" % index]
					)
				)
			1:
				entries.append_array(["s%d" % index, "sphere(A%d, 2)" % (index - 1)])
			2:
				entries.append_array(["p%d" % index, "plane(e2, %d)" % index])
			3:
				entries.append_array(["c%d" % index, "meet(s%d, p%d)" % [index - 2, index - 1]])
	await begin_with(entries)
	expect(names().size(), COUNT, "entries")
	await select(["k"])
	coefficients().expand()
	await _slide()
	await _type()
	await _add()
	coefficients().fold()


func _slide() -> void:
	var slider := row_part("k", "Slider") as HSlider
	var before := scene().document
	document().call(&"begin_gesture")
	await _measure(
		"a step of a dragged slider that 30 of 200 entries follow",
		func(step: int) -> void: slider.value = 1.0 + 0.1 * step
	)
	document().call(&"end_gesture", "Slide k")
	expect_true(scene().get_expression("k") != "1", "k after sliding")
	undo()
	expect(scene().document, before, "document after undoing it")


func _type() -> void:
	Hands.click(line())
	await _measure(
		"a letter typed in the line, of 200 entries",
		func(step: int) -> void: Hands.type(window(), "k+1"[step % 3] if step < 3 else "1")
	)
	line().clear()


func _add() -> void:
	await _measure(
		"an entry added to 200", func(_step: int) -> void: Hands.click(part("Objects/plane")), 5
	)
	for step in 5:
		undo()
	expect(names().size(), COUNT, "entries after undoing what was added")


## Prints medians, as the machine may be busy.
func _measure(what: String, act: Callable, times := TIMES) -> void:
	var acting: PackedInt64Array = []
	var whole: PackedInt64Array = []
	for step in times:
		await settle(1)
		var start := Time.get_ticks_usec()
		act.call(step)
		acting.append(Time.get_ticks_usec() - start)
		await settle(1)
		whole.append(Time.get_ticks_usec() - start)
	acting.sort()
	whole.sort()
	print(
		(
			"[probe] %s: %.2f ms, with the frame that follows %.2f ms"
			% [what, acting[times / 2] / 1000.0, whole[times / 2] / 1000.0]
		)
	)
