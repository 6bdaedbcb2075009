#pragma once

#include "playground/expression/expression.hpp"
#include "playground/expression/lexer.hpp"

#include <optional>

// The operators of the expression language and their precedence.

namespace playground {

struct BinaryOperator {
	NodeKind kind;
	int level; // precedence: a higher level binds tighter
};

// The levels of the grammar in parser.hpp: sum 1, product 2, inner 3, outer 4, prefix 5, implicit product 6.
inline constexpr int PREFIX_LEVEL = 5;
inline constexpr int IMPLICIT_PRODUCT_LEVEL = 6;

[[nodiscard]] constexpr std::optional<BinaryOperator> binary_operator(TokenKind kind) {
	switch (kind) {
		case TokenKind::PLUS:
			return BinaryOperator{ NodeKind::ADD, 1 };
		case TokenKind::MINUS:
			return BinaryOperator{ NodeKind::SUBTRACT, 1 };
		case TokenKind::STAR:
			return BinaryOperator{ NodeKind::GEOMETRIC, 2 };
		case TokenKind::SLASH:
			return BinaryOperator{ NodeKind::DIVIDE, 2 };
		case TokenKind::BAR:
			return BinaryOperator{ NodeKind::INNER, 3 };
		case TokenKind::SHIFT_LEFT:
			return BinaryOperator{ NodeKind::LEFT_CONTRACTION, 3 };
		case TokenKind::SHIFT_RIGHT:
			return BinaryOperator{ NodeKind::RIGHT_CONTRACTION, 3 };
		case TokenKind::AMPERSAND:
			return BinaryOperator{ NodeKind::REGRESSIVE, 3 };
		case TokenKind::WEDGE:
			return BinaryOperator{ NodeKind::OUTER, 4 };
		default:
			return std::nullopt;
	}
}

[[nodiscard]] constexpr std::optional<NodeKind> prefix_operator(TokenKind kind) {
	switch (kind) {
		case TokenKind::MINUS:
			return NodeKind::NEGATE;
		case TokenKind::TILDE:
			return NodeKind::REVERSE;
		case TokenKind::EXCLAMATION:
			return NodeKind::DUAL;
		default:
			return std::nullopt;
	}
}

// The number of values that a node pops from the stack.
[[nodiscard]] constexpr int operand_count(const Node &node) {
	switch (node.kind) {
		case NodeKind::NUMBER:
		case NodeKind::CONSTANT:
		case NodeKind::VARIABLE:
			return 0;
		case NodeKind::NEGATE:
		case NodeKind::REVERSE:
		case NodeKind::DUAL:
			return 1;
		case NodeKind::CALL:
			return node.arguments;
		default:
			return 2;
	}
}

// What a node costs, in products; sums, signs and operands are not counted. `is_costly` as of the called function.
[[nodiscard]] constexpr size_t operation_count(NodeKind kind, bool is_costly) {
	switch (kind) {
		case NodeKind::NUMBER:
		case NodeKind::CONSTANT:
		case NodeKind::VARIABLE:
		case NodeKind::NEGATE:
		case NodeKind::ADD:
		case NodeKind::SUBTRACT:
			return 0;
		case NodeKind::DIVIDE:
			return 8;
		case NodeKind::CALL:
			return is_costly ? 80 : 12;
		default:
			return 1;
	}
}

} // namespace playground
