#pragma once

#include "cga/algebra/multivector.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// A parsed expression: parser.hpp creates it from text, evaluate.hpp computes its value.

namespace playground {

enum class NodeKind : uint8_t {
	NUMBER, // `number`
	CONSTANT, // a named constant or a list of coefficients; `index` into Expression::constants()
	VARIABLE, // `index` into Expression::variables()
	NEGATE,
	REVERSE,
	DUAL,
	ADD,
	SUBTRACT,
	GEOMETRIC,
	DIVIDE,
	OUTER,
	INNER,
	LEFT_CONTRACTION,
	RIGHT_CONTRACTION,
	REGRESSIVE,
	CALL, // `index` into functions() (functions.hpp); argument_offsets()[first_argument] is the first of `arguments` offsets
};

// One step of the evaluation. `offset` and `length` (bytes) locate the literal, name or operator, for errors.
struct Node {
	NodeKind kind = NodeKind::NUMBER;
	uint8_t arguments = 0;
	uint16_t index = 0;
	uint32_t offset = 0;
	uint32_t length = 0;
	uint32_t first_argument = 0;
	double number = 0.0;
};

// The nodes are in postfix order: operands before their operator, the result last.
class Expression {
public:
	[[nodiscard]] const std::string &text() const { return _text; }
	[[nodiscard]] const std::vector<Node> &nodes() const { return _nodes; }
	// The names of its variables, each once, in order of first occurrence.
	[[nodiscard]] const std::vector<std::string> &variables() const { return _variables; }
	// The offset of the first occurrence of variables()[variable], in bytes.
	[[nodiscard]] size_t first_use(size_t variable) const;
	// The constants that it uses, each spelling once.
	[[nodiscard]] const std::vector<cga::Multivector> &constants() const { return _constants; }
	// The offsets of all arguments of calls, in bytes; those of one call are adjacent.
	[[nodiscard]] const std::vector<uint32_t> &argument_offsets() const { return _argument_offsets; }
	// The largest number of values on the evaluation stack.
	[[nodiscard]] int stack_size() const { return _stack_size; }
	// What evaluating it costs, in products: operators.hpp weighs the nodes.
	[[nodiscard]] size_t operations() const { return _operations; }

	[[nodiscard]] bool refers_to(std::string_view variable) const;

private:
	friend class Parser;

	std::string _text;
	std::vector<Node> _nodes;
	std::vector<std::string> _variables;
	std::vector<cga::Multivector> _constants;
	std::vector<uint32_t> _argument_offsets;
	int _stack_size = 0;
	size_t _operations = 0;
};

// The text with each occurrence of variable `from` renamed; everything else stays as typed. In a text that does not parse,
// renames every name except those of calls, up to the first invalid token.
[[nodiscard]] std::string with_variable_renamed(std::string_view text, std::string_view from, std::string_view to);

} // namespace playground
