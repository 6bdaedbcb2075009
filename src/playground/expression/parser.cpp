#include "playground/expression/parser.hpp"

#include "cga/text/json.hpp"
#include "playground/expression/functions.hpp"
#include "playground/expression/lexer.hpp"
#include "playground/expression/names.hpp"
#include "playground/expression/operators.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace playground {

// Dijkstra's shunting yard: pending operators are kept on an explicit stack of at most MAX_DEPTH, so that no text can
// exhaust the call stack.
class Parser {
public:
	explicit Parser(std::string_view text) :
			_lexer(text) {
		_expression._text = text;
	}

	cga::TextResult<Expression> parse() {
		const std::string_view text = _expression._text;
		if (text.size() > MAX_TEXT_LENGTH) {
			return cga::text_error(text, MAX_TEXT_LENGTH, "the expression is too long: it has " + std::to_string(text.size()) + " bytes, and at most " + std::to_string(MAX_TEXT_LENGTH) + " are accepted");
		}
		advance();
		while (!_error && !_is_complete) {
			if (_token.kind == TokenKind::INVALID) {
				fail(_token, _lexer.error());
			} else if (_expects_operand) {
				read_operand();
			} else {
				read_after_operand();
			}
		}
		if (_error) {
			return *_error;
		}
		measure();
		return std::move(_expression);
	}

private:
	// A pending operator (its right operand is not complete) or an open parenthesis.
	struct Pending {
		enum Kind {
			OPERATOR,
			GROUP,
			CALL
		} kind;
		int level; // of an OPERATOR
		Node node; // of an OPERATOR or a CALL
		Token token;
		std::vector<uint32_t> argument_offsets; // of a CALL
	};

	void advance() { _token = _lexer.next(); }

	// For messages.
	std::string quoted(const Token &token) const { return "'" + cga::shortened(text_of(token)) + "'"; }

	std::string text_of(const Token &token) const { return _expression._text.substr(token.offset, token.length); }

	void fail(const Token &token, std::string message) {
		if (!_error) {
			_error = cga::text_error(_expression._text, token.offset, std::move(message));
		}
	}

	// "expected X, found Y"
	void fail_expected(const std::string &what) {
		const std::string found = _token.kind == TokenKind::END ? "the end" : (_token.kind == TokenKind::LIST ? "'['" : quoted(_token));
		std::string message = "expected " + what + ", found " + found;
		if (!_expects_operand && (_token.kind == TokenKind::NAME || _token.kind == TokenKind::NUMBER || _token.kind == TokenKind::OPEN || _token.kind == TokenKind::LIST)) {
			message += "; write '*' to multiply";
		}
		const auto open = std::find_if(_pending.rbegin(), _pending.rend(), [](const Pending &pending) { return pending.kind != Pending::OPERATOR; });
		if (_token.kind == TokenKind::END && open != _pending.rend()) {
			message += "; the '(' at column " + std::to_string(cga::text_error(_expression._text, open->token.offset, {}).column) + " is not closed";
		}
		fail(_token, std::move(message));
	}

	Node node_at(NodeKind kind, const Token &token) const {
		Node node;
		node.kind = kind;
		node.offset = uint32_t(token.offset);
		node.length = uint32_t(token.length);
		return node;
	}

	void push_pending(Pending pending) {
		if (_pending.size() >= MAX_DEPTH) {
			fail(pending.token, "the expression is nested too deeply; at most " + std::to_string(MAX_DEPTH) + " levels are accepted");
			return;
		}
		_pending.push_back(std::move(pending));
	}

	void read_operand() {
		const Token token = _token;
		if (const std::optional<NodeKind> prefix = prefix_operator(token.kind)) {
			push_pending({ Pending::OPERATOR, PREFIX_LEVEL, node_at(*prefix, token), token, {} });
			advance();
		} else if (token.kind == TokenKind::PLUS) {
			advance();
		} else if (token.kind == TokenKind::OPEN) {
			push_pending({ Pending::GROUP, 0, {}, token, {} });
			advance();
		} else if (token.kind == TokenKind::NUMBER) {
			read_number();
		} else if (token.kind == TokenKind::LIST) {
			read_coefficients(token);
		} else if (token.kind == TokenKind::NAME) {
			advance();
			if (_token.kind == TokenKind::OPEN) {
				read_call(token);
			} else {
				read_name(token);
			}
		} else {
			fail_expected("a number, a name or '('");
		}
	}

	void read_number() {
		const Token token = _token;
		Node node = node_at(NodeKind::NUMBER, token);
		node.number = token.number;
		_expression._nodes.push_back(node);
		_expects_operand = false;
		advance();
		if (_token.kind != TokenKind::NAME && _token.kind != TokenKind::OPEN) {
			return;
		}
		// An implicit product. After a division it is refused: "1/2 e12" would mean 1/(2 e12), which is rarely intended.
		const auto before = std::find_if(_pending.rbegin(), _pending.rend(), [](const Pending &pending) { return pending.level != PREFIX_LEVEL; });
		if (before != _pending.rend() && before->kind == Pending::OPERATOR && before->node.kind == NodeKind::DIVIDE) {
			const std::string divisor = cga::shortened(text_of(token));
			fail(_token, "expected an operator; '/ " + divisor + " ...' is ambiguous: write '/ " + divisor + " * ...' or '/ (" + divisor + " ...)'");
			return;
		}
		push_pending({ Pending::OPERATOR, IMPLICIT_PRODUCT_LEVEL, node_at(NodeKind::GEOMETRIC, token), token, {} });
		_expects_operand = true;
	}

	// All 32 coefficients, in the format of ganja.js.
	void read_coefficients(const Token &token) {
		const cga::TextResult<cga::Multivector> value = cga::from_json(text_of(token));
		if (!value) {
			Token position = token;
			position.offset += value.error().offset;
			fail(position, value.error().message);
			return;
		}
		add_constant(token, *value);
		_expects_operand = false;
		advance();
	}

	void add_constant(const Token &token, const cga::Multivector &value) {
		Node node = node_at(NodeKind::CONSTANT, token);
		std::vector<cga::Multivector> &constants = _expression._constants;
		const auto [found, is_new] = _constant_indices.emplace(text_of(token), uint16_t(constants.size()));
		if (is_new) {
			constants.push_back(value);
		}
		node.index = found->second;
		_expression._nodes.push_back(node);
	}

	void read_name(const Token &token) {
		const std::string name = text_of(token);
		if (const std::optional<cga::Multivector> value = constant(name)) {
			add_constant(token, *value);
		} else if (const cga::Result<void, Error> checked = check_name(name); !checked) {
			fail(token, checked.error().message);
			return;
		} else {
			Node node = node_at(NodeKind::VARIABLE, token);
			node.index = variable_index(name);
			_expression._nodes.push_back(node);
		}
		_expects_operand = false;
	}

	uint16_t variable_index(const std::string &name) {
		std::vector<std::string> &names = _expression._variables;
		const auto [found, is_new] = _variable_indices.emplace(name, uint16_t(names.size()));
		if (is_new) {
			names.push_back(name);
		}
		return found->second;
	}

	// At the '(' after a name.
	void read_call(const Token &name) {
		const std::optional<size_t> function = find_function(text_of(name));
		if (!function) {
			fail_unknown_function(name);
			return;
		}
		Node node = node_at(NodeKind::CALL, name);
		node.index = uint16_t(*function);
		Pending call{ Pending::CALL, 0, node, _token, {} };
		advance();
		call.argument_offsets.push_back(uint32_t(_token.offset));
		push_pending(std::move(call));
		if (!_error && _token.kind == TokenKind::CLOSE) {
			fail_count(_pending.back(), 0);
		}
	}

	void fail_unknown_function(const Token &name) {
		const std::string text = text_of(name);
		if (constant(text)) {
			fail(name, quoted(name) + " is not a function; write '*' to multiply");
			return;
		}
		std::vector<std::string_view> names;
		for (const Function &function : functions()) {
			names.push_back(function.name);
		}
		fail(name, "unknown function " + quoted(name) + suggestion(text, names));
	}

	void fail_count(const Pending &call, size_t count) {
		const Function &function = functions()[call.node.index];
		Token name = call.token;
		name.offset = call.node.offset;
		const std::string given = count > function.max_arguments() ? "more" : std::to_string(count);
		fail(name, std::string(function.name) + " takes " + function.counts() + ", not " + given);
	}

	// Expects an operator, a comma, a closing parenthesis or the end.
	void read_after_operand() {
		if (const std::optional<BinaryOperator> binary = binary_operator(_token.kind)) {
			finish_operators(binary->level);
			push_pending({ Pending::OPERATOR, binary->level, node_at(binary->kind, _token), _token, {} });
			_expects_operand = true;
			advance();
			return;
		}
		finish_operators(0);
		if (_token.kind == TokenKind::COMMA && is_inside(Pending::CALL)) {
			read_comma();
		} else if (_token.kind == TokenKind::CLOSE && !_pending.empty()) {
			read_close();
		} else if (_token.kind == TokenKind::END && _pending.empty()) {
			_is_complete = true;
		} else if (is_inside(Pending::CALL)) {
			fail_expected("')', ',' or an operator");
		} else if (is_inside(Pending::GROUP)) {
			fail_expected("')' or an operator");
		} else {
			fail_expected("an operator or the end");
		}
	}

	bool is_inside(typename Pending::Kind kind) const { return !_pending.empty() && _pending.back().kind == kind; }

	// Emits the pending operators that bind at least as tightly as `level`.
	void finish_operators(int level) {
		while (is_inside(Pending::OPERATOR) && _pending.back().level >= level) {
			_expression._nodes.push_back(_pending.back().node);
			_pending.pop_back();
		}
	}

	void read_comma() {
		Pending &call = _pending.back();
		advance();
		call.argument_offsets.push_back(uint32_t(_token.offset));
		if (call.argument_offsets.size() > functions()[call.node.index].max_arguments()) {
			fail_count(call, call.argument_offsets.size());
		}
		_expects_operand = true;
	}

	void read_close() {
		const Pending bracket = std::move(_pending.back());
		_pending.pop_back();
		if (bracket.kind == Pending::CALL) {
			const size_t count = bracket.argument_offsets.size();
			if (!functions()[bracket.node.index].takes(count)) {
				fail_count(bracket, count);
				return;
			}
			Node node = bracket.node;
			node.arguments = uint8_t(count);
			std::vector<uint32_t> &offsets = _expression._argument_offsets;
			node.first_argument = uint32_t(offsets.size());
			offsets.insert(offsets.end(), bracket.argument_offsets.begin(), bracket.argument_offsets.end());
			_expression._nodes.push_back(node);
		}
		advance();
	}

	void measure() {
		int size = 0;
		for (const Node &node : _expression._nodes) {
			size += 1 - operand_count(node);
			_expression._stack_size = std::max(_expression._stack_size, size);
			_expression._operations += operation_count(node.kind, node.kind == NodeKind::CALL && functions()[node.index].is_costly());
		}
	}

	Lexer _lexer;
	Token _token;
	Expression _expression;
	std::vector<Pending> _pending;
	std::optional<cga::TextError> _error;
	std::map<std::string, uint16_t> _variable_indices;
	std::map<std::string, uint16_t> _constant_indices;
	bool _expects_operand = true;
	bool _is_complete = false;
};

cga::TextResult<Expression> parse(std::string_view text) {
	return Parser(text).parse();
}

} // namespace playground
