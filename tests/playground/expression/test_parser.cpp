#include "playground/expression/parser.hpp"

#include "playground/expression/functions.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <map>

using namespace playground;

namespace {

const std::map<NodeKind, std::string> OPERATORS = {
	{ NodeKind::NEGATE, "-" },
	{ NodeKind::REVERSE, "~" },
	{ NodeKind::DUAL, "!" },
	{ NodeKind::ADD, " + " },
	{ NodeKind::SUBTRACT, " - " },
	{ NodeKind::GEOMETRIC, " * " },
	{ NodeKind::DIVIDE, " / " },
	{ NodeKind::OUTER, " ^ " },
	{ NodeKind::INNER, " | " },
	{ NodeKind::LEFT_CONTRACTION, " << " },
	{ NodeKind::RIGHT_CONTRACTION, " >> " },
	{ NodeKind::REGRESSIVE, " & " },
};

// The expression with all parentheses, which shows the precedence.
std::string structure(const Expression &expression) {
	std::vector<std::string> stack;
	const auto pop = [&stack] {
		const std::string top = stack.back();
		stack.pop_back();
		return top;
	};
	for (const Node &node : expression.nodes()) {
		const std::string text = expression.text().substr(node.offset, node.length);
		switch (node.kind) {
			case NodeKind::NUMBER:
			case NodeKind::CONSTANT:
			case NodeKind::VARIABLE:
				stack.push_back(text);
				break;
			case NodeKind::NEGATE:
			case NodeKind::REVERSE:
			case NodeKind::DUAL:
				stack.push_back("(" + OPERATORS.at(node.kind) + pop() + ")");
				break;
			case NodeKind::CALL: {
				std::string arguments;
				for (int index = 0; index < node.arguments; ++index) {
					arguments = pop() + (index > 0 ? ", " : "") + arguments;
				}
				stack.push_back(text + "(" + arguments + ")");
				break;
			}
			default: {
				const std::string right = pop();
				stack.push_back("(" + pop() + OPERATORS.at(node.kind) + right + ")");
			}
		}
	}
	REQUIRE(stack.size() == 1);
	return stack.back();
}

std::vector<Node> variable_nodes(const Expression &expression) {
	std::vector<Node> found;
	std::copy_if(expression.nodes().begin(), expression.nodes().end(), std::back_inserter(found), [](const Node &node) { return node.kind == NodeKind::VARIABLE; });
	return found;
}

std::vector<int> columns_of(const Expression &expression) {
	std::vector<int> columns;
	for (const Node &node : variable_nodes(expression)) {
		columns.push_back(cga::text_error(expression.text(), node.offset, {}).column);
	}
	return columns;
}

std::string structure(std::string_view text) {
	const cga::TextResult<Expression> expression = parse(text);
	return expression ? structure(*expression) : expression.error().describe();
}

} // namespace

TEST_CASE("precedence increases from sums to geometric, inner and outer products") {
	CHECK(structure("a + b * c") == "(a + (b * c))");
	CHECK(structure("a * b + c") == "((a * b) + c)");
	CHECK(structure("a * b | c") == "(a * (b | c))");
	CHECK(structure("a | b * c") == "((a | b) * c)");
	CHECK(structure("a | b ^ c") == "(a | (b ^ c))");
	CHECK(structure("a ^ b | c") == "((a ^ b) | c)");
	CHECK(structure("a << b ^ c >> d") == "((a << (b ^ c)) >> d)");
	CHECK(structure("a ^ b & c ^ d") == "((a ^ b) & (c ^ d))");
	CHECK(structure("a / b ^ c") == "(a / (b ^ c))");
	CHECK(structure("a + b * c | d ^ e") == "(a + (b * (c | (d ^ e))))");
}

TEST_CASE("operators of equal precedence associate to the left") {
	CHECK(structure("a - b + c - d") == "(((a - b) + c) - d)");
	CHECK(structure("a / b * c / d") == "(((a / b) * c) / d)");
	CHECK(structure("a | b << c >> d & e") == "((((a | b) << c) >> d) & e)");
	CHECK(structure("a ^ b ^ c") == "((a ^ b) ^ c)");
}

TEST_CASE("prefix operators bind tighter than all others") {
	CHECK(structure("-a ^ b") == "((-a) ^ b)");
	CHECK(structure("~a * !b") == "((~a) * (!b))");
	CHECK(structure("a - -b") == "(a - (-b))");
	CHECK(structure("!~-a") == "(!(~(-a)))");
	CHECK(structure("+a + +b") == "(a + b)");
	CHECK(structure("a * -b | c") == "(a * ((-b) | c))");
	CHECK(structure("-f") == "(-f)");
}

TEST_CASE("a number before a name, a call or a parenthesis is an implicit product, which binds tightest") {
	CHECK(structure("2 e12") == "(2 * e12)");
	CHECK(structure("2einf") == "(2 * einf)");
	CHECK(structure("2(a + b)") == "(2 * (a + b))");
	CHECK(structure("2 sin(a)") == "(2 * sin(a))");
	CHECK(structure("-2 e1 ^ 3 e2") == "((-(2 * e1)) ^ (3 * e2))");
	CHECK(structure("1 + 2 e12 - 0.5 einf") == "((1 + (2 * e12)) - (0.5 * einf))");
	CHECK(structure("0.5 e12^einf^eo") == "(((0.5 * e12) ^ einf) ^ eo)");
	CHECK(structure("~2 e12") == "(~(2 * e12))");
	CHECK(structure("a * 2 b") == "(a * (2 * b))");
	CHECK(structure("1/(2 b)") == "(1 / (2 * b))");
	CHECK(structure("a ^ 1/2 * b") == "(((a ^ 1) / 2) * b)");
}

TEST_CASE("parentheses and calls") {
	CHECK(structure("(a + b) * c") == "((a + b) * c)");
	CHECK(structure("((((a))))") == "a");
	CHECK(structure("atan2(a + b, -c) * d") == "(atan2((a + b), (-c)) * d)");
	CHECK(structure("min(max(a, b), (c), 2 d)") == "min(max(a, b), c, (2 * d))");
	CHECK(structure("dual ( a )") == "dual(a)");
	CHECK(structure("\t a\n+\r\nb ") == "(a + b)");
	// A name before a parenthesis is a function, any other a variable.
	CHECK(structure("dual + dual(dual)") == "(dual + dual(dual))");
}

TEST_CASE("numbers") {
	const std::map<std::string, double> numbers = {
		{ "0", 0.0 },
		{ "12", 12.0 },
		{ "1.5", 1.5 },
		{ ".5", 0.5 },
		{ "1.", 1.0 },
		{ "007", 7.0 },
		{ "1e+20", 1e20 },
		{ "1e-7", 1e-7 },
		{ "1.5e-07", 1.5e-7 },
		{ "2E3", 2000.0 },
		{ "1E+2", 100.0 },
		{ "1e20", 1e20 },
		{ "1e6", 1e6 },
		{ "1e11", 1e11 },
		{ "1e-999", 0.0 },
	};
	for (const auto &each : numbers) {
		const std::string &text = each.first;
		const cga::TextResult<Expression> expression = parse(text);
		REQUIRE_MESSAGE(expression.has_value(), text);
		REQUIRE(expression->nodes().size() == 1);
		CHECK(expression->nodes()[0].kind == NodeKind::NUMBER);
		CHECK(expression->nodes()[0].number == each.second);
		CHECK(expression->nodes()[0].length == text.size());
	}
}

TEST_CASE("a parse error gives the column and what was expected") {
	const std::vector<std::pair<std::string, std::string>> errors = {
		{ "", "column 1: expected a number, a name or '(', found the end" },
		{ "   ", "column 4: expected a number, a name or '(', found the end" },
		{ "a +", "column 4: expected a number, a name or '(', found the end" },
		{ "a + * b", "column 5: expected a number, a name or '(', found '*'" },
		{ "a ** 2", "column 4: expected a number, a name or '(', found '*'" },
		{ "* a", "column 1: expected a number, a name or '(', found '*'" },
		{ "()", "column 2: expected a number, a name or '(', found ')'" },
		{ "a b", "column 3: expected an operator or the end, found 'b'; write '*' to multiply" },
		{ "a 2", "column 3: expected an operator or the end, found '2'; write '*' to multiply" },
		{ "1 2", "column 3: expected an operator or the end, found '2'; write '*' to multiply" },
		{ "1.2.3", "column 4: expected an operator or the end, found '.3'; write '*' to multiply" },
		{ "(a) (b)", "column 5: expected an operator or the end, found '('; write '*' to multiply" },
		{ "2 (a) b", "column 7: expected an operator or the end, found 'b'; write '*' to multiply" },
		{ "a ~ b", "column 3: expected an operator or the end, found '~'" },
		{ "a!", "column 2: expected an operator or the end, found '!'" },
		{ "a)", "column 2: expected an operator or the end, found ')'" },
		{ "a, b", "column 2: expected an operator or the end, found ','" },
		{ "(a + b", "column 7: expected ')' or an operator, found the end; the '(' at column 1 is not closed" },
		{ "(a, b)", "column 3: expected ')' or an operator, found ','" },
		{ "sin(a", "column 6: expected ')', ',' or an operator, found the end; the '(' at column 4 is not closed" },
		{ "sin(a b)", "column 7: expected ')', ',' or an operator, found 'b'; write '*' to multiply" },
		{ "sin(a +", "column 8: expected a number, a name or '(', found the end; the '(' at column 4 is not closed" },
		{ "max(a,)", "column 7: expected a number, a name or '(', found ')'" },
		{ "max(,a)", "column 5: expected a number, a name or '(', found ','" },
		{ "1 + sin()", "column 5: sin takes 1 argument, not 0" },
		{ "sin(a, b)", "column 1: sin takes 1 argument, not more" },
		{ "rotor(a)", "column 1: rotor takes 2 or 4 arguments, not 1" },
		{ "rotor(a, b, c)", "column 1: rotor takes 2 or 4 arguments, not 3" },
		{ "max(1,2,3,4,5)", "column 1: max takes 2, 3 or 4 arguments, not more" },
		{ "foo(1)", "column 1: unknown function 'foo'" },
		{ "a + snadwich(a, b)", "column 5: unknown function 'snadwich'; did you mean 'sandwich'?" },
		{ "Sin(a)", "column 1: unknown function 'Sin'; did you mean 'sin'?" },
		{ "pi(2)", "column 1: 'pi' is not a function; write '*' to multiply" },
		{ "e1(2)", "column 1: 'e1' is not a function; write '*' to multiply" },
		{ "a + e6", "column 5: 'e6' is not a basis blade; use distinct digits 1 to 5 after 'e'" },
		{ "e11", "column 1: 'e11' is not a basis blade; use distinct digits 1 to 5 after 'e'" },
		{ "2e12", "column 1: '2e12' is ambiguous: write '2e+12' for the number or '2 e12' for the blade" },
		{ "a + 1.5e3", "column 5: '1.5e3' is ambiguous: write '1.5e+3' for the number or '1.5 e3' for the blade" },
		{ "1/2 e12", "column 5: expected an operator; '/ 2 ...' is ambiguous: write '/ 2 * ...' or '/ (2 ...)'" },
		{ "1/-2(a)", "column 5: expected an operator; '/ 2 ...' is ambiguous: write '/ 2 * ...' or '/ (2 ...)'" },
		{ "1e999", "column 1: the number is too large; at most 1.8e308 is accepted" },
		{ ".", "column 1: expected a number, a name or an operator, found '.'" },
		{ "a # b", "column 3: expected a number, a name or an operator, found '#'" },
		{ "a < b", "column 3: '<' is not part of the language; write '<<' for the left contraction" },
		{ "a > b", "column 3: '>' is not part of the language; write '>>' for the right contraction" },
		{ "x = 2", "column 3: '=' is not part of the language; an expression has no assignment or comparison" },
		{ "ä ∧ b", "column 3: '∧' is not part of the language; write '^' for the outer product" },
		{ "a ∨ b", "column 3: '∨' is not part of the language; write '&' for the regressive product" },
		{ "a · b", "column 3: '·' is not part of the language; write '|' for the inner product" },
		{ "a − b", "column 3: '−' is not part of the language; write '-' for minus" },
		{ "a ⌋ b", "column 3: '⌋' is not part of the language; write '<<' for the left contraction" },
		{ "point[1]", "column 6: expected an operator or the end, found '['; write '*' to multiply" },
		{ "sin(1;2)", "column 6: ';' is not part of the language; write ',' between arguments" },
		{ "\"e12\"", "column 1: '\"' is not part of the language; an expression has no strings" },
		{ "a\xff", "column 2: expected a number, a name or an operator, found the byte 0xff" },
		{ "a\n+ #", "line 2, column 3: expected a number, a name or an operator, found '#'" },
		{ std::string("a\0b", 3), "column 2: expected a number, a name or an operator, found the control character 0x00" },
	};
	for (const auto &each : errors) {
		CAPTURE(each.first);
		CHECK(structure(each.first) == each.second);
	}
}

TEST_CASE("texts that are too deep or too long are refused quickly") {
	const auto start = std::chrono::steady_clock::now();
	for (const std::string unit : { "(", "-", "~", "!", "sin(", "2(", "min(1,", "-(", "a+(", "a*(a|(a^" }) {
		std::string text;
		while (text.size() < MAX_TEXT_LENGTH - 20) {
			text += unit;
		}
		CAPTURE(unit);
		CHECK(structure(text).find("the expression is nested too deeply; at most 256 levels are accepted") != std::string::npos);
		for (int repeat = 0; repeat < 3; ++repeat) {
			text += text;
		}
		CHECK(structure(text) == "column 16385: the expression is too long: it has " + std::to_string(text.size()) + " bytes, and at most 16384 are accepted");
	}
	// The accepted maxima of depth and length.
	CHECK(structure(std::string(256, '(') + "a" + std::string(256, ')')) == "a");
	CHECK(structure(std::string(257, '(') + "a" + std::string(257, ')')) == "column 257: the expression is nested too deeply; at most 256 levels are accepted");
	std::string sum = "a";
	while (sum.size() + 2 <= MAX_TEXT_LENGTH) {
		sum += "+a";
	}
	const cga::TextResult<Expression> expression = parse(sum);
	REQUIRE(expression.has_value());
	CHECK(expression->nodes().size() == sum.size());
	CHECK(expression->stack_size() == 2);
	CHECK(parse(std::string(100000, '+')).error().column == 16385);
	CHECK(parse(std::string(16000, '+') + "a").has_value());
	CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
}

TEST_CASE("an expression lists its variables and where they occur") {
	const Expression expression = *parse("ä + sphere2 * ä | e1 - sin(b)^dual");
	CHECK(expression.variables() == std::vector<std::string>{ "ä", "sphere2", "b", "dual" });
	const std::vector<Node> uses = variable_nodes(expression);
	CHECK(columns_of(expression) == std::vector<int>{ 1, 5, 15, 28, 31 });
	CHECK(uses[2].index == 0);
	CHECK(uses[2].offset == 15);
	CHECK(expression.first_use(0) == 0);
	CHECK(expression.first_use(1) == 5);
	CHECK(expression.refers_to("dual"));
	CHECK_FALSE(expression.refers_to("sin"));
	CHECK_FALSE(expression.refers_to("e1"));
	CHECK(parse("1 + e1 * pi")->variables().empty());
	CHECK(columns_of(*parse("a +\n  ä + b")) == std::vector<int>{ 1, 3, 7 });
}

TEST_CASE("renaming a variable leaves the rest of the text unchanged") {
	const char *text = "a +ab * abs(a) ^ -a ";
	CHECK(with_variable_renamed(text, "a", "center") == "center +ab * abs(center) ^ -center ");
	CHECK(with_variable_renamed(text, "ab", "ä") == "a +ä * abs(a) ^ -a ");
	CHECK(with_variable_renamed(text, "abs", "x") == text);
	CHECK(with_variable_renamed(text, "missing", "x") == text);
}

TEST_CASE("literals and arguments have their offsets") {
	const Expression expression = *parse("max(1.5, -20)");
	CHECK(expression.nodes()[0].offset == 4);
	CHECK(expression.nodes()[0].length == 3);
	CHECK(expression.nodes()[1].offset == 10);
	CHECK(expression.nodes()[1].length == 2);
	const Node &call = expression.nodes().back();
	CHECK(call.kind == NodeKind::CALL);
	CHECK(functions()[call.index].name == "max");
	CHECK(expression.argument_offsets()[call.first_argument] == 4);
	CHECK(expression.argument_offsets()[call.first_argument + 1] == 9);
}
