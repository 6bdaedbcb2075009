extends "res://tests/framework/test_case.gd"
## Multivector: construction, products, involutions and duals. The expected values were derived by
## hand from e1..e4 squaring to +1 and e5 to -1.

const E1 := 1
const E2 := 2
const E4 := 4
const E5 := 5
const E12 := 6
const E23 := 10
const E45 := 15
const E123 := 16
const E1234 := 26
const E2345 := 30
const PSEUDOSCALAR := 31


func test_a_new_multivector_is_zero() -> void:
	expect_coefficients(Multivector.new(), {})


func test_scalar() -> void:
	expect_coefficients(Multivector.scalar(-2.5), {0: -2.5})


func test_each_basis_blade_by_index() -> void:
	for index in 32:
		expect_coefficients(Multivector.basis_blade(index), {index: 1.0})


func test_basis_by_name() -> void:
	expect_coefficients(Multivector.basis("e1"), {E1: 1.0})
	expect_coefficients(Multivector.basis("e12"), {E12: 1.0})
	expect_coefficients(Multivector.basis("e2345"), {E2345: 1.0})
	expect_coefficients(Multivector.basis("I"), {PSEUDOSCALAR: 1.0})
	expect_coefficients(Multivector.basis("eo"), {E4: -0.5, E5: 0.5})
	expect_coefficients(Multivector.basis("einf"), {E4: 1.0, E5: 1.0})


func test_basis_rejects_unknown_names_and_indices() -> void:
	expect_error(
		(
			'Multivector.basis: "e6" is not a basis element; valid names are like "1", '
			+ '"e3", "e12", "eo", "einf", "E", "I".'
		)
	)
	expect_null(Multivector.basis("e6"))
	expect_error("Multivector.basis_blade: index 32 is not in 0..31.")
	expect_null(Multivector.basis_blade(32))
	expect_error("Multivector.basis_blade: index -1 is not in 0..31.")
	expect_null(Multivector.basis_blade(-1))


func test_scalar_rejects_nan() -> void:
	expect_error("Multivector.scalar: the value is not finite.")
	expect_null(Multivector.scalar(NAN))


func test_setting_coefficients_emits_changed() -> void:
	var multivector := Multivector.new()
	var changes: Array[int] = []
	multivector.changed.connect(changes.append.bind(1))
	var numbers := PackedFloat64Array()
	for i in 32:
		numbers.append(i * 0.25 - 3.0)
	multivector.coefficients = numbers
	expect_equal(multivector.coefficients, numbers)
	expect_equal(changes.size(), 1, "number of changed signals")


func test_invalid_coefficients_change_nothing() -> void:
	var multivector := Multivector.basis("e12")
	expect_error(
		(
			"Multivector: coefficients must have 32 numbers, not 31, in the order 1, e1 .. "
			+ "e5, e12 .. e45, e123 .. e345, e1234 .. e2345, e12345."
		)
	)
	var numbers := PackedFloat64Array()
	numbers.resize(31)
	multivector.coefficients = numbers
	expect_coefficients(multivector, {E12: 1.0})
	numbers.resize(32)
	numbers[7] = INF
	expect_error("Multivector: coefficient 7 is not finite; the multivector is unchanged.")
	multivector.coefficients = numbers
	expect_coefficients(multivector, {E12: 1.0})


func test_a_saved_resource_keeps_its_coefficients() -> void:
	var saved := Multivector.motor_from(Vector3(1, -2, 3), Quaternion(0.1, 0.2, 0.3, 0.9), 1.7)
	# The text format rounds to the second to last digit; the binary format keeps every bit.
	var tolerances: Dictionary[String, float] = {"tres": 1e-15, "res": 0.0}
	for extension: String in tolerances:
		var path := "user://multivector_test.%s" % extension
		expect_equal(ResourceSaver.save(saved, path), OK)
		var loaded: Multivector = ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)
		for i in 32:
			expect_near(
				loaded.coefficients[i],
				saved.coefficients[i],
				tolerances[extension],
				"coefficient %d of %s" % [i, path]
			)
		DirAccess.remove_absolute(path)


func test_sums_and_multiples() -> void:
	var a := Multivector.basis("e1").scaled(2.0)
	var b := Multivector.basis("e23")
	expect_coefficients(a.add(b), {E1: 2.0, E23: 1.0})
	expect_coefficients(a.subtract(b), {E1: 2.0, E23: -1.0})
	expect_coefficients(a, {E1: 2.0}, 0.0, "the operand")


func test_geometric_product() -> void:
	expect_coefficients(_product("e1", "e1"), {0: 1.0})
	expect_coefficients(_product("e5", "e5"), {0: -1.0})
	expect_coefficients(_product("e1", "e2"), {E12: 1.0})
	expect_coefficients(_product("e2", "e1"), {E12: -1.0})
	expect_coefficients(_product("e45", "e45"), {0: 1.0})
	expect_coefficients(_product("I", "I"), {0: -1.0})
	expect_coefficients(_product("e12", "e23"), {7: 1.0})
	expect_coefficients(_product("einf", "einf"), {})


func test_outer_product() -> void:
	var e1 := Multivector.basis("e1")
	expect_coefficients(e1.outer_product(Multivector.basis("e23")), {E123: 1.0})
	expect_coefficients(e1.outer_product(Multivector.basis("e12")), {})
	expect_coefficients(
		Multivector.basis("einf").outer_product(Multivector.basis("eo")), {E45: 1.0}
	)


func test_inner_product_is_the_fat_dot() -> void:
	expect_coefficients(Multivector.basis("eo").inner_product(Multivector.basis("einf")), {0: -1.0})
	expect_coefficients(Multivector.scalar(2.0).inner_product(Multivector.basis("e1")), {E1: 2.0})
	expect_coefficients(Multivector.basis("e12").inner_product(Multivector.basis("e1")), {E2: -1.0})


func test_contractions() -> void:
	var e1 := Multivector.basis("e1")
	var e12 := Multivector.basis("e12")
	expect_coefficients(e1.left_contraction(e12), {E2: 1.0})
	expect_coefficients(e12.left_contraction(e1), {})
	expect_coefficients(e12.right_contraction(e1), {E2: -1.0})
	expect_coefficients(e1.right_contraction(e12), {})


func test_regressive_product() -> void:
	# undual(dual(A) ^ dual(B)). For blades that span the whole space together, this is their meet.
	expect_coefficients(_regressive("I", "e12"), {E12: 1.0})
	expect_coefficients(_regressive("e1234", "e2345"), {22: -1.0})
	expect_coefficients(_regressive("e12", "e23"), {})


func test_commutator_product() -> void:
	expect_coefficients(
		Multivector.basis("e12").commutator_product(Multivector.basis("e23")), {7: 1.0}
	)
	expect_coefficients(Multivector.basis("e12").commutator_product(Multivector.basis("e45")), {})
	expect_coefficients(
		Multivector.basis("e1").commutator_product(Multivector.basis("e2")), {E12: 1.0}
	)


func test_scalar_product() -> void:
	expect_near(Multivector.basis("eo").scalar_product(Multivector.basis("einf")), -1.0, 0.0)
	expect_near(Multivector.basis("e1").scalar_product(Multivector.basis("e2")), 0.0, 0.0)


func test_products_reject_null() -> void:
	var e1 := Multivector.basis("e1")
	for method: String in [
		"add",
		"subtract",
		"geometric_product",
		"outer_product",
		"inner_product",
		"left_contraction",
		"right_contraction",
		"regressive_product",
		"commutator_product"
	]:
		expect_error("Multivector.%s: the other multivector is null." % method)
		var result: Multivector = e1.call(method, null)
		expect_null(result, method)
	expect_error("Multivector.scalar_product: the other multivector is null.")
	expect_equal(e1.scalar_product(null), 0.0)
	expect_error("Multivector.is_equal_approx: the other multivector is null.")
	expect_equal(e1.is_equal_approx(null), false)
	expect_error("Multivector.sandwich: the multivector to transform is null.")
	expect_null(e1.sandwich(null))


func test_results_out_of_range_are_errors() -> void:
	var huge := Multivector.scalar(1e200)
	expect_error(
		(
			"Multivector: a coefficient of the result is beyond the range of 64-bit "
			+ "floats; scale the operands down first."
		)
	)
	expect_null(huge.geometric_product(huge))
	expect_error("Multivector.scaled: the factor is not finite.")
	expect_null(huge.scaled(INF))


func test_involutions() -> void:
	# A blade of each grade; its signs under reverse, grade involution and Clifford conjugate.
	var expected: Dictionary[int, Vector3] = {
		0: Vector3(1, 1, 1),
		E1: Vector3(1, -1, -1),
		E12: Vector3(-1, 1, -1),
		E123: Vector3(-1, -1, 1),
		E1234: Vector3(1, 1, 1),
		PSEUDOSCALAR: Vector3(1, -1, -1),
	}
	for index: int in expected:
		var blade := Multivector.basis_blade(index)
		expect_coefficients(
			blade.reverse(), {index: expected[index].x}, 0.0, "reverse of blade %d" % index
		)
		expect_coefficients(
			blade.grade_involution(),
			{index: expected[index].y},
			0.0,
			"grade involution of blade %d" % index
		)
		expect_coefficients(
			blade.clifford_conjugate(),
			{index: expected[index].z},
			0.0,
			"conjugate of blade %d" % index
		)


func test_dual_and_undual() -> void:
	expect_coefficients(Multivector.scalar(1.0).dual(), {PSEUDOSCALAR: -1.0})
	expect_coefficients(Multivector.scalar(1.0).undual(), {PSEUDOSCALAR: 1.0})
	expect_coefficients(Multivector.basis("e1").dual(), {E2345: -1.0})
	expect_coefficients(Multivector.basis("I").dual(), {0: 1.0})
	for index in 32:
		expect_coefficients(Multivector.basis_blade(index).dual().undual(), {index: 1.0})


func test_grade() -> void:
	var mixed := Multivector.scalar(3.0).add(Multivector.basis("e1")).add(Multivector.basis("e12"))
	expect_coefficients(mixed.grade(0), {0: 3.0})
	expect_coefficients(mixed.grade(1), {E1: 1.0})
	expect_coefficients(mixed.grade(2), {E12: 1.0})
	expect_coefficients(mixed.grade(5), {})
	expect_error("Multivector.grade: grade 6 is not in 0..5.")
	expect_null(mixed.grade(6))


func test_is_equal_approx() -> void:
	var e1 := Multivector.basis("e1")
	expect_true(e1.is_equal_approx(e1.scaled(1.0 + 1e-12)), "equality within rounding")
	expect_true(not e1.is_equal_approx(e1.scaled(1.0 + 1e-6)), "difference of a millionth")
	expect_true(not e1.is_equal_approx(Multivector.basis("e2")), "difference of e1 and e2")


func _regressive(left: String, right: String) -> Multivector:
	return Multivector.basis(left).regressive_product(Multivector.basis(right))


func _product(left: String, right: String) -> Multivector:
	return Multivector.basis(left).geometric_product(Multivector.basis(right))
