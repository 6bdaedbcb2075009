#include "playground/expression/lexer.hpp"

#include "cga/algebra/blade.hpp"
#include "cga/text/number_text.hpp"
#include "cga/text/text_error.hpp"
#include "cga/text/utf8.hpp"
#include "playground/expression/names.hpp"

#include <optional>

namespace playground {

namespace {

struct Symbol {
	std::string_view text;
	TokenKind kind;
};

constexpr Symbol SYMBOLS[] = {
	{ "+", TokenKind::PLUS },
	{ "-", TokenKind::MINUS },
	{ "*", TokenKind::STAR },
	{ "/", TokenKind::SLASH },
	{ "^", TokenKind::WEDGE },
	{ "|", TokenKind::BAR },
	{ "<<", TokenKind::SHIFT_LEFT },
	{ ">>", TokenKind::SHIFT_RIGHT },
	{ "&", TokenKind::AMPERSAND },
	{ "~", TokenKind::TILDE },
	{ "!", TokenKind::EXCLAMATION },
	{ "(", TokenKind::OPEN },
	{ ")", TokenKind::CLOSE },
	{ ",", TokenKind::COMMA },
};

// Characters of other notations, common in copied formulas, and what to write instead.
struct Replacement {
	std::string_view text;
	std::string_view instead;
};

constexpr Replacement REPLACEMENTS[] = {
	{ "∧", "write '^' for the outer product" },
	{ "∨", "write '&' for the regressive product" },
	{ "·", "write '|' for the inner product" },
	{ "⋅", "write '|' for the inner product" },
	{ "⌋", "write '<<' for the left contraction" },
	{ "⌊", "write '>>' for the right contraction" },
	{ "×", "write '*' for the geometric product, commutator_product(a, b) for the commutator" },
	{ "−", "write '-' for minus" },
	{ "∞", "write 'einf' for the point at infinity" },
	{ "<", "write '<<' for the left contraction" },
	{ ">", "write '>>' for the right contraction" },
	{ "=", "an expression has no assignment or comparison" },
	{ "%", "there is no remainder operator" },
	{ ";", "write ',' between arguments" },
	{ "]", "write '(' and ')'" },
	{ "{", "write '(' and ')'" },
	{ "}", "write '(' and ')'" },
	{ "\"", "an expression has no strings" },
	{ "'", "an expression has no strings" },
};

bool starts_with(std::string_view text, std::string_view start) {
	return text.substr(0, start.size()) == start;
}

} // namespace

Token Lexer::next() {
	if (!_error.empty()) {
		return { TokenKind::INVALID, _position, 0, 0.0 };
	}
	while (_position < _text.size() && std::string_view(" \t\r\n").find(_text[_position]) != std::string_view::npos) {
		++_position;
	}
	if (_position >= _text.size()) {
		return { TokenKind::END, _text.size(), 0, 0.0 };
	}
	if (cga::is_digit(at(_position)) || (at(_position) == '.' && cga::is_digit(at(_position + 1)))) {
		return read_number();
	}
	if (const size_t length = name_length(_text.substr(_position)); length > 0) {
		return take(TokenKind::NAME, length);
	}
	return read_symbol();
}

// digits [. digits] [(e | E) [+ | -] digits]. After a lower-case e, an exponent whose digits name a blade needs a sign:
// 1e12 could mean 1 e12 or 1e+12.
Token Lexer::read_number() {
	size_t end = _position + digits_from(_position);
	if (at(end) == '.') {
		++end;
		end += digits_from(end);
	}
	const size_t mark = end;
	if (at(mark) == 'e' || at(mark) == 'E') {
		const bool has_sign = at(mark + 1) == '+' || at(mark + 1) == '-';
		const size_t digits = digits_from(mark + 1 + (has_sign ? 1 : 0));
		if (digits > 0) {
			end = mark + 1 + (has_sign ? 1 : 0) + digits;
		}
		if (digits > 0 && !has_sign && cga::parse_blade(_text.substr(mark, end - mark))) {
			const std::string mantissa = cga::shortened(_text.substr(_position, mark - _position));
			const std::string exponent(_text.substr(mark + 1, digits));
			return fail(_position, "'" + mantissa + "e" + exponent + "' is ambiguous: write '" + mantissa + "e+" + exponent + "' for the number or '" + mantissa + " e" + exponent + "' for the blade");
		}
	}
	const std::optional<double> number = cga::read_number(_text.substr(_position, end - _position));
	if (!number) {
		return fail(_position, "the number is too large; at most 1.8e308 is accepted");
	}
	Token token = take(TokenKind::NUMBER, end - _position);
	token.number = *number;
	return token;
}

Token Lexer::read_symbol() {
	const std::string_view rest = _text.substr(_position);
	if (rest[0] == '[') {
		const size_t end = rest.find(']');
		return take(TokenKind::LIST, end == std::string_view::npos ? rest.size() : end + 1);
	}
	for (const Symbol &symbol : SYMBOLS) {
		if (starts_with(rest, symbol.text)) {
			return take(symbol.kind, symbol.text.size());
		}
	}
	const std::string found = cga::describe_character(_text, _position);
	for (const Replacement &replacement : REPLACEMENTS) {
		if (starts_with(rest, replacement.text)) {
			return fail(_position, found + " is not part of the language; " + std::string(replacement.instead));
		}
	}
	return fail(_position, "expected a number, a name or an operator, found " + found);
}

size_t Lexer::digits_from(size_t offset) const {
	size_t end = offset;
	while (cga::is_digit(at(end))) {
		++end;
	}
	return end - offset;
}

Token Lexer::take(TokenKind kind, size_t length) {
	const Token token{ kind, _position, length, 0.0 };
	_position += length;
	return token;
}

Token Lexer::fail(size_t offset, std::string message) {
	_position = offset;
	_error = std::move(message);
	return { TokenKind::INVALID, offset, 0, 0.0 };
}

} // namespace playground
