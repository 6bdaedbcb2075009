#include "playground/expression/names.hpp"

#include "cga/text/text_error.hpp"
#include "cga/text/utf8.hpp"

#include <algorithm>
#include <array>

namespace playground {

namespace {

constexpr double PI = 3.14159265358979323846;

struct CodeRange {
	uint32_t first, last;
};

// Beyond ASCII every character counts as a letter except these: controls, spaces, punctuation, operators, symbols and
// private use.
constexpr CodeRange NON_LETTERS[] = {
	{ 0x80, 0xa9 },
	{ 0xab, 0xb4 },
	{ 0xb6, 0xb9 },
	{ 0xbb, 0xbf },
	{ 0xd7, 0xd7 }, // ×
	{ 0xf7, 0xf7 }, // ÷
	{ 0x1680, 0x1680 },
	{ 0x180e, 0x180e },
	{ 0x2000, 0x206f },
	{ 0x20a0, 0x20cf },
	{ 0x2190, 0x2bff },
	{ 0x2e00, 0x2e7f },
	{ 0x3000, 0x3004 },
	{ 0x3008, 0x3020 },
	{ 0xe000, 0xf8ff },
	{ 0xfe00, 0xfe6f },
	{ 0xfeff, 0xff0f },
	{ 0xff1a, 0xff20 },
	{ 0xff3b, 0xff40 },
	{ 0xff5b, 0xff65 },
	{ 0xffe0, 0xffff },
	{ 0x1f000, 0x1ffff },
	{ 0xe0000, 0x10ffff },
};

bool is_letter(uint32_t code) {
	if (code < 0x80) {
		return (code >= 'a' && code <= 'z') || (code >= 'A' && code <= 'Z') || code == '_';
	}
	return std::none_of(std::begin(NON_LETTERS), std::end(NON_LETTERS), [code](const CodeRange &range) { return code >= range.first && code <= range.last; });
}

// True for "e" followed by digits, even if they do not name a blade.
bool looks_like_blade(std::string_view name) {
	return name.size() > 1 && name[0] == 'e' && std::all_of(name.begin() + 1, name.end(), [](char digit) { return cga::is_digit(uint8_t(digit)); });
}

// The Damerau-Levenshtein distance: counts deletions, insertions and replacements of bytes, and swaps of adjacent bytes.
size_t edit_distance(std::string_view left, std::string_view right) {
	// The last three rows of the table of distances between prefixes.
	std::array<std::array<size_t, MAX_NAME_LENGTH + 1>, 3> rows{};
	for (size_t j = 0; j <= right.size(); ++j) {
		rows[0][j] = j;
	}
	for (size_t i = 1; i <= left.size(); ++i) {
		std::array<size_t, MAX_NAME_LENGTH + 1> &row = rows[i % 3];
		const std::array<size_t, MAX_NAME_LENGTH + 1> &before = rows[(i + 2) % 3];
		row[0] = i;
		for (size_t j = 1; j <= right.size(); ++j) {
			const bool same = left[i - 1] == right[j - 1];
			row[j] = std::min({ before[j] + 1, row[j - 1] + 1, before[j - 1] + (same ? 0 : 1) });
			if (i > 1 && j > 1 && left[i - 1] == right[j - 2] && left[i - 2] == right[j - 1]) {
				row[j] = std::min(row[j], rows[(i + 1) % 3][j - 2] + 1);
			}
		}
	}
	return rows[left.size() % 3][right.size()];
}

std::string lower_case(std::string_view name) {
	std::string lower(name);
	for (char &letter : lower) {
		letter = letter >= 'A' && letter <= 'Z' ? char(letter - 'A' + 'a') : letter;
	}
	return lower;
}

} // namespace

size_t name_length(std::string_view text) {
	size_t length = 0;
	while (length < text.size()) {
		const cga::Character character = cga::character_at(text, length);
		if (!character.is_valid || !(is_letter(character.code) || (length > 0 && cga::is_digit(character.code)))) {
			break;
		}
		length += character.length;
	}
	return length;
}

std::optional<cga::Multivector> constant(std::string_view name) {
	if (name == "pi") {
		return cga::Multivector::scalar(PI);
	}
	if (name == "tau") {
		return cga::Multivector::scalar(2.0 * PI);
	}
	return cga::Multivector::basis(name == "ei" ? "einf" : name);
}

cga::Result<void, Error> check_name(std::string_view name) {
	const std::string quoted = "'" + cga::shortened(name) + "'";
	if (name.empty()) {
		return Error("a name must have at least one character");
	}
	if (name_length(name) != name.size()) {
		// Do not quote the name, because it may contain arbitrary bytes.
		return Error("a name may have only letters, digits and underscores, and may not begin with a digit");
	}
	if (size_t(cga::character_count(name)) > MAX_NAME_LENGTH) {
		return Error(quoted + " is too long; a name may have at most " + std::to_string(MAX_NAME_LENGTH) + " characters");
	}
	if (constant(name)) {
		return Error(quoted + " is a constant; choose another name");
	}
	if (looks_like_blade(name)) {
		return Error(quoted + " is not a basis blade; use distinct digits 1 to 5 after 'e'");
	}
	return {};
}

std::string_view closest_name(std::string_view name, const std::vector<std::string_view> &candidates) {
	std::string_view closest;
	if (name.size() > MAX_NAME_LENGTH) {
		return closest;
	}
	// Accept edit distances up to a third of the name's length in bytes, or 1 for short names.
	size_t smallest = std::max<size_t>(1, name.size() / 3) + 1;
	for (const std::string_view candidate : candidates) {
		if (candidate.size() > MAX_NAME_LENGTH || candidate.size() < 2) {
			continue;
		}
		const size_t distance = lower_case(candidate) == lower_case(name) ? 0 : edit_distance(name, candidate);
		if (distance < smallest) {
			smallest = distance;
			closest = candidate;
		}
	}
	return closest;
}

std::string suggestion(std::string_view name, const std::vector<std::string_view> &candidates) {
	const std::string closest(closest_name(name, candidates));
	return closest.empty() ? closest : "; did you mean '" + closest + "'?";
}

} // namespace playground
