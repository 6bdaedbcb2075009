#include "playground/expression/evaluate.hpp"

#include "cga/versor/inverse.hpp"
#include "playground/expression/functions.hpp"
#include "playground/expression/names.hpp"
#include "playground/expression/parser.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace playground {

namespace {

using cga::Multivector;

bool is_number(const Multivector &x) {
	return is_of_kind(x, ArgumentKind::NUMBER);
}

// Division by a number is exact in each coefficient; any other quotient is X Y^-1.
FunctionResult divide(const Multivector &left, const Multivector &right) {
	if (is_number(right)) {
		if (right[0] == 0.0) {
			return Error("division by zero");
		}
		Multivector quotient = left;
		for (int index = 0; index < cga::BLADE_COUNT; ++index) {
			quotient[index] /= right[0];
		}
		return quotient;
	}
	const cga::MultivectorResult inverse = cga::inverse(right);
	if (!inverse) {
		return Error(inverse.error());
	}
	return left.geometric_product(*inverse);
}

FunctionResult binary(NodeKind kind, const Multivector &left, const Multivector &right) {
	switch (kind) {
		case NodeKind::ADD:
			return left + right;
		case NodeKind::SUBTRACT:
			return left - right;
		case NodeKind::DIVIDE:
			return divide(left, right);
		case NodeKind::OUTER:
			return left.outer_product(right);
		case NodeKind::INNER:
			return left.inner_product(right);
		case NodeKind::LEFT_CONTRACTION:
			return left.left_contraction(right);
		case NodeKind::RIGHT_CONTRACTION:
			return left.right_contraction(right);
		case NodeKind::REGRESSIVE:
			return left.regressive_product(right);
		default:
			return is_number(left) ? right * left[0] : left.geometric_product(right);
	}
}

constexpr const char *ORDINALS[MAX_ARGUMENTS] = { "first", "second", "third", "fourth" };

// Evaluates the nodes in order, on a stack of values.
class Evaluation {
public:
	// `values` in the order of the expression's variables(), null where unknown; `known` has the names to suggest instead.
	Evaluation(const Expression &expression, const std::vector<const Multivector *> &values, const Variables &known) :
			_expression(expression), _values(values), _known(known) {
		_stack.reserve(size_t(expression.stack_size()));
	}

	cga::TextResult<Multivector> run() {
		for (const Node &node : _expression.nodes()) {
			if (!step(node)) {
				return *_error;
			}
			if (!_stack.back().is_finite()) {
				fail(node, node.kind == NodeKind::VARIABLE ? "'" + text_of(node) + "' has a coefficient that is not finite" : "the result of '" + text_of(node) + "' is too large");
				return *_error;
			}
		}
		return _stack.back();
	}

private:
	std::string text_of(const Node &node) const { return cga::shortened(std::string_view(_expression.text()).substr(node.offset, node.length)); }

	bool fail_at(size_t offset, std::string message) {
		_error = cga::text_error(_expression.text(), offset, std::move(message));
		return false;
	}

	bool fail(const Node &node, std::string message) { return fail_at(node.offset, std::move(message)); }

	Multivector pop() {
		const Multivector value = _stack.back();
		_stack.pop_back();
		return value;
	}

	bool push(const Node &node, const FunctionResult &result) {
		if (!result) {
			return fail(node, result.error().message);
		}
		_stack.push_back(*result);
		return true;
	}

	bool step(const Node &node) {
		switch (node.kind) {
			case NodeKind::NUMBER:
				return push(node, Multivector::scalar(node.number));
			case NodeKind::CONSTANT:
				return push(node, _expression.constants()[node.index]);
			case NodeKind::VARIABLE:
				return push_variable(node);
			case NodeKind::NEGATE:
				return push(node, -pop());
			case NodeKind::REVERSE:
				return push(node, pop().reverse());
			case NodeKind::DUAL:
				return push(node, pop().dual());
			case NodeKind::CALL:
				return call(node);
			default: {
				const Multivector right = pop();
				const Multivector left = pop();
				return push(node, binary(node.kind, left, right));
			}
		}
	}

	bool push_variable(const Node &node) {
		const Multivector *value = _values[node.index];
		if (!value) {
			return fail_unknown(node, _expression.variables()[node.index]);
		}
		_stack.push_back(*value);
		return true;
	}

	bool fail_unknown(const Node &node, const std::string &name) {
		std::vector<std::string_view> names;
		for (const auto &variable : _known) {
			names.push_back(variable.first);
		}
		return fail(node, "unknown name '" + name + "'" + correction(name, names));
	}

	bool call(const Node &node) {
		const Function &function = functions()[node.index];
		const Multivector *arguments = _stack.data() + _stack.size() - node.arguments;
		const Overload *overload = nullptr;
		for (const Overload *candidate : function.overloads) {
			if (!overload && candidate->count == node.arguments && fitting_arguments(*candidate, arguments) == node.arguments) {
				overload = candidate;
			}
		}
		if (!overload) {
			return fail_arguments(node, function, arguments);
		}
		const FunctionResult result = overload->call(Arguments(arguments));
		_stack.resize(_stack.size() - node.arguments);
		return result ? push(node, result) : fail(node, std::string(function.name) + ": " + result.error().message);
	}

	// The number of leading arguments that match the overload.
	static size_t fitting_arguments(const Overload &overload, const Multivector *arguments) {
		size_t index = 0;
		while (index < overload.count && is_of_kind(arguments[index], overload.kinds[index])) {
			++index;
		}
		return index;
	}

	// Reports the first argument that does not fit, judged by the overloads that match the most arguments before it.
	bool fail_arguments(const Node &node, const Function &function, const Multivector *arguments) {
		size_t furthest = 0;
		std::vector<const Overload *> candidates;
		for (const Overload *overload : function.overloads) {
			if (overload->count == node.arguments) {
				const size_t fitting = fitting_arguments(*overload, arguments);
				if (fitting > furthest) {
					candidates.clear();
				}
				furthest = std::max(furthest, fitting);
				if (fitting == furthest) {
					candidates.push_back(overload);
				}
			}
		}
		std::string kinds;
		std::string signatures;
		for (const Overload *overload : candidates) {
			const std::string kind(kind_text(overload->kinds[furthest]));
			// "a point or a vector" already includes "a vector".
			if (kind.find(kinds) != std::string::npos) {
				kinds = kind;
			} else if (kinds.find(kind) == std::string::npos) {
				kinds += " or " + kind;
			}
			signatures += (signatures.empty() ? "" : " or ") + overload->signature();
		}
		const size_t offset = _expression.argument_offsets()[node.first_argument + furthest];
		return fail_at(offset, "expected " + kinds + " as " + ORDINALS[furthest] + " argument of " + signatures);
	}

	const Expression &_expression;
	const std::vector<const Multivector *> &_values;
	const Variables &_known;
	std::vector<Multivector> _stack;
	std::optional<cga::TextError> _error;
};

} // namespace

cga::TextResult<Multivector> evaluate(const Expression &expression, const Variables &variables) {
	std::vector<const Multivector *> values;
	for (const std::string &name : expression.variables()) {
		const auto found = variables.find(name);
		values.push_back(found == variables.end() ? nullptr : &found->second);
	}
	return Evaluation(expression, values, variables).run();
}

cga::TextResult<Multivector> evaluate(const Expression &expression, const std::vector<const Multivector *> &values) {
	return Evaluation(expression, values, {}).run();
}

cga::TextResult<Multivector> evaluate(std::string_view text, const Variables &variables) {
	for (const auto &variable : variables) {
		if (const cga::Result<void, Error> checked = check_name(variable.first); !checked) {
			return cga::text_error(text, 0, "invalid variable name: " + checked.error().message);
		}
	}
	const cga::TextResult<Expression> expression = parse(text);
	if (!expression) {
		return expression.error();
	}
	return evaluate(*expression, variables);
}

} // namespace playground
