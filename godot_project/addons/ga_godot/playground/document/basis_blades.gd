@tool
extends RefCounted
## The 32 basis blades by grade, in the basis with e4 and e5 or in the null basis with eo and
## einf.

const NAMES: PackedStringArray = [
	"1",
	"e1",
	"e2",
	"e3",
	"e4",
	"e5",
	"e12",
	"e13",
	"e14",
	"e15",
	"e23",
	"e24",
	"e25",
	"e34",
	"e35",
	"e45",
	"e123",
	"e124",
	"e125",
	"e134",
	"e135",
	"e145",
	"e234",
	"e235",
	"e245",
	"e345",
	"e1234",
	"e1235",
	"e1245",
	"e1345",
	"e2345",
	"e12345",
]
## Index of the first blade of each grade, then the number of blades.
const GRADES: PackedInt32Array = [0, 1, 6, 16, 26, 31, 32]
const GRADE_TITLES: PackedStringArray = [
	"Scalar", "Vectors", "Bivectors", "Trivectors", "Quadvectors", "Pseudoscalar"
]


## The name at an index. In the null basis, einf takes the index of e4 and eo that of e5.
static func name_of(index: int, null_basis: bool) -> String:
	if not null_basis or has_both(index) or not (_has(index, "4") or _has(index, "5")):
		return NAMES[index]
	var rest := NAMES[index].left(-1)
	var last := "∞" if _has(index, "4") else "o"
	return "e" + rest.trim_prefix("e") + last


## Converts coefficients from the standard basis, if `null_basis` is set, by
## e4 = einf / 2 - eo and e5 = einf / 2 + eo. e45 is the same in both.
static func from_standard(coefficients: PackedFloat64Array, null_basis: bool) -> PackedFloat64Array:
	var result := coefficients.duplicate()
	if null_basis:
		for index in NAMES.size():
			var partner := partner_of(index)
			if partner > index:
				result[index] = (coefficients[index] + coefficients[partner]) / 2.0
				result[partner] = coefficients[partner] - coefficients[index]
	return result


## The inverse of from_standard(): einf = e4 + e5, eo = (e5 - e4) / 2.
static func to_standard(coefficients: PackedFloat64Array, null_basis: bool) -> PackedFloat64Array:
	var result := coefficients.duplicate()
	if null_basis:
		for index in NAMES.size():
			var partner := partner_of(index)
			if partner > index:
				result[index] = coefficients[index] - coefficients[partner] / 2.0
				result[partner] = coefficients[index] + coefficients[partner] / 2.0
	return result


## For a blade with e4 but not e5, the index of the blade with e5 in its place; otherwise -1.
static func partner_of(index: int) -> int:
	return (
		NAMES.find(NAMES[index].replace("4", "5"))
		if _has(index, "4") and not has_both(index)
		else -1
	)


static func has_both(index: int) -> bool:
	return _has(index, "4") and _has(index, "5")


static func _has(index: int, digit: String) -> bool:
	return NAMES[index].contains(digit)
