@tool
extends "../chapter.gd"
## The editor is left with a scene that was changed and not saved; returning.gd is what comes after
## that.

const PLACE := "res://probe_left.tres"


func read() -> void:
	await begin_with(["A", "point(1, 2, 3)", "k", "2"])
	file_menu().call(&"save", PLACE)
	await settle()
	Hands.click(part("Objects/sphere"))
	await settle(2)
	Hands.click(row_part("A", "Eye"))
	await settle(2)
	expect(file_name().text, "probe_left.tres*", "name of what is left unsaved")
