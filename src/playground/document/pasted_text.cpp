#include "playground/document/pasted_text.hpp"

#include "cga/text/json.hpp"

namespace playground {

std::string pasted_expression(std::string_view text) {
	const size_t first = text.find_first_not_of(" \t\r\n");
	if (first != std::string_view::npos && text[first] == '{') {
		if (const cga::TextResult<cga::Multivector> value = cga::from_json(text)) {
			return cga::to_json(*value);
		}
	}
	return std::string(text);
}

} // namespace playground
