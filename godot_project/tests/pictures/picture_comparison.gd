extends RefCounted
## Compares two pictures. Averages over 4 x 4 pixels first, so that objects that moved or vanished
## are detected, but not the rounding of another driver at the edges of triangles and letters.

const PictureComparison := preload("res://tests/pictures/picture_comparison.gd")

## Number of times that averaging halves the size.
const HALVINGS := 2
## Minimum difference in any channel that counts as visible, of 255.
const VISIBLE_DIFFERENCE := 20
## Largest share of averaged pixels that may differ visibly, and largest mean difference of 255.
const ALLOWED_SHARE := 0.0015
const ALLOWED_MEAN := 0.5

## Share of the averaged pixels that differ visibly.
var share := 1.0
## Mean difference over all averaged pixels and channels, of 255.
var mean := 255.0
## Why the pictures cannot be compared, or empty.
var obstacle := ""


static func compare(actual: Image, expected: Image) -> PictureComparison:
	var result := PictureComparison.new()
	if actual.get_size() != expected.get_size():
		result.obstacle = "the size is %s, expected %s" % [actual.get_size(), expected.get_size()]
		return result
	var first := _average(actual)
	var second := _average(expected)
	var sum := 0
	var visible := 0
	for pixel in range(0, first.size(), 3):
		var worst := 0
		for channel in 3:
			var difference := absi(first[pixel + channel] - second[pixel + channel])
			sum += difference
			worst = maxi(worst, difference)
		if worst > VISIBLE_DIFFERENCE:
			visible += 1
	result.share = visible * 3.0 / first.size()
	result.mean = float(sum) / first.size()
	return result


func is_alike() -> bool:
	return obstacle.is_empty() and share <= ALLOWED_SHARE and mean <= ALLOWED_MEAN


func describe() -> String:
	if not obstacle.is_empty():
		return obstacle
	return (
		"%.3f%% of the picture differs (allowed %.3f), mean difference %.3f (allowed %.3f)"
		% [100.0 * share, 100.0 * ALLOWED_SHARE, mean, ALLOWED_MEAN]
	)


static func _average(picture: Image) -> PackedByteArray:
	var copy: Image = picture.duplicate()
	copy.convert(Image.FORMAT_RGB8)
	for i in HALVINGS:
		copy.shrink_x2()
	return copy.get_data()
