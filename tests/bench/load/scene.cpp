#include "scene.hpp"

#include "../../harness/random_bits.hpp"

#include <cmath>

namespace bench {

namespace {

constexpr double FULL_TURN = 6.283185307179586;
constexpr double HALF_EXTENT = 50.0; // of the region of the centers, in meters

} // namespace

LoadScene::LoadScene(size_t bodies, double moving_share, uint64_t seed) :
		_moving(size_t(std::llround(double(bodies) * moving_share))) {
	harness::RandomBits random(seed);
	_paths.resize(bodies);
	for (Path &path : _paths) {
		for (int axis = 0; axis < 3; ++axis) {
			path.center[axis] = random.between(-HALF_EXTENT, HALF_EXTENT);
			path.axis[axis] = random.between(-1.0, 1.0);
		}
		path.axis = glm::normalize(path.axis + glm::dvec3(0.0, 1e-3, 0.0));
		for (size_t wave = 0; wave < WAVES; ++wave) {
			for (int i = 0; i < 4; ++i) {
				path.amplitude[wave][i] = random.between(0.2, 1.0) / double(1 + 2 * wave);
				path.frequency[wave][i] = random.between(0.9, 2.7) * double(1 + wave);
				path.phase[wave][i] = random.between(0.0, FULL_TURN);
			}
		}
	}
}

cga::Pose<double> LoadScene::pose(size_t body, double time) const {
	const Path &path = _paths[body];
	const double moved = is_moving(body) ? time : 0.0;
	glm::dvec4 sum(0.0);
	for (size_t wave = 0; wave < WAVES; ++wave) {
		sum += path.amplitude[wave] * glm::sin(path.frequency[wave] * moved + path.phase[wave]);
	}
	cga::Pose<double> pose;
	pose.translation = path.center + glm::dvec3(sum);
	pose.rotation = glm::angleAxis(sum.w, path.axis);
	return pose;
}

} // namespace bench
