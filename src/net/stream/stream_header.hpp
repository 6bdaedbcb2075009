#pragma once

#include "net/coding/bit_stream.hpp"
#include "net/coding/body_id.hpp"
#include "net/motion/body_state.hpp"
#include "net/stream/body_blocks.hpp"

#include <cstddef>
#include <cstdint>

namespace net {

/// Bits of a body's index in the stream's list, as a signed number.
inline constexpr int INDEX_BITS = 24;

/// The checksum received with a window. Only the bits in `mask` were sent.
struct WindowCheck {
	uint8_t value = 0;
	uint8_t mask = 255;
};

/// Folds the 32-bit hash of a stream's state into an 8-bit checksum.
[[nodiscard]] inline uint8_t check_bits(uint32_t hash) {
	return uint8_t(hash >> 24 ^ hash >> 16 ^ hash >> 8 ^ hash);
}

/// The hash of a body of a stream. The sum of all is that of the stream's state.
[[nodiscard]] inline uint32_t body_hash(uint32_t id, const BodyState &state) {
	const uint64_t mixed = (uint64_t(state.hash()) << 32 | id) * 0xff51afd7ed558ccdu;
	return uint32_t((mixed ^ mixed >> 29) * 0xc4ceb9fe1a85ec53u >> 32);
}

/// The checksum after a window, from the one before it and the sum of the hashes of all bodies.
[[nodiscard]] inline uint32_t next_check(uint32_t check, uint32_t sum) {
	return (check ^ sum) * 0x01000193u;
}

/// An event of a body in a window, besides its motion.
enum class WindowEvent : uint8_t {
	ADDED,
	REMOVED,
	JUMPED,
	FREED, ///< removed because its object was freed
};

/// Codes the numbers of a BodyState with a RangeEncoder or a RangeDecoder: the width of the zigzag code, then its bits.
template <class Coder>
class StateCoder {
public:
	explicit StateCoder(Coder &coder) :
			_coder(coder) {}

	template <class Number>
	void operator()(Number &number, int bits) {
		uint64_t code = zigzag(int64_t(number));
		uint32_t width = uint32_t(bit_width(code));
		const int width_bits = bit_width(uint64_t(bits));
		_coder.bits(width, width_bits);
		uint32_t high = uint32_t(code >> 32);
		uint32_t low = uint32_t(code);
		const int count = int(width) < bits ? int(width) : bits;
		_coder.bits(high, count > 32 ? count - 32 : 0);
		_coder.bits(low, count > 32 ? 32 : count);
		code = uint64_t(count > 32 ? high : 0) << 32 | (count > 0 ? low : 0);
		number = Number(unzigzag(code));
	}

private:
	Coder &_coder;
};

/// Codes the coarseness of a window and stores it as the last.
template <class Coder>
void code_coarseness(Coder &coder, MotionModels &models, int &last, int &coarseness) {
	bool is_same = coarseness == last;
	coder.bit(models.same_coarseness, is_same);
	uint32_t coded = uint32_t(is_same ? last : coarseness);
	if (!is_same) {
		coder.bits(coded, BodyState::COARSENESS_BITS);
	}
	last = coarseness = int(coded);
}

/// Codes the models: for each adaptive bit a flag and, if it differs from its initial state, its state.
template <class Coder>
void code_models(Coder &coder, MotionModels &models) {
	MotionModels initial;
	AdaptiveBit *initial_bits[MotionModels::MAX_BITS];
	int count = 0;
	initial.visit([&](AdaptiveBit &bit) { initial_bits[count++] = &bit; });
	AdaptiveBit is_changed;
	count = 0;
	models.visit([&](AdaptiveBit &bit) {
		uint32_t state = bit.state();
		bool changed = state != initial_bits[count++]->state();
		coder.bit(is_changed, changed);
		if (changed) {
			coder.bits(state, 32);
			bit.set_state(state);
		}
	});
}

/// Codes the number of bodies in a snapshot and the model of their blocks.
template <class Coder>
void code_body_count(Coder &coder, uint32_t &count, AdaptiveBit &block_model) {
	coder.bits(count, INDEX_BITS);
	if (count > BodyBlocks::SIZE) {
		uint32_t state = block_model.state();
		uint32_t is_changed = state != BodyBlocks().model().state() ? 1 : 0;
		coder.bits(is_changed, 1);
		if (is_changed != 0) {
			coder.bits(state, 32);
			block_model.set_state(state);
		}
	}
}

} // namespace net
