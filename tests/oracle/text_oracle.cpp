// C interface of the text of multivectors and the expression language. Text is written to a buffer and truncated to its
// size; so are errors of parsing, as "column 7: expected ...".

#include "elements.hpp"

#include "cga/text/json.hpp"
#include "cga/text/text.hpp"
#include "playground/expression/evaluate.hpp"

#include <string>

using namespace cga;
using namespace oracle;

namespace {

void store_text(const std::string &text, char *buffer, size_t size) {
	const size_t length = std::min(text.size(), size - 1);
	std::copy_n(text.data(), length, buffer);
	buffer[length] = '\0';
}

bool store_value(const TextResult<Multivector> &value, double *numbers, char *error, size_t size) {
	if (value) {
		store_multivector(*value, numbers);
	} else {
		store_text(value.error().describe(), error, size);
	}
	return value.has_value();
}

} // namespace

ORACLE void oracle_to_json(const double *numbers, char *buffer, size_t size) {
	store_text(to_json(load_multivector(numbers)), buffer, size);
}

ORACLE void oracle_to_text(const double *numbers, bool null_basis, char *buffer, size_t size) {
	store_text(to_text(load_multivector(numbers), null_basis), buffer, size);
}

ORACLE void oracle_to_latex(const double *numbers, bool null_basis, char *buffer, size_t size) {
	store_text(to_latex(load_multivector(numbers), null_basis), buffer, size);
}

ORACLE bool oracle_from_json(const char *text, size_t length, double *numbers, char *error, size_t size) {
	return store_value(from_json({ text, length }), numbers, error, size);
}

ORACLE bool oracle_evaluate(const char *text, size_t length, double *numbers, char *error, size_t size) {
	return store_value(playground::evaluate(std::string_view(text, length)), numbers, error, size);
}
