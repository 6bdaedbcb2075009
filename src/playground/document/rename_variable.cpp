#include "playground/document/rename_variable.hpp"

#include "playground/expression/lexer.hpp"

namespace playground {

std::string with_variable_renamed(std::string_view text, std::string_view from, std::string_view to) {
	std::string result;
	size_t copied = 0;
	Lexer lexer(text);
	Token token = lexer.next();
	while (token.kind != TokenKind::END && token.kind != TokenKind::INVALID) {
		const Token next = lexer.next();
		if (token.kind == TokenKind::NAME && next.kind != TokenKind::OPEN && text.substr(token.offset, token.length) == from) {
			result.append(text, copied, token.offset - copied);
			result += to;
			copied = token.offset + token.length;
		}
		token = next;
	}
	return result.append(text, copied, std::string::npos);
}

} // namespace playground
