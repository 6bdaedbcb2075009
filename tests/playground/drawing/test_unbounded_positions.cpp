#include "shader_functions.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <set>

using namespace playground::drawing::shader_functions;

TEST_CASE("unbounded forms extend beyond the view frustum") {
	for (const float far_plane : { 10.0f, 100.0f, 4000.0f, 1e5f }) {
		for (const float near_extent : { 1e-4f, 1.0f, 30.0f, 1e6f }) {
			CHECK(unbounded_extent(0.0f, near_extent, far_plane) == 0.0f);
			float previous = 0.0f;
			for (float step = 1.0f; step < 3.5f; step += 1.0f) {
				const float extent = unbounded_extent(step, near_extent, far_plane);
				CHECK(extent > previous);
				previous = extent;
			}
			// A corner of the frustum at 120 degrees and 16:9 is four times as far away as the far plane.
			CHECK(previous > 8.0f * far_plane);
			// A vertex lies at half the distance of the far plane, where clamping changes no depth.
			CHECK(unbounded_extent(2.0f, near_extent, far_plane) == 0.5f * far_plane);
		}
	}
}

TEST_CASE("arrowheads of a line stay in place when the eye moves") {
	// Two views along the line share most of their arrowheads.
	std::set<float> before, after;
	for (float index = -6.0f; index <= 5.0f; index += 1.0f) {
		before.insert(line_arrow_position(index, 0.0f, 5.0f));
		after.insert(line_arrow_position(index, 3.0f, 6.0f));
	}
	int shared = 0;
	for (const float position : before) {
		shared += int(after.count(position));
	}
	CHECK(shared >= 10);
	// At any distance, an arrowhead is near the point of the line closest to the eye.
	for (const float distance : { 1e-3f, 0.1f, 3.0f, 1e4f }) {
		CHECK(std::abs(line_arrow_position(0.0f, 17.0f, distance) - 17.0f) <= 0.5f * distance);
	}
}
