#pragma once

#include "net/coding/range_coder.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace net {

/// Divides a stream's list of bodies into blocks and counts in each the bodies that moved in the last window. In a list of several
/// blocks, a window says of each block without such bodies and without events whether anything moves in it. So a block at rest costs
/// one flag, not one for each body. Encoder and decoder keep equal counts and an equal model.
class BodyBlocks {
public:
	/// Number of bodies in a block. Smaller blocks would cost bytes if a few bodies in each move.
	static constexpr size_t SIZE = 256;

	[[nodiscard]] static size_t block_of(size_t index) { return index / SIZE; }
	[[nodiscard]] static size_t count(size_t bodies) { return (bodies + SIZE - 1) / SIZE; }

	void resize(size_t bodies) {
		_active.resize(count(bodies));
		if (!has_flags()) {
			_moves = INITIAL;
		}
	}
	/// Records whether the body at `index` was active before and is now, or that one takes the place of another there.
	void change_active(size_t index, bool was_active, bool is_active) {
		uint16_t &count = _active[block_of(index)];
		count = uint16_t(count - (was_active ? 1 : 0) + (is_active ? 1 : 0));
	}
	[[nodiscard]] bool is_active(size_t block) const { return _active[block] != 0; }

	/// Windows contain flags: there are several blocks. Otherwise, the model is in its initial state.
	[[nodiscard]] bool has_flags() const { return _active.size() > 1; }
	[[nodiscard]] const AdaptiveBit &model() const { return _moves; }
	void set_model(const AdaptiveBit &model) { _moves = model; }
	/// Codes whether a block without active bodies and events contains motion.
	template <class Coder>
	void code_flag(Coder &coder, bool &moves) {
		coder.bit(_moves, moves);
	}

private:
	static constexpr AdaptiveBit INITIAL{ 62000 };

	std::vector<uint16_t> _active; // number of bodies, by block
	AdaptiveBit _moves = INITIAL; // a block contains motion
};

} // namespace net
