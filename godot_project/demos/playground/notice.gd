extends PanelContainer
## A message at the edge of the view that disappears after a few seconds.

const SECONDS := 6.0
const WIDTH := 380.0
const FADE_SECONDS := 0.4

var _label := Label.new()
var _fading: Tween


func _ready() -> void:
	_label.horizontal_alignment = HORIZONTAL_ALIGNMENT_CENTER
	_label.custom_minimum_size.x = WIDTH
	_label.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	add_child(_label)
	hide()


func show_text(text: String) -> void:
	_label.text = text
	modulate = Color.WHITE
	show()
	if _fading != null:
		_fading.kill()
	_fading = create_tween()
	_fading.tween_interval(SECONDS)
	_fading.tween_property(self, ^"modulate:a", 0.0, FADE_SECONDS)
	_fading.tween_callback(hide)


func get_text() -> String:
	return _label.text if visible else ""
