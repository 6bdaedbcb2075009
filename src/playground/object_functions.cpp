#include "playground/function_table.hpp"

#include "cga/motor/versor.hpp"

namespace playground {

namespace {

constexpr Overload TABLE[] = {
	{ "point", "position", 1, { P }, [](const Arguments &a) -> Outcome { return cga::point(a.location(0)); }, "the point at a position" },
	{ "point", "x, y, z", 3, { N, N, N }, [](const Arguments &a) -> Outcome { return cga::point(a.numbers(0)); }, "the point (x, y, z)" },
};

} // namespace

FunctionTable object_functions() {
	return { TABLE, std::size(TABLE) };
}

} // namespace playground
