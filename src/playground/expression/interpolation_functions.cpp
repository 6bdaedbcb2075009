#include "playground/expression/function_table.hpp"

#include "cga/motor/interpolate.hpp"
#include "cga/motor/motor_multivector.hpp"

namespace playground {

namespace {

// Of unit weight, as MultivectorLerp.interpolate gives it.
template <cga::Mode MODE>
Outcome interpolate(const Arguments &arguments) {
	const cga::Pose<double> pose = cga::interpolate(arguments.pose(0), arguments.pose(1), arguments.number(2), MODE);
	return cga::to_multivector(cga::Motor<double>::from_pose(pose));
}

constexpr Overload TABLE[] = {
	{ "interpolate_linear", "from, to, t", 3, { M, M, N }, interpolate<cga::Mode::LINEAR>, "between two motors: their coefficients blended, the scale by itself; t from 0 to 1" },
	{ "interpolate_screw", "from, to, t", 3, { M, M, N }, interpolate<cga::Mode::SCREW>, "between two motors: a part t of the screw from one to the other, or a multiple" },
	{ "interpolate_separate", "from, to, t", 3, { M, M, N }, interpolate<cga::Mode::SEPARATE>, "between two motors: translation, rotation and scale each by itself; t from 0 to 1" },
};

} // namespace

FunctionTable interpolation_functions() {
	return { TABLE, std::size(TABLE) };
}

} // namespace playground
