#pragma once

#include "cga/algebra/multivector.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// A parsed expression: what parser.hpp makes of a text and evaluate.hpp computes with.

namespace playground {

enum class NodeKind : uint8_t {
	NUMBER, // `number`
	CONSTANT, // a name with a fixed value; `index` into Expression::constants()
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
	CALL, // `index` into functions() (functions.hpp); its `arguments` begin at argument_offsets()[first_argument]...
};

// One step of the computation. `offset` and `length` (bytes) are the part of the text that an error names: the
// literal, the name or the operator.
struct Node {
	NodeKind kind = NodeKind::NUMBER;
	uint8_t arguments = 0;
	uint16_t index = 0;
	uint32_t offset = 0;
	uint32_t length = 0;
	uint32_t first_argument = 0;
	double number = 0.0;
};

// A place where the text refers to a variable.
struct NameUse {
	uint16_t variable = 0; // index into Expression::variables()
	uint32_t offset = 0; // bytes
	int column = 1; // from 1, characters
};

// The nodes stand in the order of evaluation (postfix): operands before what takes them, the result last.
class Expression {
public:
	[[nodiscard]] const std::string &text() const { return _text; }
	[[nodiscard]] const std::vector<Node> &nodes() const { return _nodes; }
	// The names of variables that it refers to, each once, in the order in which they first appear.
	[[nodiscard]] const std::vector<std::string> &variables() const { return _variables; }
	// Where it refers to them, from left to right.
	[[nodiscard]] const std::vector<NameUse> &uses() const { return _uses; }
	// Where it first refers to one of variables().
	[[nodiscard]] const NameUse &first_use(size_t variable) const;
	// The values of the constants that it uses.
	[[nodiscard]] const std::vector<cga::Multivector> &constants() const { return _constants; }
	// Where the arguments of calls begin, in bytes; those of one call follow each other.
	[[nodiscard]] const std::vector<uint32_t> &argument_offsets() const { return _argument_offsets; }
	// The values that evaluation holds at once, at most.
	[[nodiscard]] int stack_size() const { return _stack_size; }

	[[nodiscard]] bool refers_to(std::string_view variable) const;
	// The text with another name wherever it refers to `from`; all else stays as it was typed.
	[[nodiscard]] std::string renamed(std::string_view from, std::string_view to) const;

private:
	friend class Parser;

	std::string _text;
	std::vector<Node> _nodes;
	std::vector<std::string> _variables;
	std::vector<NameUse> _uses;
	std::vector<cga::Multivector> _constants;
	std::vector<uint32_t> _argument_offsets;
	int _stack_size = 0;
};

} // namespace playground
