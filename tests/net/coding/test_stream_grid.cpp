#include "net/coding/stream_grid.hpp"

#include "../motion_scenes.hpp"

#include <doctest/doctest.h>

using namespace net;
using namespace net_test;

TEST_CASE("stream grid: an error of one tolerance at the lever arm bounds both tolerances") {
	for (const double position : { 0.0005, 0.005, 0.1 }) {
		for (const double rotation : { 0.05, 1.4, 20.0 }) {
			const StreamGrid grid{ float(position), float(rotation) };
			CAPTURE(position);
			CAPTURE(rotation);
			CHECK(grid.position * StreamGrid::TOLERANCE == doctest::Approx(StreamGrid::USED * position).epsilon(1e-6));
			CHECK(grid.rotation * grid.lever_arm == doctest::Approx(grid.position).epsilon(1e-12));
			// About any axis, one of the three points at the lever arm moves at least by the position tolerance.
			const double radians = glm::radians(rotation);
			cga_test::Random random(5);
			for (int i = 0; i < 200; ++i) {
				const Vector3D axis = i < 100 ? glm::normalize(random.vector(1.0)) : glm::normalize(Vector3D(1.0) + random.vector(0.01));
				PoseD turned;
				turned.rotation = cga_test::axis_angle(axis, radians);
				CHECK(error_share(turned, PoseD(), grid) * StreamGrid::USED >= 0.99);
			}
		}
	}
}
