@tool
extends "../chapter.gd"
## Quits the editor with unsaved changes; returning.gd is the next start.

const PLACE := "res://probe_left.tres"


func run() -> void:
	await begin_with(["A", "point(1, 2, 3)", "k", "2"])
	file_menu().call(&"save", PLACE)
	await settle()
	Hands.click(part("Objects/sphere"))
	await settle(2)
	Hands.click(row_part("A", "Eye"))
	await settle(2)
	expect(file_name().text, "probe_left.tres*", "name of the unsaved scene")
