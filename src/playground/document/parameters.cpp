#include "playground/document/parameters.hpp"

#include "playground/expression/evaluate.hpp"
#include "playground/expression/functions.hpp"
#include "playground/expression/parser.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace playground {

namespace {

constexpr std::string_view ROTATION = "rotation";

// Functions that construct an object.
constexpr std::string_view CONSTRUCTORS[] = {
	"scalar", "vector", "point", "flat_point", "point_pair", "pair", "line", "line_through",
	"circle", "circle_through", "plane", "plane_through", "sphere", "sphere_through",
	"imaginary_point_pair", "imaginary_circle", "imaginary_sphere",
	"tangent_along", "tangent_across", "direction", "direction_across",
	"translator", "rotor", "dilator", "motor", "motor_from"
};

// The names of the vectors that the arguments x, y, z form.
constexpr std::pair<std::string_view, std::string_view> VECTOR_NAMES[] = {
	{ "vector", "vector" },
	{ "point", "position" },
	{ "flat_point", "position" },
	{ "plane", "normal" },
	{ "sphere", "center" },
	{ "translator", "offset" },
};

constexpr std::string_view WRAPPERS[] = { "dual", "undual", "reverse", "normalized", "normalize" };

// Strips signs, duals and parentheses.
TokenRange unwrapped(TokenRange range) {
	for (;;) {
		const TokenKind first = range.size() > 1 ? range[0].kind : TokenKind::END;
		if (first == TokenKind::PLUS || first == TokenKind::MINUS || first == TokenKind::TILDE || first == TokenKind::EXCLAMATION) {
			range = range.part(1, range.size());
			continue;
		}
		if (first == TokenKind::OPEN && range.after_parenthesis(0) == range.size()) {
			range = range.part(1, range.size() - 1);
			continue;
		}
		const std::vector<TokenRange> arguments = range.arguments();
		if (arguments.size() != 1 || std::find(std::begin(WRAPPERS), std::end(WRAPPERS), range.text(0)) == std::end(WRAPPERS)) {
			return range;
		}
		range = arguments[0];
	}
}

std::vector<std::string_view> split(std::string_view parameters) {
	std::vector<std::string_view> names;
	for (size_t start = 0; start <= parameters.size();) {
		const size_t end = std::min(parameters.find(", ", start), parameters.size());
		names.push_back(parameters.substr(start, end - start));
		start = end + 2;
	}
	return names;
}

std::string_view vector_name_of(std::string_view constructor) {
	const auto *const found = std::find_if(std::begin(VECTOR_NAMES), std::end(VECTOR_NAMES), [constructor](const auto &candidate) { return candidate.first == constructor; });
	return found == std::end(VECTOR_NAMES) ? std::string_view() : found->second;
}

// The first overload of a constructor that accepts the arguments, where an argument with variables matches any kind. Null if
// there is none, or `call` calls no constructor.
const Overload *overload_of(const TokenRange &call, const std::vector<TokenRange> &arguments) {
	if (arguments.empty() || std::find(std::begin(CONSTRUCTORS), std::end(CONSTRUCTORS), call.text(0)) == std::end(CONSTRUCTORS)) {
		return nullptr;
	}
	std::vector<std::optional<cga::Multivector>> values;
	for (const TokenRange &argument : arguments) {
		const cga::TextResult<cga::Multivector> value = evaluate(argument.text());
		values.push_back(value ? std::optional<cga::Multivector>(*value) : std::nullopt);
	}
	for (const Overload *overload : functions()[*find_function(call.text(0))].overloads) {
		bool fits = overload->count == arguments.size();
		for (size_t index = 0; fits && index < values.size(); ++index) {
			fits = !values[index] || is_of_kind(*values[index], overload->kinds[index]);
		}
		if (fits) {
			return overload;
		}
	}
	return nullptr;
}

// Axis and angle of a rotation. Of the two opposite axes, returns the one closer to the old axis.
std::pair<cga::Vector3<double>, double> axis_and_angle(cga::Quaternion<double> rotation, const cga::Vector3<double> &old_axis) {
	const cga::Vector3<double> sines(rotation.x, rotation.y, rotation.z);
	const double size = glm::length(sines);
	if (size == 0.0) {
		return { old_axis, 0.0 };
	}
	const double sign = glm::dot(sines, old_axis) < 0.0 ? -1.0 : 1.0;
	const cga::Vector3<double> axis = sines * (sign / size);
	double angle = 2.0 * std::atan2(sign * size, rotation.w);
	constexpr double PI = 3.14159265358979323846;
	angle = angle > PI ? angle - 2.0 * PI : (angle < -PI ? angle + 2.0 * PI : angle);
	const double old_size = glm::length(old_axis);
	const bool is_old = old_size > 0.0 && glm::distance(axis, old_axis / old_size) < 1e-6;
	return { is_old ? old_axis : axis, angle };
}

class Collector {
public:
	std::vector<Parameter> found;

	void collect(const TokenRange &call) {
		const std::vector<TokenRange> arguments = call.arguments();
		const Overload *overload = overload_of(call, arguments);
		if (!overload) {
			return;
		}
		const std::vector<std::string_view> names = split(overload->parameters);
		size_t index = 0;
		if (names[0] == "x" && names.size() >= 3) {
			const bool is_quaternion = names.back() == "w";
			const size_t count = is_quaternion ? 4 : 3;
			const std::optional<Literal> group = group_literal(arguments, count);
			add(is_quaternion ? ROTATION : vector_name_of(overload->name), group);
			index = group ? count : 0;
		}
		for (; index < arguments.size(); ++index) {
			collect_argument(arguments[index], overload->kinds[index], names[index]);
		}
		if (overload->name == "rotor" && overload->kinds[0] == ArgumentKind::VECTOR) {
			add_rotation();
		}
	}

private:
	void add(std::string_view name, std::optional<Literal> literal) {
		if (literal) {
			found.push_back({ std::string(name), std::move(*literal) });
		}
	}

	void collect_argument(const TokenRange &argument, ArgumentKind kind, std::string_view name) {
		switch (kind) {
			case ArgumentKind::NUMBER:
				add(name, number_literal(argument));
				break;
			case ArgumentKind::VECTOR:
			case ArgumentKind::LOCATION:
				add(name, vector_literal(argument));
				break;
			case ArgumentKind::ROTATION:
				if (number_literal(argument)) {
					add(ROTATION, Literal{ Literal::ROTOR, cga::Quaternion<double>(1.0, 0.0, 0.0, 0.0), { argument.span() } });
				} else if (argument.size() > 0 && argument.text(0) == "rotor") {
					collect(argument);
				}
				break;
			case ArgumentKind::ANY:
			case ArgumentKind::MOTOR:
				break;
		}
	}

	// If the last two parameters are axis and angle, adds their quaternion, which has no span of its own.
	void add_rotation() {
		if (found.size() < 2 || found[found.size() - 2].name != "axis" || found.back().name != "angle") {
			return;
		}
		const cga::Vector3<double> axis = *std::get_if<cga::Vector3<double>>(&found[found.size() - 2].literal.value);
		const double angle = *std::get_if<double>(&found.back().literal.value);
		const double size = glm::length(axis);
		if (size > 0.0 && std::isfinite(size)) {
			const cga::Vector3<double> sines = axis * (std::sin(0.5 * angle) / size);
			found.push_back({ std::string(ROTATION), Literal{ Literal::ROTOR, cga::Quaternion<double>(std::cos(0.5 * angle), sines.x, sines.y, sines.z), {} } });
		}
	}
};

const Parameter *find(const std::vector<Parameter> &parameters, std::string_view name) {
	const auto found = std::find_if(parameters.begin(), parameters.end(), [name](const Parameter &parameter) { return parameter.name == name; });
	return found == parameters.end() ? nullptr : &*found;
}

} // namespace

std::vector<Argument> arguments_of(std::string_view text) {
	const std::vector<Token> tokens = parse(text) ? tokens_of(text) : std::vector<Token>();
	const TokenRange call = unwrapped({ text, tokens.data(), tokens.data() + tokens.size() });
	const std::vector<TokenRange> arguments = call.arguments();
	const Overload *overload = overload_of(call, arguments);
	std::vector<Argument> found;
	for (size_t index = 0; overload && index < arguments.size(); ++index) {
		found.push_back({ split(overload->parameters)[index], arguments[index].text() });
	}
	return found;
}

std::vector<Parameter> parameters_of(std::string_view text) {
	const std::vector<Token> tokens = parse(text) ? tokens_of(text) : std::vector<Token>();
	if (tokens.empty()) {
		return {};
	}
	const TokenRange all(text, tokens.data(), tokens.data() + tokens.size());
	Collector collector;
	if (const std::optional<Literal> number = number_literal(all)) {
		collector.found.push_back({ "value", *number });
	}
	const TokenRange inner = unwrapped(all);
	const bool is_list = inner.is(0, TokenKind::LIST);
	if (const std::optional<Literal> multivector = multivector_literal(is_list ? inner : all)) {
		collector.found.push_back({ "coefficients", *multivector });
	}
	collector.collect(inner);
	return std::move(collector.found);
}

cga::Result<std::string, Error> with_parameter(std::string_view text, std::string_view name, const LiteralValue &value) {
	constexpr const char *TYPES[] = { "a number", "a vector", "a rotation", "32 coefficients" };
	const std::vector<Parameter> parameters = parameters_of(text);
	const Parameter *parameter = find(parameters, name);
	if (!parameter) {
		std::string names;
		for (const Parameter &known : parameters) {
			names += (names.empty() ? "; it has " : ", ") + known.name;
		}
		return Error("the expression has no parameter '" + cga::shortened(name) + "'" + (names.empty() ? "; only literals of constructors can be set: write a number or a call such as point(1, 2, 3)" : names));
	}
	if (parameter->literal.value.index() != value.index()) {
		return Error("the parameter '" + parameter->name + "' must be " + TYPES[parameter->literal.value.index()] + ", not " + TYPES[value.index()]);
	}
	if (!is_finite(value)) {
		return Error("the parameter '" + parameter->name + "' must be finite");
	}
	if (is_same(parameter->literal.value, value)) {
		return std::string(text);
	}
	if (!parameter->literal.spans.empty()) {
		return edited(text, edits_for(parameter->literal, value));
	}
	// A rotation given as axis and angle.
	const Literal &axis = find(parameters, "axis")->literal;
	const Literal &angle = find(parameters, "angle")->literal;
	const auto [new_axis, new_angle] = axis_and_angle(*std::get_if<cga::Quaternion<double>>(&value), *std::get_if<cga::Vector3<double>>(&axis.value));
	std::vector<TextEdit> edits = edits_for(axis, new_axis);
	for (TextEdit &edit : edits_for(angle, new_angle)) {
		edits.push_back(std::move(edit));
	}
	return edited(text, std::move(edits));
}

} // namespace playground
