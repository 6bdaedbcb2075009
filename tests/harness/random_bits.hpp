#pragma once

#include <cstdint>
#include <random>

namespace harness {

/// Random numbers that are the same on every platform; the distributions of the standard library are not.
class RandomBits {
public:
	explicit RandomBits(uint64_t seed) :
			_engine(seed) {}

	/// Uniform in [0, 1).
	double unit() { return double(_engine() >> 11) * 0x1p-53; }
	/// Uniform in [min, max).
	double between(double min, double max) { return min + (max - min) * unit(); }
	/// True with this probability.
	bool chance(double probability) { return unit() < probability; }

private:
	std::mt19937_64 _engine;
};

} // namespace harness
