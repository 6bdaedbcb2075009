#pragma once

#include "cga/algebra/multivector.hpp"
#include "cga/motor/pose.hpp"
#include "cga/result.hpp"
#include "cga/vector.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The functions of the expression language: one table, which the parser, the evaluator, the guide's test and the
// editor's help read.

namespace playground {

// What an argument has to be.
enum class ArgumentKind {
	ANY, // any multivector, numbers included
	NUMBER, // a scalar
	VECTOR, // x e1 + y e2 + z e3
	LOCATION, // a point of any weight, or a VECTOR
	ROTATION, // a rotor about the origin: 1, e12, e13, e23
	MOTOR, // a product of translators, rotors and dilators, of any weight and sign
};

inline constexpr size_t MAX_ARGUMENTS = 4;

// The arguments of a call, of the kinds that the overload asks for.
class Arguments {
public:
	explicit Arguments(const cga::Multivector *values) :
			_values(values) {}

	[[nodiscard]] const cga::Multivector &operator[](size_t index) const { return _values[index]; }
	[[nodiscard]] double number(size_t index) const { return _values[index][0]; }
	[[nodiscard]] cga::Vector3<double> vector(size_t index) const;
	[[nodiscard]] cga::Vector3<double> location(size_t index) const;
	// Of unit length.
	[[nodiscard]] cga::Quaternion<double> rotation(size_t index) const;
	[[nodiscard]] cga::Pose<double> pose(size_t index) const;
	// Three numbers from `index` on.
	[[nodiscard]] cga::Vector3<double> numbers(size_t index) const;

private:
	const cga::Multivector *_values;
};

// One way to call a function.
struct Overload {
	std::string_view name;
	std::string_view parameters; // "center, radius"
	size_t count; // of parameters
	std::array<ArgumentKind, MAX_ARGUMENTS> kinds;
	cga::Result<cga::Multivector> (*call)(const Arguments &);
	std::string_view meaning; // one line

	// "sphere(center, radius)"
	[[nodiscard]] std::string signature() const;
};

struct Function {
	std::string_view name;
	std::vector<const Overload *> overloads; // the first whose kinds fit is called

	[[nodiscard]] bool takes(size_t count) const;
	[[nodiscard]] size_t most_arguments() const;
	// "2, 3 or 4 arguments"
	[[nodiscard]] std::string counts() const;
};

// All functions, in the order of their names.
[[nodiscard]] const std::vector<Function> &functions();
// The index in functions().
[[nodiscard]] std::optional<size_t> find_function(std::string_view name);

// Whether a value is of a kind, and the kind in words ("a number").
[[nodiscard]] bool is_of_kind(const cga::Multivector &value, ArgumentKind kind);
[[nodiscard]] std::string_view kind_text(ArgumentKind kind);

} // namespace playground
