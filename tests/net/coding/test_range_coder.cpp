#include "net/coding/range_coder.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace net;

namespace {

using Bytes = std::vector<uint8_t>;

double entropy(double p) {
	return -p * std::log2(p) - (1.0 - p) * std::log2(1.0 - p);
}

/// Codes the bits with one adaptive model and reads them back. Returns the coded size in bytes.
size_t round_trip(const std::vector<bool> &bits) {
	Bytes bytes;
	RangeEncoder encoder(bytes);
	AdaptiveBit model;
	for (bool bit : bits) {
		encoder.bit(model, bit);
	}
	encoder.finish();
	RangeDecoder decoder(bytes.data(), bytes.size());
	AdaptiveBit read_model;
	size_t wrong = 0;
	for (const bool bit : bits) {
		bool read = !bit;
		decoder.bit(read_model, read);
		wrong += read != bit;
	}
	CHECK(wrong == 0);
	CHECK(read_model.state() == model.state());
	CHECK(decoder.overrun() <= 4 + bits.size() / 8);
	return bytes.size();
}

std::vector<bool> random_bits(size_t count, double probability, unsigned seed) {
	std::mt19937 random(seed);
	std::bernoulli_distribution one(probability);
	std::vector<bool> bits(count);
	for (size_t i = 0; i < count; ++i) {
		bits[i] = one(random);
	}
	return bits;
}

} // namespace

TEST_CASE("range coder: bits of a given probability cost little more than their entropy") {
	constexpr size_t COUNT = 20000;
	unsigned seed = 1;
	for (const double p : { 0.5, 0.3, 0.1, 0.03, 0.01, 0.97 }) {
		const double bits = 8.0 * double(round_trip(random_bits(COUNT, p, ++seed)));
		CAPTURE(p);
		// The running averages cost up to 4 %, and probabilities are not below 1/256.
		CHECK(bits < COUNT * entropy(p) * 1.04 + COUNT * 0.006 + 40);
		CHECK(bits > COUNT * entropy(p) * 0.96 - 300);
	}
}

TEST_CASE("range coder: long runs of either bit cost 1/170 bit each") {
	for (const bool value : { false, true }) {
		const size_t size = round_trip(std::vector<bool>(100000, value));
		CAPTURE(value);
		CHECK(size >= (value ? 60 : 0));
		CHECK(size <= 100);
	}
	CHECK(round_trip({}) == 0);
	CHECK(round_trip({ false }) == 0); // the decoder reads zeros past the end
	CHECK(round_trip({ true }) == 1);
}

TEST_CASE("range coder: carries propagate through any number of bytes") {
	// An unlikely 1 after each run leaves the low end just below the top of its range.
	for (int run = 1; run < 400; ++run) {
		std::vector<bool> bits;
		for (int i = 0; i < 6; ++i) {
			bits.insert(bits.end(), size_t(run), true);
			bits.push_back(false);
			bits.push_back(true);
		}
		round_trip(bits);
	}
	// Ones of equal probability: the low end is 0xffff..., and the last field decides whether a carry follows.
	for (uint32_t last : { 0u, 1u, 0xffffffffu }) {
		for (int words = 1; words < 40; ++words) {
			Bytes bytes;
			RangeEncoder encoder(bytes);
			for (int i = 0; i < words; ++i) {
				uint32_t ones = 0xffffffffu;
				encoder.bits(ones, 32);
			}
			encoder.bits(last, 32);
			AdaptiveBit model(100);
			for (int i = 0; i < 12; ++i) {
				bool one = true;
				encoder.bit(model, one);
			}
			encoder.finish();
			RangeDecoder decoder(bytes.data(), bytes.size());
			for (int i = 0; i < words; ++i) {
				uint32_t value = 0;
				decoder.bits(value, 32);
				CHECK(value == 0xffffffffu);
			}
			uint32_t value = 0;
			decoder.bits(value, 32);
			CHECK(value == last);
			AdaptiveBit read(100);
			for (int i = 0; i < 12; ++i) {
				bool one = false;
				decoder.bit(read, one);
				CHECK(one);
			}
		}
	}
}

TEST_CASE("range coder: fields of every width and bits of many models round-trip, appended to existing bytes") {
	std::mt19937 random(11);
	for (int round = 0; round < 300; ++round) {
		struct Symbol {
			int model; // -1: a field
			int width;
			uint32_t value;
		};
		std::vector<Symbol> symbols(1 + random() % 200);
		for (Symbol &symbol : symbols) {
			symbol.model = int(random() % 6) - 1;
			symbol.width = symbol.model < 0 ? int(random() % 33) : 1;
			symbol.value = symbol.width == 0 ? 0 : uint32_t(random()) >> (32 - symbol.width);
			if (symbol.model >= 2) {
				symbol.value = random() % 50 == 0;
			}
		}
		Bytes bytes = { 1, 0, 0 };
		RangeEncoder encoder(bytes);
		AdaptiveBit models[5];
		double cost = 0.0;
		for (Symbol &symbol : symbols) {
			bool bit = symbol.value != 0;
			CostMeter meter;
			if (symbol.model < 0) {
				encoder.bits(symbol.value, symbol.width);
				meter.bits(symbol.value, symbol.width);
			} else {
				meter.bit(models[symbol.model], bit);
				encoder.bit(models[symbol.model], bit);
			}
			cost += meter.cost() / 256.0;
		}
		encoder.finish();
		REQUIRE(bytes.size() >= 3);
		CHECK(bytes[0] == 1);
		CHECK((bytes.size() == 3 || bytes.back() != 0));
		// The cost meter predicts the size.
		CHECK(8.0 * double(bytes.size() - 3) < cost * 1.01 + 16);
		RangeDecoder decoder(bytes.data() + 3, bytes.size() - 3);
		AdaptiveBit read_models[5];
		int wrong = 0;
		for (const Symbol &symbol : symbols) {
			uint32_t value = 0;
			if (symbol.model < 0) {
				decoder.bits(value, symbol.width);
			} else {
				bool bit = false;
				decoder.bit(read_models[symbol.model], bit);
				value = bit;
			}
			wrong += value != symbol.value;
		}
		CHECK(wrong == 0);
	}
}

TEST_CASE("range coder: probabilities never reach 0 or 1, and a model's state is complete") {
	AdaptiveBit model;
	CHECK(model.probability() == 2048);
	for (int i = 0; i < 5000; ++i) {
		model.update(false);
	}
	CHECK(model.probability() <= 4080);
	CHECK(model.probability() > 4060);
	for (int i = 0; i < 5000; ++i) {
		model.update(true);
	}
	CHECK(model.probability() >= 16);
	CHECK(model.probability() < 40);
	model.update(false);
	AdaptiveBit other;
	other.set_state(model.state());
	CHECK(other.probability() == model.probability());
	other.update(true);
	model.update(true);
	CHECK(other.state() == model.state());
}

TEST_CASE("range coder: any bytes can be decoded, and reads past their end are counted") {
	std::mt19937 random(5);
	for (int round = 0; round < 200; ++round) {
		Bytes bytes(random() % 40);
		for (uint8_t &byte : bytes) {
			byte = uint8_t(random() % 3 == 0 ? 0xff : random());
		}
		RangeDecoder decoder(bytes.data(), bytes.size());
		AdaptiveBit model;
		uint32_t value = 0;
		for (int i = 0; i < 100; ++i) {
			bool bit = false;
			decoder.bit(model, bit);
			decoder.bits(value, i % 33);
			CHECK(uint64_t(value) < (uint64_t(1) << (i % 33)) + (i % 33 == 0));
		}
		CHECK(decoder.overrun() > 4);
	}
}
