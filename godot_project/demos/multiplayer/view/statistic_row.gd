extends HBoxContainer
## A row of statistics: a caption on the left, a value on the right.

var value := Label.new()


func _init(caption: String) -> void:
	var label := Label.new()
	label.text = caption
	label.theme_type_variation = &"CaptionLabel"
	label.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	add_child(label)
	add_child(value)
