#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

// Splits the text of an expression into numbers, names and operators.

namespace playground {

enum class TokenKind : uint8_t {
	NUMBER,
	NAME,
	PLUS, // +
	MINUS, // -
	STAR, // *
	SLASH, // /
	WEDGE, // ^
	BAR, // |
	SHIFT_LEFT, // <<
	SHIFT_RIGHT, // >>
	AMPERSAND, // &
	TILDE, // ~
	EXCLAMATION, // !
	OPEN, // (
	CLOSE, // )
	COMMA, // ,
	LIST, // [ ... ], not parsed here; extends to the end of the text if there is no ]
	END, // of the text
	INVALID, // Lexer::error() says why
};

struct Token {
	TokenKind kind = TokenKind::END;
	size_t offset = 0; // bytes
	size_t length = 0;
	double number = 0.0; // of NUMBER
};

class Lexer {
public:
	explicit Lexer(std::string_view text) :
			_text(text) {}

	// The next token. After the last it is always END, after the first invalid one always INVALID.
	[[nodiscard]] Token next();
	// Why the token is INVALID; empty before that.
	[[nodiscard]] const std::string &error() const { return _error; }

private:
	Token read_number();
	Token read_symbol();
	size_t digits_from(size_t offset) const;
	char at(size_t offset) const { return offset < _text.size() ? _text[offset] : '\0'; }
	Token take(TokenKind kind, size_t length);
	Token fail(size_t offset, std::string message);

	std::string_view _text;
	size_t _position = 0;
	std::string _error;
};

} // namespace playground
