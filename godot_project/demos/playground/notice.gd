extends PanelContainer
## Words that a person should read, for some seconds at the edge of the view.

const SECONDS := 6.0
const WIDTH := 380.0
const FADE_SECONDS := 0.4

var _words := Label.new()
var _fading: Tween


func _ready() -> void:
	_words.horizontal_alignment = HORIZONTAL_ALIGNMENT_CENTER
	_words.custom_minimum_size.x = WIDTH
	_words.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	add_child(_words)
	hide()


func tell(words: String) -> void:
	_words.text = words
	modulate = Color.WHITE
	show()
	if _fading != null:
		_fading.kill()
	_fading = create_tween()
	_fading.tween_interval(SECONDS)
	_fading.tween_property(self, ^"modulate:a", 0.0, FADE_SECONDS)
	_fading.tween_callback(hide)


func get_words() -> String:
	return _words.text if visible else ""
