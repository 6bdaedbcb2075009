#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

// The 32 basis blades of Cl(4,1), computed at compile time: e1, e2, e3, e4 square to +1 and e5 to -1; blades are ordered by
// grade, then lexicographically: 1, e1 .. e5, e12, e13 .. e45, e123 .. e12345.
//
// A blade is represented by a bitmap, whose bit k - 1 stands for e_k, or by its index in that order. Products are computed with
// bitmaps.

namespace cga {

inline constexpr int DIMENSION = 5;
inline constexpr int BLADE_COUNT = 1 << DIMENSION;

// The bits of e4 and e5, which span the null vectors e_inf and e_o.
inline constexpr unsigned E4_BIT = 0b01000;
inline constexpr unsigned E5_BIT = 0b10000;
// The bits of the basis vectors that square to -1.
inline constexpr unsigned NEGATIVE_VECTORS = E5_BIT;

[[nodiscard]] constexpr int grade_of_bitmap(unsigned bitmap) {
	int grade = 0;
	for (; bitmap != 0; bitmap &= bitmap - 1) {
		++grade;
	}
	return grade;
}

// The sign of the geometric product of two basis blades; the product's bitmap is left ^ right.
[[nodiscard]] constexpr int product_sign(unsigned left, unsigned right) {
	// To sort the product, each vector of `right` is swapped with every later vector of `left`.
	int swaps = 0;
	for (unsigned later = left >> 1; later != 0; later >>= 1) {
		swaps += grade_of_bitmap(later & right);
	}
	// Each vector that is in both factors squares to +1 or -1.
	swaps += grade_of_bitmap(left & right & NEGATIVE_VECTORS);
	return (swaps & 1) == 0 ? 1 : -1;
}

namespace detail {

// The bits in reverse order, e1 highest: within a grade, blades are ordered by decreasing mirrored bitmap.
[[nodiscard]] constexpr unsigned mirrored(unsigned bitmap) {
	unsigned result = 0;
	for (int bit = 0; bit < DIMENSION; ++bit) {
		result = (result << 1) | ((bitmap >> bit) & 1u);
	}
	return result;
}

[[nodiscard]] constexpr std::array<uint8_t, BLADE_COUNT> ordered_bitmaps() {
	std::array<uint8_t, BLADE_COUNT> bitmaps{};
	size_t count = 0;
	for (int grade = 0; grade <= DIMENSION; ++grade) {
		for (unsigned mirror = BLADE_COUNT; mirror-- > 0;) {
			if (grade_of_bitmap(mirror) == grade) {
				bitmaps[count++] = uint8_t(mirrored(mirror));
			}
		}
	}
	return bitmaps;
}

[[nodiscard]] constexpr std::array<uint8_t, BLADE_COUNT> inverted(const std::array<uint8_t, BLADE_COUNT> &permutation) {
	std::array<uint8_t, BLADE_COUNT> inverse{};
	for (size_t index = 0; index < BLADE_COUNT; ++index) {
		inverse[permutation[index]] = uint8_t(index);
	}
	return inverse;
}

} // namespace detail

// Index to bitmap and back.
inline constexpr std::array<uint8_t, BLADE_COUNT> BLADE_BITMAPS = detail::ordered_bitmaps();
inline constexpr std::array<uint8_t, BLADE_COUNT> BLADE_INDICES = detail::inverted(BLADE_BITMAPS);

// The grade of the blade at an index.
[[nodiscard]] constexpr int blade_grade(int index) {
	return grade_of_bitmap(BLADE_BITMAPS[size_t(index)]);
}

// "1", "e1", "e12", ... "e12345".
struct BladeName {
	char text[DIMENSION + 2] = {};
	size_t length = 0;

	[[nodiscard]] constexpr std::string_view view() const { return { text, length }; }
};

[[nodiscard]] constexpr BladeName blade_name(int index) {
	BladeName name;
	if (index == 0) {
		name.text[name.length++] = '1';
		return name;
	}
	name.text[name.length++] = 'e';
	for (int vector = 0; vector < DIMENSION; ++vector) {
		if (((BLADE_BITMAPS[size_t(index)] >> vector) & 1) != 0) {
			name.text[name.length++] = char('1' + vector);
		}
	}
	return name;
}

// A basis blade with a sign: the name "e21" stands for -e12.
struct SignedBlade {
	int index = 0;
	int sign = 1;
};

// "1", or "e" with different digits 1 to 5 in any order. Empty for other names.
[[nodiscard]] constexpr std::optional<SignedBlade> parse_blade(std::string_view name) {
	if (name == "1") {
		return SignedBlade{};
	}
	if (name.size() < 2 || name.size() > size_t(DIMENSION) + 1 || name[0] != 'e') {
		return std::nullopt;
	}
	unsigned bitmap = 0;
	int sign = 1;
	for (const char digit : name.substr(1)) {
		const unsigned vector = digit >= '1' && digit < '1' + DIMENSION ? 1u << (digit - '1') : 0u;
		if (vector == 0 || (bitmap & vector) != 0) {
			return std::nullopt;
		}
		sign *= product_sign(bitmap, vector);
		bitmap |= vector;
	}
	return SignedBlade{ BLADE_INDICES[bitmap], sign };
}

// The index of a name; in constant expressions, an unknown name does not compile.
[[nodiscard]] constexpr int blade_index(std::string_view name) {
	return parse_blade(name).value().index;
}

// The indices of the basis blades, by name.
inline constexpr int E1 = blade_index("e1");
inline constexpr int E2 = blade_index("e2");
inline constexpr int E3 = blade_index("e3");
inline constexpr int E4 = blade_index("e4");
inline constexpr int E5 = blade_index("e5");
inline constexpr int E12 = blade_index("e12");
inline constexpr int E13 = blade_index("e13");
inline constexpr int E14 = blade_index("e14");
inline constexpr int E15 = blade_index("e15");
inline constexpr int E23 = blade_index("e23");
inline constexpr int E24 = blade_index("e24");
inline constexpr int E25 = blade_index("e25");
inline constexpr int E34 = blade_index("e34");
inline constexpr int E35 = blade_index("e35");
inline constexpr int E45 = blade_index("e45");
inline constexpr int E123 = blade_index("e123");
inline constexpr int E124 = blade_index("e124");
inline constexpr int E125 = blade_index("e125");
inline constexpr int E134 = blade_index("e134");
inline constexpr int E135 = blade_index("e135");
inline constexpr int E145 = blade_index("e145");
inline constexpr int E234 = blade_index("e234");
inline constexpr int E235 = blade_index("e235");
inline constexpr int E245 = blade_index("e245");
inline constexpr int E345 = blade_index("e345");
inline constexpr int E1234 = blade_index("e1234");
inline constexpr int E1235 = blade_index("e1235");
inline constexpr int E1245 = blade_index("e1245");
inline constexpr int E1345 = blade_index("e1345");
inline constexpr int E2345 = blade_index("e2345");
inline constexpr int E12345 = blade_index("e12345");

} // namespace cga
