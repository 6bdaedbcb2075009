#pragma once

#include "net/motion/motion_code.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// Divides a stream's list of bodies into blocks and counts in each the bodies that moved in the last window. In a list of several
/// blocks, a window says of each block without such bodies and without events whether anything moves in it, so that blocks at rest
/// cost one flag, not one for each body. Encoder and decoder keep equal counts.
class BodyBlocks {
public:
	/// Number of bodies in a block.
	static constexpr size_t SIZE = 64;

	[[nodiscard]] static size_t block_of(size_t index) { return index / SIZE; }
	[[nodiscard]] static size_t count(size_t bodies) { return (bodies + SIZE - 1) / SIZE; }

	void resize(size_t bodies) { _active.resize(count(bodies)); }
	void clear() { _active.clear(); }
	/// Records that the body at `index` has begun to move, or that such a body has been put there.
	void add_active(size_t index) { ++_active[block_of(index)]; }
	/// Records that the body at `index` has come to rest, or that an active body has been taken from there.
	void remove_active(size_t index) { --_active[block_of(index)]; }
	[[nodiscard]] bool is_active(size_t block) const { return _active[block] != 0; }

private:
	std::vector<uint8_t> _active; // number of bodies, by block
};

/// Codes whether a block contains motion, unless that is known from `is_coded`: the list has one block only, or the block has active
/// bodies or events. `was_coded` is the result for the block before it.
template <class Coder>
[[nodiscard]] bool code_block(Coder &coder, MotionModels &models, bool is_coded, bool was_coded, bool moves) {
	if (is_coded) {
		return true;
	}
	coder.bit(models.moving_block[was_coded ? 1 : 0], moves);
	return moves;
}

} // namespace net
