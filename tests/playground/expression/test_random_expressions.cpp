// Evaluates tens of thousands of random expressions: valid, mutated and random tokens. Each must give a finite value or an
// error with a position, within bounded time.

#include "playground/expression/evaluate.hpp"

#include "../../cga/random_poses.hpp"
#include "cga/text/utf8.hpp"
#include "playground/expression/functions.hpp"
#include "playground/expression/parser.hpp"

#include <doctest/doctest.h>

#include <chrono>

using namespace playground;
using cga::Multivector;

namespace {

class ExpressionMaker {
public:
	explicit ExpressionMaker(unsigned seed) :
			_engine(seed) {}

	size_t below(size_t count) { return _engine() % count; }

	template <size_t COUNT>
	std::string one_of(const char *const (&texts)[COUNT]) { return texts[below(COUNT)]; }

	// Valid by the grammar; operands and arguments of any kind.
	std::string make(int depth) {
		if (depth <= 0) {
			return one_of(OPERANDS);
		}
		switch (below(6)) {
			case 0:
				return one_of({ "-", "~", "!", "+" }) + make(depth - 1);
			case 1:
				return "(" + make(depth - 1) + ")";
			case 2:
			case 3: {
				const Function &function = functions()[below(functions().size())];
				const Overload &overload = *function.overloads[below(function.overloads.size())];
				std::string text = std::string(function.name) + "(";
				for (size_t index = 0; index < overload.count; ++index) {
					text += (index > 0 ? ", " : "") + argument(overload.kinds[index], depth - 1);
				}
				return text + ")";
			}
			default:
				return make(depth - 1) + one_of({ " + ", " - ", "*", " * ", " / ", " ^ ", " | ", "<<", " >> ", " & " }) + make(depth - 1);
		}
	}

	// Changes, erases, inserts or duplicates some bytes.
	std::string mutated(std::string text) {
		for (size_t change = 1 + below(4); change-- > 0 && !text.empty();) {
			const size_t at = below(text.size());
			switch (below(4)) {
				case 0:
					text[at] = char(below(256));
					break;
				case 1:
					text.erase(at, 1 + below(4));
					break;
				case 2:
					text.insert(at, one_of(PIECES));
					break;
				default:
					text.insert(at, text.substr(below(text.size()), below(20)));
			}
		}
		return text;
	}

	// Tokens in any order.
	std::string nonsense() {
		std::string text;
		for (size_t count = below(30); count-- > 0;) {
			text += below(8) == 0 ? std::string(functions()[below(functions().size())].name) + "(" : one_of(PIECES);
		}
		return text;
	}

private:
	// Mostly of the requested kind, so that most calls are evaluated.
	std::string argument(ArgumentKind kind, int depth) {
		if (below(4) == 0) {
			return make(depth - 1);
		}
		switch (kind) {
			case ArgumentKind::NUMBER:
				return one_of({ "0", "1", "-2", "0.5", "1e-9", "norm(a)", "pi", "1e+9", "-1e-300", "1e+300" });
			case ArgumentKind::VECTOR:
				return one_of({ "e1", "2 e2 - e3", "0", "vector(1, 2, 3)", "1e+200 e1", "1e-200 e2" });
			case ArgumentKind::LOCATION:
				return one_of({ "eo", "e1", "e1 + 2 e2 + 2.5 einf + eo", "1000 e3 + 500000 einf + eo", "vector(1, 2, 3)" });
			case ArgumentKind::ROTATION:
				return one_of({ "1", "rotor(e1, 3)", "e12", "1e+200 e23" });
			default:
				return below(2) == 0 ? make(depth - 1) : one_of(VERSORS);
		}
	}

	static constexpr const char *OPERANDS[] = { "a", "b", "c", "x", "e1", "e2", "e5", "e12", "e345", "einf", "eo", "I", "E", "0", "1", "-1", "2.5", "1e-300", "1e+300", "3 e12", "0.5 einf", "pi", "unknown" };
	static constexpr const char *VERSORS[] = { "e1", "a", "x", "translator(1, 2, 3)", "rotor(e1 + e2, 2)", "dilator(3)", "exp(a ^ e1)", "e12 + e34", "e1 + einf", "1e+200 e12", "1e-200 e1", "einf", "e1 ^ eo" };
	static constexpr const char *PIECES[] = { "(", ")", ",", "+", "-", "*", "/", "^", "|", "<<", ">>", "&", "~", "!", "1", ".", "e", "e1", "e12", "einf", "2.5", "1e", "1e+400", " ", "\n", "a", "sin(", "rotor(", "∧", "ä", "\xff", "<", "=", "#", "__", "9999999999999999999999" };

	std::mt19937_64 _engine;
};

struct Counts {
	int values = 0;
	int errors = 0;
};

void check(const std::string &text, const Variables &variables, Counts &counts) {
	const cga::TextResult<Multivector> result = evaluate(text, variables);
	if (result) {
		CHECK_MESSAGE(result->is_finite(), text);
		++counts.values;
		return;
	}
	++counts.errors;
	const cga::TextError &error = result.error();
	CHECK_MESSAGE(error.offset <= text.size(), text);
	CHECK_MESSAGE(error.column >= 1, text);
	CHECK_MESSAGE(!error.message.empty(), text);
	// Messages are valid UTF-8 for any text.
	for (size_t offset = 0; offset < error.message.size();) {
		const cga::Character character = cga::character_at(error.message, offset);
		CHECK_MESSAGE(character.is_valid, text);
		offset += character.length;
	}
}

} // namespace

TEST_CASE("random expressions have a finite value or an error with a position") {
	const auto start = std::chrono::steady_clock::now();
	cga_test::Random random(1);
	ExpressionMaker maker(2);
	Variables variables;
	Counts valid;
	Counts mutated;
	Counts nonsense;
	for (int repeat = 0; repeat < 20000; ++repeat) {
		if (repeat % 100 == 0) {
			variables = { { "a", random.multivector() }, { "b", random.multivector().grade(2) }, { "c", random.multivector().grade(1) * 1e150 }, { "x", Multivector::scalar(random.normal()) } };
		}
		const std::string text = maker.make(1 + repeat % 5);
		check(text, variables, valid);
		check(maker.mutated(text), variables, mutated);
		check(maker.nonsense(), variables, nonsense);
	}
	// Enough texts of each kind are evaluated, or refused.
	CHECK(valid.values > 5000);
	CHECK(valid.errors > 1000);
	CHECK(mutated.values > 300);
	CHECK(mutated.errors > 5000);
	CHECK(nonsense.errors > 10000);
	MESSAGE("values and errors: valid ", valid.values, " ", valid.errors, ", mutated ", mutated.values, " ", mutated.errors, ", nonsense ", nonsense.values, " ", nonsense.errors);
	CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(60));
}

TEST_CASE("the longest expressions of every function are evaluated in bounded time") {
	const auto start = std::chrono::steady_clock::now();
	for (const char *call : { "exp(a)", "log(exp(b))", "inverse(a)", "sqrt(exp(b))", "power(exp(b), 0.3)", "normalized(a)", "a*a*0", "1/a" }) {
		std::string text = call;
		while (text.size() + 30 < MAX_TEXT_LENGTH) {
			text += " + ";
			text += call;
		}
		cga_test::Random random(3);
		const cga::TextResult<Multivector> result = evaluate(text, { { "a", random.multivector() }, { "b", random.multivector().grade(2) } });
		CHECK_MESSAGE(result.has_value(), text);
	}
	CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
}
