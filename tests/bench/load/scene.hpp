#pragma once

#include "cga/motor/pose.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

/// Bodies in smooth pseudo-random motion, whose true pose is known at any time. A moving body costs a stream of 5 mm tolerance
/// about 15 to 35 bytes per second.
class LoadScene {
public:
	/// The first `moving_share` (0 to 1) of the bodies moves, the others rest. The same seed gives the same motion.
	LoadScene(size_t bodies, double moving_share, uint64_t seed);

	[[nodiscard]] size_t size() const { return _paths.size(); }
	[[nodiscard]] size_t moving_count() const { return _moving; }
	[[nodiscard]] bool is_moving(size_t body) const { return body < _moving; }
	/// The pose of a body at a time in seconds.
	[[nodiscard]] cga::Pose<double> pose(size_t body, double time) const;

private:
	static constexpr size_t WAVES = 2;

	// Sums of two sines along each axis and for the angle about a fixed axis.
	struct Path {
		glm::dvec3 center{};
		glm::dvec3 axis{};
		glm::dvec4 amplitude[WAVES]; // meters; w: radians
		glm::dvec4 frequency[WAVES]; // radians per second
		glm::dvec4 phase[WAVES]; // radians
	};

	std::vector<Path> _paths;
	size_t _moving = 0;
};

} // namespace bench
