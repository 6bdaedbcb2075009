#include "playground/expression/functions.hpp"

#include "cga/algebra/null_basis.hpp"
#include "cga/motor/motor_multivector.hpp"
#include "playground/expression/function_table.hpp"
#include "playground/expression/names.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace playground {

namespace {

using cga::Multivector;

// Coefficients below this fraction of the largest count as zero.
constexpr double ROUNDING = 1e-12;
// The square of a point is a sum of squares with mixed signs: below this fraction of their absolute sum it counts as zero.
constexpr double NULL_ROUNDING = 1e-13;

// Whether all coefficients outside `is_kept` are zero within rounding.
template <class IsKept>
bool has_only(const Multivector &x, IsKept is_kept) {
	const double largest = x.max_abs() * ROUNDING;
	for (int index = 0; index < cga::BLADE_COUNT; ++index) {
		if (!is_kept(index) && std::abs(x[index]) > largest) {
			return false;
		}
	}
	return true;
}

bool is_vector(const Multivector &x) {
	return has_only(x, [](int index) { return index >= 1 && index <= 3; });
}

bool is_point(const Multivector &x) {
	if (!has_only(x, [](int index) { return cga::blade_grade(index) == 1; })) {
		return false;
	}
	const Multivector unit = x * (1.0 / x.max_abs());
	double sum_of_squares = 0.0;
	for (const double coefficient : unit.coefficients()) {
		sum_of_squares += coefficient * coefficient;
	}
	return std::abs(unit.scalar_product(unit)) <= NULL_ROUNDING * sum_of_squares && cga::position_of(x).has_value();
}

// w - z e12 + y e13 - x e23
cga::Quaternion<double> rotor_quaternion(const Multivector &x) {
	return { x[0], -x[cga::E23], x[cga::E13], -x[cga::E12] };
}

bool is_rotor(const Multivector &x) {
	return x.max_abs() > 0.0 && has_only(x, [](int index) { return cga::blade_grade(index) % 2 == 0 && (cga::BLADE_BITMAPS[size_t(index)] & (cga::E4_BIT | cga::E5_BIT)) == 0; });
}

std::optional<cga::Pose<double>> pose_of(const Multivector &x) {
	const std::optional<cga::Motor<double>> motor = cga::to_motor(x);
	return motor ? motor->to_pose() : std::nullopt;
}

std::vector<Function> collect(std::initializer_list<FunctionTable> tables) {
	std::map<std::string_view, Function> by_name;
	for (const FunctionTable &table : tables) {
		for (const Overload *overload = table.first; overload != table.first + table.count; ++overload) {
			Function &function = by_name[overload->name];
			function.name = overload->name;
			function.overloads.push_back(overload);
		}
	}
	std::vector<Function> functions;
	functions.reserve(by_name.size());
	for (auto &entry : by_name) {
		functions.push_back(std::move(entry.second));
	}
	return functions;
}

} // namespace

cga::Vector3<double> Arguments::vector(size_t index) const {
	const Multivector &x = _values[index];
	return { x[1], x[2], x[3] };
}

cga::Vector3<double> Arguments::location(size_t index) const {
	return is_vector(_values[index]) ? vector(index) : *cga::position_of(_values[index]);
}

cga::Quaternion<double> Arguments::rotation(size_t index) const {
	const Multivector &x = _values[index];
	return glm::normalize(rotor_quaternion(x * (1.0 / x.max_abs())));
}

cga::Pose<double> Arguments::pose(size_t index) const {
	return *pose_of(_values[index]);
}

cga::Vector3<double> Arguments::numbers(size_t index) const {
	return { number(index), number(index + 1), number(index + 2) };
}

std::string Overload::signature() const {
	return std::string(name) + "(" + std::string(parameters) + ")";
}

bool Function::is_costly() const {
	constexpr std::string_view COSTLY[] = { "meet", "join", "project_onto", "reject_from", "reflect_in" };
	return std::find(std::begin(COSTLY), std::end(COSTLY), name) != std::end(COSTLY);
}

bool Function::takes(size_t count) const {
	return std::any_of(overloads.begin(), overloads.end(), [count](const Overload *overload) { return overload->count == count; });
}

size_t Function::max_arguments() const {
	return (*std::max_element(overloads.begin(), overloads.end(), [](const Overload *left, const Overload *right) { return left->count < right->count; }))->count;
}

std::string Function::counts() const {
	std::string text;
	const size_t max = max_arguments();
	for (size_t count = 1; count <= max; ++count) {
		if (takes(count)) {
			text += (text.empty() ? "" : (count == max ? " or " : ", ")) + std::to_string(count);
		}
	}
	return text + (max == 1 ? " argument" : " arguments");
}

const std::vector<Function> &functions() {
	static const std::vector<Function> ALL = collect({ number_functions(), product_functions(), versor_functions(), object_functions() });
	return ALL;
}

std::optional<size_t> find_function(std::string_view name) {
	const std::vector<Function> &all = functions();
	const auto found = std::lower_bound(all.begin(), all.end(), name, [](const Function &function, std::string_view wanted) { return function.name < wanted; });
	if (found == all.end() || found->name != name) {
		return std::nullopt;
	}
	return size_t(found - all.begin());
}

std::string correction(const std::string &variable, const std::vector<std::string_view> &variables) {
	if (find_function(variable)) {
		return "; to call the function write '" + variable + "('";
	}
	std::vector<std::string_view> candidates = { "eo", "einf", "pi", "tau" };
	if (variables.size() <= MAX_CANDIDATES) {
		candidates.insert(candidates.end(), variables.begin(), variables.end());
	}
	return suggestion(variable, candidates);
}

bool is_of_kind(const Multivector &value, ArgumentKind kind) {
	switch (kind) {
		case ArgumentKind::ANY:
			return true;
		case ArgumentKind::NUMBER:
			return has_only(value, [](int index) { return index == 0; });
		case ArgumentKind::VECTOR:
			return is_vector(value);
		case ArgumentKind::LOCATION:
			return is_vector(value) || is_point(value);
		case ArgumentKind::ROTATION:
			return is_rotor(value);
		case ArgumentKind::MOTOR:
			return pose_of(value).has_value();
	}
	return false;
}

std::string_view kind_text(ArgumentKind kind) {
	constexpr std::string_view TEXTS[] = {
		"a multivector",
		"a number",
		"a vector (of e1, e2, e3)",
		"a point or a vector (of e1, e2, e3)",
		"a rotor about the origin",
		"a motor (a product of translators, rotors and dilators)",
	};
	return TEXTS[size_t(kind)];
}

} // namespace playground
