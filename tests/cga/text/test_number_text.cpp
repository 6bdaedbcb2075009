#include "cga/text/number_text.hpp"

#include "../random_poses.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <limits>

using namespace cga;

namespace {

std::string text_of(double value) {
	std::string text;
	append_number(text, value);
	return text;
}

#ifdef __GLIBCXX__
std::string text_by_stream(double value) {
	std::string text;
	detail::append_number_by_stream(text, value);
	return text;
}
#endif

uint64_t bits_of(double value) {
	uint64_t bits = 0;
	std::memcpy(&bits, &value, sizeof(bits));
	return bits;
}

double random_bits(std::mt19937_64 &engine) {
	for (;;) {
		const uint64_t bits = engine();
		double value = 0.0;
		std::memcpy(&value, &bits, sizeof(value));
		if (std::isfinite(value)) {
			return value;
		}
	}
}

} // namespace

TEST_CASE("append_number() writes the shortest decimal") {
	CHECK(text_of(0.0) == "0");
	CHECK(text_of(-0.0) == "-0");
	CHECK(text_of(0.1) == "0.1");
	CHECK(text_of(-2.0) == "-2");
	CHECK(text_of(100000.0) == "100000");
	CHECK(text_of(123456789012345.0) == "123456789012345");
	CHECK(text_of(0.0001) == "0.0001");
	CHECK(text_of(1.5e-7) == "1.5e-07");
	CHECK(text_of(1e20) == "1e+20");
	CHECK(text_of(1.0 / 3.0) == "0.3333333333333333");
	CHECK(text_of(std::numeric_limits<double>::max()) == "1.7976931348623157e+308");
	CHECK(text_of(std::numeric_limits<double>::denorm_min()) == "5e-324");
}

TEST_CASE("any double reads back as the same bits") {
	std::mt19937_64 engine(1);
	for (int repeat = 0; repeat < 20000; ++repeat) {
		const double value = random_bits(engine);
		CHECK(bits_of(read_number(text_of(value)).value()) == bits_of(value));
	}
}

// Older versions of libstdc++ lack <charconv> for doubles. In libc++, the streams read no subnormal numbers.
#ifdef __GLIBCXX__

TEST_CASE("the versions for older standard libraries write and read the same") {
	cga_test::Random random(2);
	std::mt19937_64 engine(3);
	for (int repeat = 0; repeat < 3000; ++repeat) {
		const double value = repeat % 2 == 0 ? random_bits(engine) : random.normal() * std::pow(10.0, int(random.uniform(-8.0, 18.0)));
		const std::string text = text_by_stream(value);
		CHECK(bits_of(detail::read_number_by_stream(text).value()) == bits_of(value));
		CHECK(bits_of(read_number(text).value()) == bits_of(value));
		CHECK(text.size() == text_of(value).size());
	}
	for (const double value : { 0.0, 0.1, -2.0, 100000.0, 123456789012345.0, 1.5e-7, 1e20, 0.0001 }) {
		CHECK(text_by_stream(value) == text_of(value));
	}
}

#endif

TEST_CASE("overflow gives no number, underflow gives zero") {
#ifdef __GLIBCXX__
	const auto readers = { read_number, detail::read_number_by_stream };
#else
	const auto readers = { read_number };
#endif
	for (const auto read : readers) {
		CHECK_FALSE(read("1e309").has_value());
		CHECK_FALSE(read("-1e309").has_value());
		CHECK_FALSE(read("1e999999999999").has_value());
		CHECK_FALSE(read("1" + std::string(400, '0')).has_value());
		CHECK_FALSE(read("0.001e312").has_value());
		CHECK(read("1.7976931348623157e308") == std::numeric_limits<double>::max());
		CHECK(read("1e-400") == 0.0);
		CHECK(read("1e-999999999999") == 0.0);
		CHECK(read("0." + std::string(400, '0') + "1") == 0.0);
		CHECK(read("0e999999") == 0.0);
		CHECK(read("5e-324") == std::numeric_limits<double>::denorm_min());
	}
	CHECK(std::signbit(*read_number("-1e-400")));
	CHECK_FALSE(std::signbit(*read_number("1E-400")));
	CHECK(read_number("12345.6789E-00400") == 0.0);
	CHECK(read_number("0." + std::string(500, '0') + "1e+100") == 0.0);
	CHECK(read_number("1" + std::string(200, '0') + "e-600") == 0.0);
	CHECK_FALSE(read_number("0." + std::string(200, '0') + "1e+600").has_value());
	CHECK_FALSE(read_number("1E+400").has_value());
	CHECK_FALSE(read_number("99.e+400").has_value());
	CHECK_FALSE(read_number("-.5e400").has_value());
	CHECK(read_number("-.5e-400") == 0.0);
	CHECK(read_number("1000000e-400") == 0.0);
	CHECK_FALSE(read_number(std::string(300, '9') + "e20").has_value());
}
