#include "net/stream/stream_header.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace net;

TEST_CASE("stream header: numbers of a state round-trip in the width they need") {
	struct Row {
		int64_t number;
		int bits;
	};
	const std::vector<Row> rows = { { 0, 2 }, { 1, 2 }, { -1, 2 }, { 100000, 20 }, { -400000, 20 }, { (int64_t(1) << 46) - 1, 48 }, { -(int64_t(1) << 46), 48 }, { INT32_MAX, 33 }, { INT32_MIN, 33 } };
	std::vector<uint8_t> bytes;
	RangeEncoder encoder(bytes);
	StateCoder<RangeEncoder> write(encoder);
	for (const Row &row : rows) {
		int64_t number = row.number;
		write(number, row.bits);
		CHECK(number == row.number);
	}
	encoder.finish();
	CHECK(bytes.size() <= 40);
	RangeDecoder decoder(bytes.data(), bytes.size());
	StateCoder<RangeDecoder> read(decoder);
	for (const Row &row : rows) {
		int64_t number = 7;
		read(number, row.bits);
		CHECK(number == row.number);
	}
}

TEST_CASE("stream header: models round-trip, and unchanged ones take few bytes") {
	MotionModels models;
	for (const bool is_changed : { false, true }) {
		if (is_changed) {
			models.active[1][0].set_state(12345);
			models.same_length.set_state(54321);
		}
		std::vector<uint8_t> bytes;
		RangeEncoder encoder(bytes);
		code_models(encoder, models);
		encoder.finish();
		CHECK(bytes.size() < (is_changed ? 60 : 40));
		MotionModels read;
		RangeDecoder decoder(bytes.data(), bytes.size());
		code_models(decoder, read);
		std::vector<uint32_t> states;
		models.visit([&](AdaptiveBit &bit) { states.push_back(bit.state()); });
		size_t index = 0;
		read.visit([&](AdaptiveBit &bit) { CHECK(bit.state() == states[index++]); });
		CHECK(index == states.size());
		CHECK(states.size() <= size_t(MotionModels::MAX_BITS));
	}
}
