#include "cga/algebra/complex_matrix.hpp"

#include <utility>

namespace cga {

namespace {

using Complex = std::complex<double>;

// A matrix with one entry in each row r: i^phase[r] in column r ^ mask. These matrices are closed under multiplication.
struct Monomial {
	unsigned mask = 0;
	std::array<uint8_t, 4> phase{};
};

constexpr Monomial operator*(const Monomial &left, const Monomial &right) {
	Monomial product;
	product.mask = left.mask ^ right.mask;
	for (unsigned row = 0; row < 4; ++row) {
		product.phase[row] = uint8_t((left.phase[row] + right.phase[row ^ left.mask]) % 4);
	}
	return product;
}

// The basis vectors, with the Pauli matrices s1, s2, s3 and the Kronecker product (x): e1, e2, e3 = s1 (x) s1, s1 (x) s2,
// s1 (x) s3; e4 = s2 (x) 1; e5 = i e1 e2 e3 e4. They anticommute; the first four square to 1 and the fifth to -1.
constexpr std::array<Monomial, DIMENSION> vector_matrices() {
	std::array<Monomial, DIMENSION> vectors = { {
			{ 3, { 0, 0, 0, 0 } },
			{ 3, { 3, 1, 3, 1 } },
			{ 2, { 0, 2, 0, 2 } },
			{ 2, { 3, 3, 1, 1 } },
			{},
	} };
	constexpr Monomial IMAGINARY_UNIT = { 0, { 1, 1, 1, 1 } };
	vectors[4] = IMAGINARY_UNIT * vectors[0] * vectors[1] * vectors[2] * vectors[3];
	return vectors;
}

constexpr std::array<Monomial, BLADE_COUNT> blade_matrices() {
	constexpr std::array<Monomial, DIMENSION> VECTORS = vector_matrices();
	std::array<Monomial, BLADE_COUNT> blades{};
	for (unsigned index = 0; index < BLADE_COUNT; ++index) {
		for (unsigned vector = 0; vector < DIMENSION; ++vector) {
			if (((BLADE_BITMAPS[index] >> vector) & 1u) != 0) {
				blades[index] = blades[index] * VECTORS[vector];
			}
		}
	}
	return blades;
}

// By index of the blade.
constexpr std::array<Monomial, BLADE_COUNT> BLADE_MATRICES = blade_matrices();

constexpr double REAL_OF_PHASE[4] = { 1.0, 0.0, -1.0, 0.0 };
constexpr double IMAGINARY_OF_PHASE[4] = { 0.0, 1.0, 0.0, -1.0 };

struct Position {
	size_t row;
	size_t column;
};

// The position of the largest entry in the rows and columns from `start` on.
Position largest_entry(const ComplexMatrix &matrix, size_t start) {
	Position position{ start, start };
	double largest = -1.0;
	for (size_t row = start; row < 4; ++row) {
		for (size_t column = start; column < 4; ++column) {
			const double size = std::norm(matrix[row][column]);
			if (size > largest) {
				largest = size;
				position = { row, column };
			}
		}
	}
	return position;
}

} // namespace

ComplexMatrix to_matrix(const Multivector &x) {
	ComplexMatrix matrix{};
	for (size_t index = 0; index < BLADE_COUNT; ++index) {
		const Monomial &blade = BLADE_MATRICES[index];
		for (unsigned row = 0; row < 4; ++row) {
			const Complex unit(REAL_OF_PHASE[blade.phase[row]], IMAGINARY_OF_PHASE[blade.phase[row]]);
			matrix[row][row ^ blade.mask] += unit * x[int(index)];
		}
	}
	return matrix;
}

// The blades' matrices are unitary, and orthogonal to each other: a coefficient is (1/4) Re tr(blade^H matrix).
Multivector from_matrix(const ComplexMatrix &matrix) {
	Multivector x;
	for (size_t index = 0; index < BLADE_COUNT; ++index) {
		const Monomial &blade = BLADE_MATRICES[index];
		double trace = 0.0;
		for (unsigned row = 0; row < 4; ++row) {
			const Complex entry = matrix[row][row ^ blade.mask];
			trace += REAL_OF_PHASE[blade.phase[row]] * entry.real() + IMAGINARY_OF_PHASE[blade.phase[row]] * entry.imag();
		}
		x[int(index)] = 0.25 * trace;
	}
	return x;
}

std::optional<ComplexMatrix> inverse_matrix(const ComplexMatrix &matrix) {
	ComplexMatrix left = matrix;
	ComplexMatrix right{};
	std::array<size_t, 4> column_order{ 0, 1, 2, 3 };
	for (size_t i = 0; i < 4; ++i) {
		right[i][i] = 1.0;
	}
	for (size_t step = 0; step < 4; ++step) {
		const Position pivot = largest_entry(left, step);
		if (!(std::norm(left[pivot.row][pivot.column]) > 0.0)) {
			return std::nullopt;
		}
		std::swap(left[step], left[pivot.row]);
		std::swap(right[step], right[pivot.row]);
		for (std::array<Complex, 4> &row : left) {
			std::swap(row[step], row[pivot.column]);
		}
		std::swap(column_order[step], column_order[pivot.column]);

		const Complex reciprocal = 1.0 / left[step][step];
		for (size_t column = 0; column < 4; ++column) {
			left[step][column] *= reciprocal;
			right[step][column] *= reciprocal;
		}
		for (size_t row = 0; row < 4; ++row) {
			const Complex factor = left[row][step];
			for (size_t column = 0; row != step && column < 4; ++column) {
				left[row][column] -= factor * left[step][column];
				right[row][column] -= factor * right[step][column];
			}
		}
	}
	// A column swap in the matrix is a row swap in its inverse.
	ComplexMatrix inverse;
	for (size_t i = 0; i < 4; ++i) {
		inverse[column_order[i]] = right[i];
	}
	return inverse;
}

} // namespace cga
