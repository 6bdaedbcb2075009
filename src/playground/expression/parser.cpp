#include "playground/expression/parser.hpp"

#include "cga/text/json.hpp"
#include "cga/text/utf8.hpp"
#include "playground/expression/functions.hpp"
#include "playground/expression/lexer.hpp"
#include "playground/expression/names.hpp"
#include "playground/expression/operators.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace playground {

// Dijkstra's shunting yard: operators wait on a stack of their own until what binds tighter is done, so that no
// function calls itself and a text of any shape needs only as much memory as MAX_DEPTH allows.
class Parser {
public:
	explicit Parser(std::string_view text) :
			_lexer(text) {
		_expression._text = text;
	}

	cga::TextResult<Expression> parse() {
		const std::string_view text = _expression._text;
		if (text.size() > MAX_TEXT_LENGTH) {
			return cga::text_error(text, MAX_TEXT_LENGTH, "expected the end; an expression has at most " + std::to_string(MAX_TEXT_LENGTH) + " bytes");
		}
		advance();
		while (!_error && !_is_complete) {
			if (_token.kind == TokenKind::INVALID) {
				fail(_token, _lexer.error());
			} else if (_wants_operand) {
				read_operand();
			} else {
				read_after_operand();
			}
		}
		if (_error) {
			return *_error;
		}
		measure_stack();
		return std::move(_expression);
	}

private:
	// What waits: an operator for its right side, a bracket for its end.
	struct Waiting {
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

	std::string text_of(const Token &token) const { return _expression._text.substr(token.offset, token.length); }

	void fail(const Token &token, std::string message) {
		if (!_error) {
			_error = cga::text_error(_expression._text, token.offset, std::move(message));
		}
	}

	// "expected X, found Y"
	void fail_expected(const std::string &what) {
		const std::string found = _token.kind == TokenKind::END ? "the end" : (_token.kind == TokenKind::LIST ? "'['" : "'" + text_of(_token) + "'");
		std::string message = "expected " + what + ", found " + found;
		if (!_wants_operand && (_token.kind == TokenKind::NAME || _token.kind == TokenKind::NUMBER || _token.kind == TokenKind::OPEN || _token.kind == TokenKind::LIST)) {
			message += "; write '*' to multiply";
		}
		const auto open = std::find_if(_waiting.rbegin(), _waiting.rend(), [](const Waiting &waiting) { return waiting.kind != Waiting::OPERATOR; });
		if (_token.kind == TokenKind::END && open != _waiting.rend()) {
			message += "; the '(' at column " + std::to_string(cga::text_error(_expression._text, open->token.offset, {}).column) + " is still open";
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

	void wait(Waiting waiting) {
		if (_waiting.size() >= MAX_DEPTH) {
			fail(waiting.token, "expected a simpler expression; more than " + std::to_string(MAX_DEPTH) + " operators and brackets inside each other here");
			return;
		}
		_waiting.push_back(std::move(waiting));
	}

	void read_operand() {
		const Token token = _token;
		if (const std::optional<NodeKind> prefix = prefix_operator(token.kind)) {
			wait({ Waiting::OPERATOR, PREFIX_LEVEL, node_at(*prefix, token), token, {} });
			advance();
		} else if (token.kind == TokenKind::PLUS) {
			advance();
		} else if (token.kind == TokenKind::OPEN) {
			wait({ Waiting::GROUP, 0, {}, token, {} });
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
		_wants_operand = false;
		advance();
		if (_token.kind != TokenKind::NAME && _token.kind != TokenKind::OPEN) {
			return;
		}
		// The product with what follows. After a division, "1/2 e12" would be 1/(2 e12), which few expect.
		const auto before = std::find_if(_waiting.rbegin(), _waiting.rend(), [](const Waiting &waiting) { return waiting.level != PREFIX_LEVEL; });
		if (before != _waiting.rend() && before->kind == Waiting::OPERATOR && before->node.kind == NodeKind::DIVIDE) {
			const std::string divisor = text_of(token);
			fail(_token, "expected an operator; '/ " + divisor + " ...' can be read in two ways, write '/ " + divisor + " * ...' or '/ (" + divisor + " ...)'");
			return;
		}
		wait({ Waiting::OPERATOR, NUMBER_LEVEL, node_at(NodeKind::GEOMETRIC, token), token, {} });
		_wants_operand = true;
	}

	// All 32 coefficients, in ganja.js's form.
	void read_coefficients(const Token &token) {
		const cga::TextResult<cga::Multivector> value = cga::from_json(text_of(token));
		if (!value) {
			Token place = token;
			place.offset += value.error().offset;
			fail(place, value.error().message);
			return;
		}
		add_constant(token, *value);
		_wants_operand = false;
		advance();
	}

	void add_constant(const Token &token, const cga::Multivector &value) {
		Node node = node_at(NodeKind::CONSTANT, token);
		node.index = uint16_t(_expression._constants.size());
		_expression._constants.push_back(value);
		_expression._nodes.push_back(node);
	}

	void read_name(const Token &token) {
		const std::string name = text_of(token);
		if (const std::optional<cga::Multivector> value = constant(name)) {
			add_constant(token, *value);
		} else if (const std::string error = name_error(name); !error.empty()) {
			fail(token, error);
			return;
		} else {
			Node node = node_at(NodeKind::VARIABLE, token);
			node.index = variable_index(name);
			_expression._uses.push_back({ node.index, node.offset, column_at(token.offset) });
			_expression._nodes.push_back(node);
		}
		_wants_operand = false;
	}

	uint16_t variable_index(const std::string &name) {
		std::vector<std::string> &names = _expression._variables;
		const auto [found, is_new] = _variable_indices.emplace(name, uint16_t(names.size()));
		if (is_new) {
			names.push_back(name);
		}
		return found->second;
	}

	// The column at offsets that grow from call to call: each character is counted once.
	int column_at(size_t offset) {
		while (_counted < offset) {
			const cga::Character character = cga::character_at(_expression._text, _counted);
			_column = character.code == '\n' ? 1 : _column + 1;
			_counted += character.length;
		}
		return _column;
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
		Waiting call{ Waiting::CALL, 0, node, _token, {} };
		advance();
		call.argument_offsets.push_back(uint32_t(_token.offset));
		wait(std::move(call));
		if (!_error && _token.kind == TokenKind::CLOSE) {
			fail_count(_waiting.back(), 0);
		}
	}

	void fail_unknown_function(const Token &name) {
		const std::string text = text_of(name);
		if (constant(text)) {
			fail(name, "'" + text + "' is no function; write '*' to multiply");
			return;
		}
		std::vector<std::string_view> names;
		for (const Function &function : functions()) {
			names.push_back(function.name);
		}
		const std::string closest(closest_name(text, names));
		fail(name, "unknown function '" + text + "'" + (closest.empty() ? "" : "; did you mean '" + closest + "'?"));
	}

	void fail_count(const Waiting &call, size_t count) {
		const Function &function = functions()[call.node.index];
		Token name = call.token;
		name.offset = call.node.offset;
		const std::string given = count > function.most_arguments() ? "more" : (count == 0 ? "none" : std::to_string(count));
		fail(name, std::string(function.name) + " takes " + function.counts() + ", not " + given);
	}

	// An operator, the end of an argument, of a bracket or of all.
	void read_after_operand() {
		if (const std::optional<BinaryOperator> binary = binary_operator(_token.kind)) {
			finish_operators(binary->level);
			wait({ Waiting::OPERATOR, binary->level, node_at(binary->kind, _token), _token, {} });
			_wants_operand = true;
			advance();
			return;
		}
		finish_operators(0);
		if (_token.kind == TokenKind::COMMA && is_inside(Waiting::CALL)) {
			read_comma();
		} else if (_token.kind == TokenKind::CLOSE && !_waiting.empty()) {
			read_close();
		} else if (_token.kind == TokenKind::END && _waiting.empty()) {
			_is_complete = true;
		} else if (is_inside(Waiting::CALL)) {
			fail_expected("')', ',' or an operator");
		} else if (is_inside(Waiting::GROUP)) {
			fail_expected("')' or an operator");
		} else {
			fail_expected("an operator or the end");
		}
	}

	bool is_inside(typename Waiting::Kind kind) const { return !_waiting.empty() && _waiting.back().kind == kind; }

	// Computes what waits and binds at least as tight as an operator of `level`.
	void finish_operators(int level) {
		while (is_inside(Waiting::OPERATOR) && _waiting.back().level >= level) {
			_expression._nodes.push_back(_waiting.back().node);
			_waiting.pop_back();
		}
	}

	void read_comma() {
		Waiting &call = _waiting.back();
		advance();
		call.argument_offsets.push_back(uint32_t(_token.offset));
		if (call.argument_offsets.size() > functions()[call.node.index].most_arguments()) {
			fail_count(call, call.argument_offsets.size());
		}
		_wants_operand = true;
	}

	void read_close() {
		const Waiting bracket = std::move(_waiting.back());
		_waiting.pop_back();
		if (bracket.kind == Waiting::CALL) {
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

	void measure_stack() {
		int size = 0;
		for (const Node &node : _expression._nodes) {
			size += 1 - operand_count(node);
			_expression._stack_size = std::max(_expression._stack_size, size);
		}
	}

	Lexer _lexer;
	Token _token;
	Expression _expression;
	std::vector<Waiting> _waiting;
	std::optional<cga::TextError> _error;
	std::map<std::string, uint16_t> _variable_indices;
	size_t _counted = 0;
	int _column = 1;
	bool _wants_operand = true;
	bool _is_complete = false;
};

cga::TextResult<Expression> parse(std::string_view text) {
	return Parser(text).parse();
}

} // namespace playground
