// n products of multivectors with 32 coefficients, compared with straightforward loops, and of motors and typed elements, whose
// zero coefficients are known at compile time.

#include "kernel_input.hpp"

#include "cga/algebra/complex_matrix.hpp"
#include "cga/algebra/multivector.hpp"
#include "cga/algebra/product_table.hpp"
#include "cga/motor/motor.hpp"
#include "cga/typed/objects.hpp"

namespace kernels_bench {

namespace {

using cga::BLADE_COUNT;
using cga::Multivector;

constexpr size_t DISTINCT = 64; // stays in cache

std::vector<Multivector> random_multivectors() {
	std::mt19937 random(2027);
	std::normal_distribution<double> normal;
	std::vector<Multivector> made(DISTINCT);
	for (Multivector &x : made) {
		for (int index = 0; index < BLADE_COUNT; ++index) {
			x[index] = normal(random);
		}
	}
	return made;
}

// 32 x 32 x 32: the matrix of the left factor, which most libraries without code generation build or keep.
struct DenseLoop {
	std::vector<double> signs = std::vector<double>(size_t(BLADE_COUNT * BLADE_COUNT * BLADE_COUNT));

	DenseLoop() {
		for (int left = 0; left < BLADE_COUNT; ++left) {
			for (int right = 0; right < BLADE_COUNT; ++right) {
				const unsigned bitmap = unsigned(cga::BLADE_BITMAPS[size_t(left)] ^ cga::BLADE_BITMAPS[size_t(right)]);
				signs[(size_t(cga::BLADE_INDICES[bitmap]) * BLADE_COUNT + size_t(left)) * BLADE_COUNT + size_t(right)] = cga::product_sign(cga::BLADE_BITMAPS[size_t(left)], cga::BLADE_BITMAPS[size_t(right)]);
			}
		}
	}

	Multivector operator()(const Multivector &a, const Multivector &b) const {
		Multivector product;
		for (int result = 0; result < BLADE_COUNT; ++result) {
			for (int left = 0; left < BLADE_COUNT; ++left) {
				for (int right = 0; right < BLADE_COUNT; ++right) {
					product[result] += signs[(size_t(result) * BLADE_COUNT + size_t(left)) * BLADE_COUNT + size_t(right)] * a[left] * b[right];
				}
			}
		}
		return product;
	}
};

// 32 x 32 with a table of signs and results.
struct TableLoop {
	int results[BLADE_COUNT][BLADE_COUNT];
	double signs[BLADE_COUNT][BLADE_COUNT];

	TableLoop() {
		for (size_t left = 0; left < size_t(BLADE_COUNT); ++left) {
			for (size_t right = 0; right < size_t(BLADE_COUNT); ++right) {
				results[left][right] = cga::BLADE_INDICES[unsigned(cga::BLADE_BITMAPS[left] ^ cga::BLADE_BITMAPS[right])];
				signs[left][right] = cga::product_sign(cga::BLADE_BITMAPS[left], cga::BLADE_BITMAPS[right]);
			}
		}
	}

	Multivector operator()(const Multivector &a, const Multivector &b) const {
		Multivector product;
		for (int left = 0; left < BLADE_COUNT; ++left) {
			for (int right = 0; right < BLADE_COUNT; ++right) {
				product[results[left][right]] += signs[left][right] * a[left] * b[right];
			}
		}
		return product;
	}
};

struct Ours {
	Multivector operator()(const Multivector &a, const Multivector &b) const { return a.geometric_product(b); }
};

// As 4 x 4 complex matrices, to which the algebra is isomorphic.
struct ComplexMatrices {
	Multivector operator()(const Multivector &a, const Multivector &b) const {
		const cga::ComplexMatrix left = cga::to_matrix(a), right = cga::to_matrix(b);
		cga::ComplexMatrix product{};
		for (size_t row = 0; row < 4; ++row) {
			for (size_t middle = 0; middle < 4; ++middle) {
				for (size_t column = 0; column < 4; ++column) {
					// Written out: std::complex would check for infinities.
					const std::complex<double> l = left[row][middle], r = right[middle][column];
					product[row][column] += std::complex<double>(l.real() * r.real() - l.imag() * r.imag(), l.real() * r.imag() + l.imag() * r.real());
				}
			}
		}
		return cga::from_matrix(product);
	}
};

template <class Subject>
void multiply_each(benchmark::State &state) {
	const size_t count = size_t(state.range(0));
	const std::vector<Multivector> factors = random_multivectors();
	const Subject subject;
	measure(state, count, 3 * sizeof(Multivector), [&] {
		for (size_t i = 0; i < count; ++i) {
			Multivector product = subject(factors[i % DISTINCT], factors[(i + 7) % DISTINCT]);
			benchmark::DoNotOptimize(product);
		}
	});
}

void multiply_motors(benchmark::State &state) {
	const size_t count = size_t(state.range(0));
	PoseSource source;
	std::vector<cga::Motor<double>> motors;
	motors.reserve(DISTINCT);
	for (size_t i = 0; i < DISTINCT; ++i) {
		motors.push_back(cga::Motor<double>::from_pose(cga::pose_cast<double>(source.pose())));
	}
	measure(state, count, 3 * sizeof(cga::Motor<double>), [&] {
		for (size_t i = 0; i < count; ++i) {
			cga::Motor<double> product = cga::compose(motors[i % DISTINCT], motors[(i + 7) % DISTINCT]);
			benchmark::DoNotOptimize(product);
		}
	});
}

template <class Left, class Right>
void multiply_typed(benchmark::State &state) {
	const size_t count = size_t(state.range(0));
	std::mt19937 random(2028);
	std::normal_distribution<double> normal;
	std::vector<Left> lefts(DISTINCT);
	std::vector<Right> rights(DISTINCT);
	for (size_t i = 0; i < DISTINCT; ++i) {
		for (double &coefficient : lefts[i].coefficients) {
			coefficient = normal(random);
		}
		for (double &coefficient : rights[i].coefficients) {
			coefficient = normal(random);
		}
	}
	measure(state, count, sizeof(Left) + sizeof(Right), [&] {
		for (size_t i = 0; i < count; ++i) {
			auto product = lefts[i % DISTINCT].geometric_product(rights[(i + 7) % DISTINCT]);
			benchmark::DoNotOptimize(product);
		}
	});
}

using Even = cga::typed::Sparse<cga::typed::blades_of_grade(0) | cga::typed::blades_of_grade(2) | cga::typed::blades_of_grade(4)>;

template <class Function>
void add_two(const std::string &subject, Function function) {
	benchmark::RegisterBenchmark(("geometric_product/" + subject).c_str(), function)->Arg(1)->Arg(1000);
}

const bool REGISTERED = [] {
	add_two("ga_godot", multiply_each<Ours>);
	add_two("dense_loop", multiply_each<DenseLoop>);
	add_two("table_loop", multiply_each<TableLoop>);
	add_two("complex_matrices", multiply_each<ComplexMatrices>);
	add_two("ga_godot_motors", multiply_motors);
	add_two("ga_godot_typed_even", multiply_typed<Even, Even>);
	add_two("ga_godot_typed_line_point", multiply_typed<cga::typed::Line<>, cga::typed::Point<>>);
	return true;
}();

} // namespace

} // namespace kernels_bench
