#include "net/coding/residual_model.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace net;

namespace {

using Bytes = std::vector<uint8_t>;

} // namespace

TEST_CASE("residual model: every magnitude round-trips, for any expected magnitude") {
	std::vector<int32_t> values;
	for (int32_t i = 0; i <= 3000; ++i) {
		values.push_back(i);
	}
	for (int bit = 11; bit <= 21; ++bit) {
		for (int offset = -2; offset <= 2; ++offset) {
			values.push_back(std::min((1 << bit) + offset, ResidualModel::MAX_MAGNITUDE));
			values.push_back(std::min((1 << bit) + offset + ResidualModel::MAX_UNARY, ResidualModel::MAX_MAGNITUDE));
		}
	}
	for (const int32_t expected : { 0, 1, 256, 5000, 1 << 18, 1 << 20 }) {
		Bytes bytes;
		RangeEncoder encoder(bytes);
		ResidualModel model;
		for (const int32_t value : values) {
			for (int32_t sign : { 1, -1 }) {
				int32_t coded = sign * value;
				model.code(encoder, coded, expected);
				CHECK(coded == sign * value); // an encoder changes nothing
			}
		}
		encoder.finish();
		RangeDecoder decoder(bytes.data(), bytes.size());
		ResidualModel read_model;
		int wrong = 0;
		for (const int32_t value : values) {
			for (const int32_t sign : { 1, -1 }) {
				int32_t read = 12345;
				read_model.code(decoder, read, expected);
				wrong += read != sign * value;
			}
		}
		CAPTURE(expected);
		CHECK(wrong == 0);
	}
}

TEST_CASE("residual model: arbitrary bytes decode to numbers within the limit") {
	std::mt19937 random(3);
	int32_t max = 0;
	for (int round = 0; round < 3000; ++round) {
		Bytes bytes(random() % 64);
		const int kind = int(random() % 3);
		for (uint8_t &byte : bytes) {
			byte = uint8_t(kind == 0 ? 0 : (kind == 1 ? random() : 0xff - random() % 4));
		}
		RangeDecoder decoder(bytes.data(), bytes.size());
		ResidualModel model;
		for (int i = 0; i < 30; ++i) {
			int32_t value = 0;
			model.code(decoder, value, int32_t(random() % 100000));
			max = std::max(max, std::abs(value));
		}
	}
	CHECK(max <= ResidualModel::MAX_MAGNITUDE);
	// Residuals beyond the limit, as a different encoder may write them.
	for (const int32_t beyond : { ResidualModel::MAX_MAGNITUDE + 1, 2 * ResidualModel::MAX_MAGNITUDE, -2 * ResidualModel::MAX_MAGNITUDE }) {
		Bytes bytes;
		RangeEncoder encoder(bytes);
		ResidualModel model;
		int32_t value = beyond;
		model.code(encoder, value, 256);
		encoder.finish();
		RangeDecoder decoder(bytes.data(), bytes.size());
		ResidualModel read_model;
		read_model.code(decoder, value, 256);
		CHECK(value == (beyond > 0 ? ResidualModel::MAX_MAGNITUDE : -ResidualModel::MAX_MAGNITUDE));
	}
}

TEST_CASE("residual model: two-sided geometric numbers cost little more than their entropy, from the first one on") {
	for (const double mean : { 0.05, 0.3, 1.0, 4.0, 20.0 }) {
		const double r = (std::sqrt(1.0 + mean * mean) - 1.0) / mean;
		std::mt19937 random(unsigned(mean * 100));
		std::geometric_distribution<int> geometric(1.0 - r);
		// P(k) = (1 - r) / (1 + r) r^|k| is that of the difference of two geometric numbers.
		const double entropy = -std::log2((1.0 - r) / (1.0 + r)) - mean * std::log2(r);
		for (const int count : { 60, 4000 }) {
			double bits = 0.0;
			double own = 0.0; // cost of these numbers with their true probabilities
			for (int round = 0; round < 4000 / count; ++round) {
				Bytes bytes;
				RangeEncoder encoder(bytes);
				ResidualModel model;
				for (int i = 0; i < count; ++i) {
					int32_t value = geometric(random) - geometric(random);
					own += -std::log2((1.0 - r) / (1.0 + r)) - std::abs(value) * std::log2(r);
					model.code(encoder, value, int32_t(mean * 256));
				}
				encoder.finish();
				bits += 8.0 * double(bytes.size()) - 4.0; // half a byte of the last one is padding
			}
			CAPTURE(mean);
			CAPTURE(count);
			CHECK(own / 4000 == doctest::Approx(entropy).epsilon(0.15));
			CHECK(bits < own * (count < 100 ? 1.12 : 1.06) + 4000 * 0.02);
		}
	}
}

TEST_CASE("residual model: wrong expected magnitudes cost bits, and adaptation corrects them") {
	const auto size = [](int32_t expected, int count) {
		Bytes bytes;
		RangeEncoder encoder(bytes);
		ResidualModel model;
		for (int i = 0; i < count; ++i) {
			int32_t value = i % 2 == 0 ? 40 : -37;
			model.code(encoder, value, expected);
		}
		encoder.finish();
		return bytes.size();
	};
	CHECK(size(38 * 256, 20) < size(16, 20));
	CHECK(size(16, 2000) < 2000 * 1.5); // after adaptation, at most 12 bits each; the first ones take 9 bytes
}

TEST_CASE("mean magnitude: a bounded average over about 8 values") {
	MeanMagnitude mean(0);
	for (int i = 0; i < 100; ++i) {
		mean.add(i % 2 == 0 ? 10 : -10);
	}
	CHECK(mean.value() == doctest::Approx(2560).epsilon(0.01));
	for (int i = 0; i < 8; ++i) {
		mean.add(0);
	}
	CHECK(mean.value() == doctest::Approx(2560 * std::pow(7.0 / 8.0, 8)).epsilon(0.02));
	for (int i = 0; i < 100; ++i) {
		mean.add(ResidualModel::MAX_MAGNITUDE);
	}
	CHECK(mean.value() <= MeanMagnitude::MAX * 256);
	mean.set_value(77);
	CHECK(mean.value() == 77);
}
