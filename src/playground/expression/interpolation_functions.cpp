#include "playground/expression/function_table.hpp"

#include "cga/motor/interpolate.hpp"
#include "cga/motor/motor_multivector.hpp"

namespace playground {

namespace {

// Normalizes to unit weight, as MultivectorLerp.interpolate does.
template <cga::Mode MODE>
FunctionResult interpolate(const Arguments &arguments) {
	const cga::Pose<double> pose = cga::interpolate(arguments.pose(0), arguments.pose(1), arguments.number(2), MODE);
	return cga::to_multivector(cga::Motor<double>::from_pose(pose));
}

constexpr Overload TABLE[] = {
	{ "interpolate_linear", "from, to, t", 3, { M, M, N }, interpolate<cga::Mode::LINEAR>, "blends the coefficients of two motors, and the scale separately; t in 0..1" },
	{ "interpolate_screw", "from, to, t", 3, { M, M, N }, interpolate<cga::Mode::SCREW>, "the fraction or multiple t of the screw motion between two motors" },
	{ "interpolate_separate", "from, to, t", 3, { M, M, N }, interpolate<cga::Mode::SEPARATE>, "blends translation, rotation and scale of two motors separately; t in 0..1" },
};

} // namespace

FunctionTable interpolation_functions() {
	return { TABLE, std::size(TABLE) };
}

} // namespace playground
