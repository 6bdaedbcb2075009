#pragma once

#include "cga/motor/pose.hpp"
#include "cga/object/classify.hpp"
#include "playground/document/document.hpp"
#include "playground/document/parameters.hpp"
#include "playground/handles/view_ray.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace playground::handles {

// An entry with a value: its parameters and its classification.
class FreeObject {
public:
	// Empty if the entry does not exist or has an error.
	static std::optional<FreeObject> find(const Document &document, std::string_view name);

	// Whether `parameter` is a parameter of the entry (parameters.hpp), not a computed argument.
	[[nodiscard]] bool can_set(std::string_view parameter) const { return literal(parameter) != nullptr; }

	// The value of a parameter or of a computed argument; empty if it does not exist or has another type.
	[[nodiscard]] std::optional<Vector> vector(std::string_view name) const;
	[[nodiscard]] std::optional<double> number(std::string_view name) const;
	// Null if there is no such parameter.
	[[nodiscard]] const cga::Quaternion<double> *rotation() const;
	// The coefficients of a list or a sum of blades, before any dual is applied; null if there are none.
	[[nodiscard]] const cga::Multivector *coefficients() const;
	[[nodiscard]] bool has_argument(std::string_view name) const;

	[[nodiscard]] const cga::Classification &classification() const { return _classification; }
	// The pose of a motor; empty if it does not match the parameters, as for the reverse ~motor(...).
	[[nodiscard]] const std::optional<cga::Pose<double>> &pose() const { return _pose; }

private:
	FreeObject(const Document &document, const Entry &entry);

	[[nodiscard]] const LiteralValue *literal(std::string_view parameter) const;
	[[nodiscard]] std::optional<cga::Multivector> computed(std::string_view argument) const;
	[[nodiscard]] bool matches_parameters(const cga::Pose<double> &pose) const;

	const Document *_document;
	std::vector<Parameter> _parameters;
	std::vector<Argument> _arguments;
	cga::Classification _classification;
	std::optional<cga::Pose<double>> _pose;
};

} // namespace playground::handles
