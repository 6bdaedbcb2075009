#pragma once

#include "playground/document/document.hpp"
#include "playground/document/literal.hpp"
#include "playground/handles/handle.hpp"
#include "playground/handles/steps.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace playground::handles {

// What Document::set_parameter takes.
struct Drag {
	std::string parameter;
	LiteralValue value;
};

// What an entry has to become for a handle to come under the mouse: `start` is the handle as it was when the person took hold of
// it, so that planes across the view, grids and lengths of arms stay those of the start. Without steps the ray passes
// through the handle afterwards, or as near as the motion permits. Empty where nothing can follow: the entry has no such
// handle any more, the ray leads nowhere (constraint.hpp), a radius would be none.
[[nodiscard]] std::optional<Drag> drag(const Document &document, std::string_view name, const Handle &start, const ViewRay &ray, const Steps &steps = {});

} // namespace playground::handles
