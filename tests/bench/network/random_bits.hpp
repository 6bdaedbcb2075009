#pragma once

#include <cstdint>
#include <random>

namespace bench {

/// Random numbers that are the same with every standard library: its distributions are not.
class RandomBits {
public:
	explicit RandomBits(uint64_t seed) :
			_engine(seed) {}

	/// Uniform in [0, 1).
	double unit() { return double(_engine() >> 11) * 0x1p-53; }
	/// Uniform in [least, most).
	double between(double least, double most) { return least + (most - least) * unit(); }
	/// True with this probability.
	bool chance(double probability) { return unit() < probability; }

private:
	std::mt19937_64 _engine;
};

} // namespace bench
