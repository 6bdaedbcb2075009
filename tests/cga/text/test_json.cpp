#include "cga/text/json.hpp"

#include "../random_poses.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <limits>

using namespace cga;
using cga_test::Random;

namespace {

// "[0, 0, ...]" with `count` numbers.
std::string array(int count, const std::string &number = "0") {
	std::string text = "[";
	for (int index = 0; index < count; ++index) {
		text += (index > 0 ? "," : "") + number;
	}
	return text + "]";
}

std::string error_of(std::string_view text) {
	const TextResult<Multivector> result = from_json(text);
	return result ? "no error" : result.error().describe();
}

bool same_bits(const Multivector &left, const Multivector &right) {
	return std::memcmp(left.coefficients().data(), right.coefficients().data(), sizeof(double) * BLADE_COUNT) == 0;
}

} // namespace

TEST_CASE("to_json() writes an array of 32 numbers in the order of ganja.js") {
	CHECK(to_json(Multivector()) == array(32));
	CHECK(to_json(*Multivector::basis("e1") * 1.5) == "[0,1.5," + array(30).substr(1));
	Multivector x;
	for (int index = 0; index < BLADE_COUNT; ++index) {
		x[index] = index;
	}
	CHECK(to_json(x) == "[0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31]");
	// The coefficients of ganja.js's Algebra(4,1) by name, at their indices: scalar, e1, e5, e12, e45, e123, e12345.
	CHECK(blade_index("e12") == 6);
	CHECK(blade_index("e45") == 15);
	CHECK(blade_index("e123") == 16);
	CHECK(blade_index("e12345") == 31);
}

TEST_CASE("from_json() reads the same bits back") {
	Random random(5);
	for (int repeat = 0; repeat < 3000; ++repeat) {
		Multivector x = random.multivector() * std::pow(10.0, int(random.uniform(-300.0, 300.0)));
		x[int(random.uniform(0.0, 32.0))] = repeat % 2 == 0 ? 0.0 : -0.0;
		const TextResult<Multivector> read = from_json(to_json(x));
		REQUIRE(read.has_value());
		CHECK(same_bits(*read, x));
	}
	Multivector extreme;
	extreme[0] = std::numeric_limits<double>::max();
	extreme[1] = -std::numeric_limits<double>::denorm_min();
	CHECK(same_bits(*from_json(to_json(extreme)), extreme));
}

TEST_CASE("from_json() accepts arrays and both kinds of objects") {
	Multivector x;
	x[0] = 1.0;
	x[31] = -2.5;
	const std::string numbers = "[1," + array(30).substr(1, 59) + ",-2.5]";
	CHECK(*from_json(numbers) == x);
	CHECK(*from_json(" \r\n\t" + numbers + " \n") == x);
	CHECK(*from_json("{\"coefficients\" : " + numbers + " }") == x);
	// As JSON.stringify writes a typed array, in any order.
	std::string object = "{";
	std::string backwards = "{";
	for (int index = 0; index < 32; ++index) {
		const auto entry = [&](int at) { return "\"" + std::to_string(at) + "\":" + (at == 0 ? "1" : (at == 31 ? "-25e-1" : "0")); };
		object += (index > 0 ? "," : "") + entry(index);
		backwards += (index > 0 ? ", " : "") + entry(31 - index);
	}
	CHECK(*from_json(object + "}") == x);
	CHECK(*from_json(backwards + "}") == x);
	CHECK((*from_json(array(32, "1E+2")))[7] == 100.0);
	CHECK((*from_json(array(32, "-0")))[7] == 0.0);
	CHECK((*from_json(array(32, "1e-999")))[7] == 0.0);
}

TEST_CASE("an error has the position and what was expected") {
	CHECK(error_of("") == "column 1: expected '[' or '{', found the end");
	CHECK(error_of("  x") == "column 3: expected '[' or '{', found 'x'");
	CHECK(error_of("\"text\"") == "column 1: expected '[' or '{', found '\"'");
	CHECK(error_of("[]") == "column 2: expected 32 numbers, found the end of the array after 0");
	CHECK(error_of("[1, 2]") == "column 6: expected 32 numbers, found the end of the array after 2");
	CHECK(error_of(array(33)) == "column 65: expected ']' after 32 numbers, found ','");
	CHECK(error_of("[1 2") == "column 4: expected ',' or ']', found '2'");
	CHECK(error_of("[1,") == "column 4: expected a number, found the end");
	CHECK(error_of("[1,]") == "column 4: expected a number, found ']'");
	CHECK(error_of("[[1") == "column 2: expected a number, found '['");
	CHECK(error_of("[null") == "column 2: expected a number, found 'n'");
	CHECK(error_of("[NaN") == "column 2: expected a number, found 'N'");
	CHECK(error_of("[\"1\"") == "column 2: expected a number, found '\"'");
	CHECK(error_of("[+1") == "column 2: expected a number, found '+'");
	CHECK(error_of("[.5") == "column 2: expected a number, found '.'");
	CHECK(error_of("[-") == "column 3: expected a digit, found the end");
	CHECK(error_of("[1.,") == "column 4: expected a digit after the decimal point, found ','");
	CHECK(error_of("[1e,") == "column 4: expected a digit of the exponent, found ','");
	CHECK(error_of("[01") == "column 3: expected ',' or ']', found '1'");
	CHECK(error_of("[0x1") == "column 3: expected ',' or ']', found 'x'");
	CHECK(error_of("[1,\n 1e309") == "line 2, column 2: the number is too large; at most 1.8e308 is accepted");
	CHECK(error_of(array(32) + " x") == "column 67: expected the end, found 'x'");
	CHECK(error_of(array(32) + std::string(1, '\0')) == "column 66: expected the end, found the control character 0x00");
	CHECK(error_of(std::string(1, '\0') + array(32)) == "column 1: expected '[' or '{', found the control character 0x00");
	CHECK(error_of("\xef\xbb\xbf[") == "column 1: expected '[' or '{', found '\xef\xbb\xbf'");
	CHECK(error_of("[\xff") == "column 2: expected a number, found the byte 0xff");
	CHECK(error_of("{}") == "column 2: expected a key in double quotes, found '}'");
	CHECK(error_of("{\"coefficients\" [") == "column 17: expected ':' after the key, found '['");
	CHECK(error_of("{\"coefficients\": 3}") == "column 18: expected '[', found '3'");
	CHECK(error_of("{\"coefficients\":" + array(32) + ",") == "column 82: expected '}' after the coefficients, found ','");
	CHECK(error_of("{\"values\":" + array(32) + "}") == "column 2: expected the key \"coefficients\" or keys from \"0\" to \"31\"");
	CHECK(error_of("{\"32\":1}") == "column 2: expected the key \"coefficients\" or keys from \"0\" to \"31\"");
	CHECK(error_of("{\"01\":1}") == "column 2: expected the key \"coefficients\" or keys from \"0\" to \"31\"");
	CHECK(error_of("{\"\\u0030\":1}") == "column 12: expected 32 numbers, found the end of the object after 1");
	CHECK(error_of("{\"0") == "column 4: expected '\"' at the end of the string, found the end");
	CHECK(error_of("{\"0\":1,\"0\":2}") == "column 8: the key \"0\" occurs twice");
	CHECK(error_of("{\"0\":1,\"coefficients\":[]}") == "column 8: expected a key from \"0\" to \"31\"");
	CHECK(error_of("{\"0\":1}") == "column 7: expected 32 numbers, found the end of the object after 1");
	CHECK(error_of("{\"0\":1,}") == "column 8: expected a key in double quotes, found '}'");
}

TEST_CASE("deeply nested and long texts give an error immediately") {
	CHECK(error_of(std::string(100000, '[')) == "column 65537: the text is too long: it has 100000 bytes, and at most 65536 are accepted");
	CHECK(error_of(std::string(60000, '[')) == "column 2: expected a number, found '['");
	CHECK(error_of("[" + std::string(60000, '9')) == "column 2: the number is too large; at most 1.8e308 is accepted");
	CHECK(error_of("{" + std::string(60000, ' ')) == "column 60002: expected a key in double quotes, found the end");
}

TEST_CASE("mutated texts neither crash nor give values that are not finite") {
	std::mt19937_64 engine(6);
	Random random(7);
	const std::string alphabet = "[]{}:,\"0123456789.-+eE \n\t\\nulltrefascoi\xff\xc3";
	int read_count = 0;
	int rejected = 0;
	for (int repeat = 0; repeat < 20000; ++repeat) {
		std::string text = to_json(random.multivector());
		text = repeat % 3 == 0 ? "{\"coefficients\":" + text + "}" : text;
		for (size_t change = engine() % 4; change-- > 0;) {
			const size_t at = engine() % text.size();
			switch (engine() % 3) {
				case 0:
					text[at] = alphabet[engine() % alphabet.size()];
					break;
				case 1:
					text.erase(at, 1 + engine() % 5);
					break;
				default:
					text.insert(at, 1, alphabet[engine() % alphabet.size()]);
			}
		}
		const TextResult<Multivector> result = from_json(text);
		if (result) {
			CHECK(result->is_finite());
			CHECK(*from_json(to_json(*result)) == *result);
			++read_count;
		} else {
			CHECK(result.error().offset <= text.size());
			CHECK_FALSE(result.error().message.empty());
			++rejected;
		}
	}
	CHECK(read_count > 2000);
	CHECK(rejected > 2000);
}
