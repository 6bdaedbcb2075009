#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/vector.hpp"
#include "playground/expression/lexer.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// Values that are written out in an expression, and where, so that they can be written anew.

namespace playground {

using LiteralValue = std::variant<double, cga::Vector3<double>, cga::Quaternion<double>, cga::Multivector>;

struct TextSpan {
	size_t offset = 0; // bytes
	size_t length = 0;
};

// Tokens of a text, one after the other.
class TokenRange {
public:
	TokenRange(std::string_view text, const Token *first, const Token *last) :
			_text(text), _first(first), _last(last) {}

	[[nodiscard]] size_t size() const { return size_t(_last - _first); }
	[[nodiscard]] const Token &operator[](size_t index) const { return _first[index]; }
	[[nodiscard]] TokenRange part(size_t from, size_t to) const { return { _text, _first + from, _first + to }; }
	// The text of a token, and from the first to the last token.
	[[nodiscard]] std::string_view text(size_t index) const { return _text.substr(_first[index].offset, _first[index].length); }
	[[nodiscard]] std::string_view text() const;
	[[nodiscard]] TextSpan span() const;
	[[nodiscard]] std::string_view whole_text() const { return _text; }
	[[nodiscard]] bool is(size_t index, TokenKind kind) const { return index < size() && _first[index].kind == kind; }

	// For `name(...)` from end to end the ranges of its arguments; empty for all else.
	[[nodiscard]] std::vector<TokenRange> arguments() const;
	// The index behind the bracket that closes the one at `open`.
	[[nodiscard]] size_t behind_bracket(size_t open) const;

private:
	std::string_view _text;
	const Token *_first;
	const Token *_last;
};

// Empty where a character is not of the language.
[[nodiscard]] std::vector<Token> tokens_of(std::string_view text);

struct Literal {
	enum Form {
		NUMBERS, // each number of the value stands in a span of its own
		DEGREES, // one number, within deg()
		SUM, // of e1, e2, e3, in one span
		BLADES, // a sum of any blades, in one span
		ROTOR, // a call of rotor() belongs there
	} form = NUMBERS;
	LiteralValue value;
	std::vector<TextSpan> spans;
};

// 2, -2.5, deg(90)
[[nodiscard]] std::optional<Literal> number_literal(const TokenRange &range);
// vector(1, 2, 3), point(1, 2, 3), e1 - 2 e3, 0, eo
[[nodiscard]] std::optional<Literal> vector_literal(const TokenRange &range);
// [32 numbers]; 1 + 2 e12 - 0.5 einf
[[nodiscard]] std::optional<Literal> multivector_literal(const TokenRange &range);
// The numbers of literals, as spans of one.
[[nodiscard]] Literal joined(const std::vector<Literal> &numbers, LiteralValue value);

// Whether two values of a type are the same to whoever sets them: vectors and rotations, which come from the engine, in single
// precision.
[[nodiscard]] bool is_same(const LiteralValue &left, const LiteralValue &right);

struct TextEdit {
	TextSpan span;
	std::string text;
};

// What writes another value, of the same type; numbers that stay the same stay as they were typed.
[[nodiscard]] std::vector<TextEdit> edits_for(const Literal &literal, const LiteralValue &value);
// The spans do not overlap.
[[nodiscard]] std::string edited(std::string_view text, std::vector<TextEdit> edits);

} // namespace playground
