#include "playground/document/literal.hpp"

#include "cga/text/json.hpp"
#include "cga/text/json_reader.hpp"
#include "cga/text/number_text.hpp"
#include "cga/text/text.hpp"
#include "playground/document/number_digits.hpp"
#include "playground/expression/evaluate.hpp"
#include "playground/expression/functions.hpp"
#include "playground/expression/names.hpp"

#include <algorithm>
#include <cmath>

namespace playground {

namespace {

constexpr double RADIANS = 3.14159265358979323846 / 180.0;

bool is_sign(TokenKind kind) {
	return kind == TokenKind::PLUS || kind == TokenKind::MINUS;
}

bool is_in(std::string_view name, std::initializer_list<std::string_view> names) {
	return std::find(names.begin(), names.end(), name) != names.end();
}

// Whether all tokens could belong to a sum of products of numbers and basis blades.
bool has_only_blades(const TokenRange &range) {
	for (size_t index = 0; index < range.size(); ++index) {
		const TokenKind kind = range[index].kind;
		const bool is_operator = is_sign(kind) || kind == TokenKind::STAR || kind == TokenKind::WEDGE;
		const bool is_blade = kind == TokenKind::NAME && constant(range.text(index)) && !is_in(range.text(index), { "pi", "tau" });
		if (!is_operator && !is_blade && kind != TokenKind::NUMBER) {
			return false;
		}
	}
	return range.size() > 0;
}

std::vector<double> components_of(const LiteralValue &value) {
	if (const double *number = std::get_if<double>(&value)) {
		return { *number };
	}
	if (const cga::Vector3<double> *vector = std::get_if<cga::Vector3<double>>(&value)) {
		return { vector->x, vector->y, vector->z };
	}
	if (const cga::Quaternion<double> *rotation = std::get_if<cga::Quaternion<double>>(&value)) {
		return { rotation->x, rotation->y, rotation->z, rotation->w };
	}
	const cga::Multivector::Coefficients &coefficients = std::get_if<cga::Multivector>(&value)->coefficients();
	return { coefficients.begin(), coefficients.end() };
}

bool is_same_component(double left, double right, size_t count) {
	const bool is_single = count == 3 || count == 4;
	return is_single ? float(left) == float(right) : left == right;
}

double max_abs(const std::vector<double> &components) {
	double largest = 0.0;
	for (const double component : components) {
		largest = std::max(largest, std::abs(component));
	}
	return largest;
}

// "e1 - 2 e3", "0"
std::string sum_text(const std::vector<double> &components) {
	std::string text;
	const double size = max_abs(components);
	for (size_t index = 0; index < components.size(); ++index) {
		const std::string number = number_text(std::abs(components[index]), size);
		if (number != "0") {
			const bool is_negative = components[index] < 0.0;
			text += text.empty() ? (is_negative ? "-" : "") : (is_negative ? " - " : " + ");
			text += (number == "1" ? "" : number + " ") + "e" + std::to_string(index + 1);
		}
	}
	return text.empty() ? "0" : text;
}

std::string rotor_text(const std::vector<double> &components) {
	std::string text = "rotor(";
	for (size_t index = 0; index < components.size(); ++index) {
		text += (index > 0 ? ", " : "") + number_text(components[index], 1.0);
	}
	return text + ")";
}

// The spans of the 32 numbers in a list.
std::optional<Literal> list_literal(const TokenRange &range) {
	const cga::TextResult<cga::Multivector> value = cga::from_json(range.text());
	if (!value) {
		return std::nullopt;
	}
	Literal literal{ Literal::NUMBERS, *value, {} };
	cga::JsonReader reader(range.text());
	reader.take('[', "'['");
	do {
		reader.next_character();
		const size_t start = reader.position();
		reader.read_number();
		literal.spans.push_back({ range.span().offset + start, reader.position() - start });
	} while (reader.next_is(',') && reader.take(',', "','"));
	return literal;
}

} // namespace

TextSpan TokenRange::span() const {
	return size() == 0 ? TextSpan() : TextSpan{ _first->offset, _last[-1].offset + _last[-1].length - _first->offset };
}

size_t TokenRange::after_parenthesis(size_t open) const {
	size_t depth = 0;
	for (size_t index = open; index < size(); ++index) {
		depth += is(index, TokenKind::OPEN) ? 1 : 0;
		depth -= is(index, TokenKind::CLOSE) ? 1 : 0;
		if (depth == 0) {
			return index + 1;
		}
	}
	return size() + 1;
}

std::vector<TokenRange> TokenRange::arguments() const {
	if (!is(0, TokenKind::NAME) || !is(1, TokenKind::OPEN) || after_parenthesis(1) != size()) {
		return {};
	}
	std::vector<TokenRange> found;
	size_t start = 2;
	size_t depth = 0;
	for (size_t index = 2; index < size(); ++index) {
		const TokenKind kind = _first[index].kind;
		if (depth == 0 && (kind == TokenKind::COMMA || index + 1 == size())) {
			found.push_back(part(start, index));
			start = index + 1;
		}
		depth += kind == TokenKind::OPEN ? 1 : 0;
		depth -= kind == TokenKind::CLOSE && depth > 0 ? 1 : 0;
	}
	return found;
}

std::vector<Token> tokens_of(std::string_view text) {
	std::vector<Token> tokens;
	Lexer lexer(text);
	for (Token token = lexer.next(); token.kind != TokenKind::END; token = lexer.next()) {
		if (token.kind == TokenKind::INVALID) {
			return {};
		}
		tokens.push_back(token);
	}
	return tokens;
}

std::optional<Literal> number_literal(const TokenRange &range) {
	const std::vector<TokenRange> arguments = range.arguments();
	if (arguments.size() == 1 && is_in(range.text(0), { "deg", "deg_to_rad" })) {
		std::optional<Literal> degrees = number_literal(arguments[0]);
		if (!degrees || degrees->form != Literal::NUMBERS) {
			return std::nullopt;
		}
		degrees->form = Literal::DEGREES;
		degrees->value = *std::get_if<double>(&degrees->value) * RADIANS;
		return degrees;
	}
	if (range.size() == 0 || !range.is(range.size() - 1, TokenKind::NUMBER)) {
		return std::nullopt;
	}
	double sign = 1.0;
	for (size_t index = 0; index + 1 < range.size(); ++index) {
		if (!is_sign(range[index].kind)) {
			return std::nullopt;
		}
		sign = range.is(index, TokenKind::MINUS) ? -sign : sign;
	}
	return Literal{ Literal::NUMBERS, sign * range[range.size() - 1].number, { range.span() } };
}

std::optional<Literal> vector_literal(const TokenRange &range) {
	const std::vector<TokenRange> arguments = range.arguments();
	if (arguments.size() == 1 && range.text(0) == "point") {
		return vector_literal(arguments[0]);
	}
	if (arguments.size() == 3 && is_in(range.text(0), { "vector", "point" })) {
		return group_literal(arguments, 3);
	}
	if (range.size() == 1 && range.text(0) == "eo") {
		return Literal{ Literal::SUM, cga::Vector3<double>(0.0), { range.span() } };
	}
	if (!has_only_blades(range)) {
		return std::nullopt;
	}
	const cga::TextResult<cga::Multivector> value = evaluate(range.text());
	if (!value || !is_of_kind(*value, ArgumentKind::VECTOR)) {
		return std::nullopt;
	}
	return Literal{ Literal::SUM, cga::Vector3<double>((*value)[1], (*value)[2], (*value)[3]), { range.span() } };
}

std::optional<Literal> multivector_literal(const TokenRange &range) {
	if (range.size() == 1 && range.is(0, TokenKind::LIST)) {
		return list_literal(range);
	}
	if (!has_only_blades(range)) {
		return std::nullopt;
	}
	const cga::TextResult<cga::Multivector> value = evaluate(range.text());
	return value ? std::optional<Literal>(Literal{ Literal::BLADES, *value, { range.span() } }) : std::nullopt;
}

std::optional<Literal> group_literal(const std::vector<TokenRange> &arguments, size_t count) {
	double values[4] = {};
	Literal group;
	for (size_t index = 0; index < count; ++index) {
		const std::optional<Literal> number = number_literal(arguments[index]);
		if (!number || number->form != Literal::NUMBERS) {
			return std::nullopt;
		}
		values[index] = *std::get_if<double>(&number->value);
		group.spans.push_back(number->spans[0]);
	}
	if (count == 4) {
		group.value = cga::Quaternion<double>(values[3], values[0], values[1], values[2]);
	} else {
		group.value = cga::Vector3<double>(values[0], values[1], values[2]);
	}
	return group;
}

bool is_finite(const LiteralValue &value) {
	const std::vector<double> components = components_of(value);
	return std::all_of(components.begin(), components.end(), [](double component) { return std::isfinite(component); });
}

bool is_same(const LiteralValue &left, const LiteralValue &right) {
	const std::vector<double> before = components_of(left);
	const std::vector<double> after = components_of(right);
	return std::equal(before.begin(), before.end(), after.begin(), after.end(), [&after](double old_one, double new_one) { return is_same_component(old_one, new_one, after.size()); });
}

std::vector<TextEdit> edits_for(const Literal &literal, const LiteralValue &value) {
	if (is_same(literal.value, value)) {
		return {};
	}
	const std::vector<double> before = components_of(literal.value);
	const std::vector<double> after = components_of(value);
	switch (literal.form) {
		case Literal::DEGREES:
			return { { literal.spans[0], number_text(after[0] / RADIANS, 0.0) } };
		case Literal::SUM:
			return { { literal.spans[0], sum_text(after) } };
		case Literal::ROTOR:
			return { { literal.spans[0], rotor_text(after) } };
		case Literal::BLADES:
			return { { literal.spans[0], cga::to_text(*std::get_if<cga::Multivector>(&value)) } };
		case Literal::NUMBERS:
			break;
	}
	std::vector<TextEdit> edits;
	const double size = max_abs(after);
	for (size_t index = 0; index < literal.spans.size(); ++index) {
		if (!is_same_component(before[index], after[index], after.size())) {
			std::string text;
			if (after.size() == size_t(cga::BLADE_COUNT)) {
				cga::append_number(text, after[index]);
			} else {
				text = number_text(after[index], size);
			}
			edits.push_back({ literal.spans[index], std::move(text) });
		}
	}
	return edits;
}

std::string edited(std::string_view text, std::vector<TextEdit> edits) {
	std::sort(edits.begin(), edits.end(), [](const TextEdit &left, const TextEdit &right) { return left.span.offset < right.span.offset; });
	std::string result;
	size_t copied = 0;
	for (const TextEdit &edit : edits) {
		result.append(text, copied, edit.span.offset - copied);
		result += edit.text;
		copied = edit.span.offset + edit.span.length;
	}
	return result.append(text, copied, std::string::npos);
}

} // namespace playground
