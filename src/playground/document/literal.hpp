#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/vector.hpp"
#include "playground/expression/lexer.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// Literals in expressions and their positions in the text, so that new values can replace them.

namespace playground {

using LiteralValue = std::variant<double, cga::Vector3<double>, cga::Quaternion<double>, cga::Multivector>;

struct TextSpan {
	size_t offset = 0; // bytes
	size_t length = 0;
};

// Consecutive tokens of a text.
class TokenRange {
public:
	TokenRange(std::string_view text, const Token *first, const Token *last) :
			_text(text), _first(first), _last(last) {}

	[[nodiscard]] size_t size() const { return size_t(_last - _first); }
	[[nodiscard]] const Token &operator[](size_t index) const { return _first[index]; }
	[[nodiscard]] TokenRange part(size_t from, size_t to) const { return { _text, _first + from, _first + to }; }
	// The text of a token.
	[[nodiscard]] std::string_view text(size_t index) const { return _text.substr(_first[index].offset, _first[index].length); }
	// The text from the first token to the last.
	[[nodiscard]] std::string_view text() const { return _text.substr(span().offset, span().length); }
	[[nodiscard]] TextSpan span() const;
	[[nodiscard]] bool is(size_t index, TokenKind kind) const { return index < size() && _first[index].kind == kind; }

	// If the range is a single call `name(...)`, the ranges of its arguments; otherwise empty.
	[[nodiscard]] std::vector<TokenRange> arguments() const;
	// The index after the parenthesis that closes the one at `open`; size() + 1 if it is not closed.
	[[nodiscard]] size_t after_parenthesis(size_t open) const;

private:
	std::string_view _text;
	const Token *_first;
	const Token *_last;
};

// Empty if a token is invalid.
[[nodiscard]] std::vector<Token> tokens_of(std::string_view text);

struct Literal {
	enum Form {
		NUMBERS, // each number of the value has its own span
		DEGREES, // one number inside deg()
		SUM, // of e1, e2, e3, in one span
		BLADES, // a sum of any blades, in one span
		ROTOR, // one span, to be replaced by a call of rotor()
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
// The first three arguments as a vector, or the first four as a quaternion in the order x, y, z, w; empty if one of them is
// not a number. Precondition: `count` is 3 or 4, and there are at least that many arguments.
[[nodiscard]] std::optional<Literal> group_literal(const std::vector<TokenRange> &arguments, size_t count);

[[nodiscard]] bool is_finite(const LiteralValue &value);

// Whether two values of the same type are equal. Vectors and rotations come from the engine and are compared in single
// precision.
[[nodiscard]] bool is_same(const LiteralValue &left, const LiteralValue &right);

struct TextEdit {
	TextSpan span;
	std::string text;
};

// The edits that write another value of the same type. Numbers that do not change stay as typed.
[[nodiscard]] std::vector<TextEdit> edits_for(const Literal &literal, const LiteralValue &value);
// Applies the edits. Precondition: the spans do not overlap.
[[nodiscard]] std::string edited(std::string_view text, std::vector<TextEdit> edits);

} // namespace playground
