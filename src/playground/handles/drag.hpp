#pragma once

#include "playground/document/literal.hpp"
#include "playground/handles/handles.hpp"
#include "playground/handles/steps.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace playground::handles {

// A new value of a parameter, for Document::set_parameter.
struct Drag {
	std::string parameter;
	LiteralValue value;
};

// The parameter change that moves a handle to the ray, as close as its constraint and the steps permit. `start` is the handle
// at the beginning of the drag, which fixes the view plane, the grid and the lengths of arms. Empty if the handle cannot
// follow: the handle no longer exists, the ray gives no position (constraint.hpp), or a radius would not be positive.
[[nodiscard]] std::optional<Drag> drag(const Document &document, std::string_view name, const Handle &start, const ViewRay &ray, const Steps &steps = {});

} // namespace playground::handles
