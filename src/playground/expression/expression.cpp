#include "playground/expression/expression.hpp"

#include <algorithm>

namespace playground {

bool Expression::refers_to(std::string_view variable) const {
	return std::find(_variables.begin(), _variables.end(), variable) != _variables.end();
}

const NameUse &Expression::first_use(size_t variable) const {
	return *std::find_if(_uses.begin(), _uses.end(), [variable](const NameUse &use) { return use.variable == variable; });
}

std::string Expression::renamed(std::string_view from, std::string_view to) const {
	std::string result;
	size_t copied = 0;
	for (const NameUse &use : _uses) {
		if (_variables[use.variable] == from) {
			result.append(_text, copied, use.offset - copied);
			result += to;
			copied = use.offset + from.size();
		}
	}
	return result.append(_text, copied, std::string::npos);
}

} // namespace playground
