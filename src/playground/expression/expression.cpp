#include "playground/expression/expression.hpp"

#include "playground/expression/lexer.hpp"

#include <algorithm>

namespace playground {

bool Expression::refers_to(std::string_view variable) const {
	return std::find(_variables.begin(), _variables.end(), variable) != _variables.end();
}

size_t Expression::first_use(size_t variable) const {
	return std::find_if(_nodes.begin(), _nodes.end(), [variable](const Node &node) { return node.kind == NodeKind::VARIABLE && node.index == variable; })->offset;
}

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
