extends RefCounted
## The colors of the demo.

const SKY_TOP := Color("10131c")
const SKY_HORIZON := Color("2c3650")
const FLOOR := Color("161a23")
const KEY_LIGHT := Color("ffe6c4")
const RIM_LIGHT := Color("7fa8ff")
const ACCENT := Color("3ed6c4")
## Colors of the replication methods.
const METHODS: Dictionary[String, Color] = {
	"motors": Color("3ed6c4"), "synchronizer": Color("ff9e6b")
}
const LIFT := Color("ffb454")
const ROLLER := Color("ff7a3d")
const PLAYERS: Array[Color] = [
	Color("ffd23f"),
	Color("4cc9f0"),
	Color("b8f35d"),
	Color("c792ff"),
	Color("ff6b8b"),
	Color("5eead4"),
	Color("f4f1de"),
	Color("f4a261"),
]


## Color of the ball in a slot; slot 0 is the scripted ball.
static func get_player_color(slot: int) -> Color:
	return ROLLER if slot == 0 else PLAYERS[(slot - 1) % PLAYERS.size()]
