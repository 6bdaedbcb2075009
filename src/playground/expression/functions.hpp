#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/motor/pose.hpp"
#include "cga/vector.hpp"
#include "playground/expression/error.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The functions of the expression language: one table for the parser, the evaluator, the test of the guide and the
// editor's help.

namespace playground {

// What an argument must be.
enum class ArgumentKind {
	ANY, // any multivector, numbers included
	NUMBER, // a scalar
	VECTOR, // x e1 + y e2 + z e3
	LOCATION, // a point of any weight, or a VECTOR
	ROTATION, // a rotor about the origin: 1, e12, e13, e23
	MOTOR, // a product of translators, rotors and dilators, of any weight and sign
};

inline constexpr size_t MAX_ARGUMENTS = 4;

// The arguments of a call. Each accessor requires the matching kind.
class Arguments {
public:
	explicit Arguments(const cga::Multivector *values) :
			_values(values) {}

	[[nodiscard]] const cga::Multivector &operator[](size_t index) const { return _values[index]; }
	[[nodiscard]] double number(size_t index) const { return _values[index][0]; }
	[[nodiscard]] cga::Vector3<double> vector(size_t index) const;
	[[nodiscard]] cga::Vector3<double> location(size_t index) const;
	// A unit quaternion.
	[[nodiscard]] cga::Quaternion<double> rotation(size_t index) const;
	[[nodiscard]] cga::Pose<double> pose(size_t index) const;
	// The numbers at index, index + 1, index + 2.
	[[nodiscard]] cga::Vector3<double> numbers(size_t index) const;

private:
	const cga::Multivector *_values;
};

using FunctionResult = cga::Result<cga::Multivector, Error>;

// One signature of a function.
struct Overload {
	std::string_view name;
	std::string_view parameters; // "center, radius"
	size_t count; // of parameters
	std::array<ArgumentKind, MAX_ARGUMENTS> kinds;
	FunctionResult (*call)(const Arguments &);
	std::string_view meaning; // one line, for the guide and the editor's help

	// "sphere(center, radius)"
	[[nodiscard]] std::string signature() const;
};

struct Function {
	std::string_view name;
	std::vector<const Overload *> overloads; // the first whose kinds match is called

	// Whether a call takes ten times as long as most.
	[[nodiscard]] bool is_costly() const;
	[[nodiscard]] bool takes(size_t count) const;
	[[nodiscard]] size_t max_arguments() const;
	// "2, 3 or 4 arguments"
	[[nodiscard]] std::string counts() const;
};

// All functions, sorted by name.
[[nodiscard]] const std::vector<Function> &functions();
// The index in functions().
[[nodiscard]] std::optional<size_t> find_function(std::string_view name);

// How to correct a variable that does not exist, as the end of an error message: to call the function of that name, or to
// use a similar constant or one of `variables`, if they are at most MAX_CANDIDATES. Empty without a suggestion.
inline constexpr size_t MAX_CANDIDATES = 100;
[[nodiscard]] std::string correction(const std::string &variable, const std::vector<std::string_view> &variables);

// Whether `value` is of the kind, within rounding errors.
[[nodiscard]] bool is_of_kind(const cga::Multivector &value, ArgumentKind kind);
// Describes a kind in error messages: "a number".
[[nodiscard]] std::string_view kind_text(ArgumentKind kind);

} // namespace playground
