#include "cga/result.hpp"

#include <doctest/doctest.h>

#include <string>

using cga::Failure;
using cga::Result;

namespace {

Result<std::string> greeting(bool polite) {
	if (!polite) {
		return Failure{ "Nobody is greeted; be polite" };
	}
	return std::string("good day");
}

} // namespace

TEST_CASE("a result is a value or the reason why there is none") {
	const Result<std::string> good = greeting(true);
	CHECK(good);
	CHECK(good.has_value());
	CHECK(*good == "good day");
	CHECK(good->size() == 8);
	CHECK(std::string(good.error()).empty());

	const Result<std::string> bad = greeting(false);
	CHECK_FALSE(bad);
	CHECK_FALSE(bad.has_value());
	CHECK(std::string(bad.error()) == "Nobody is greeted; be polite");
	const Result<int> handed_on = bad.failure();
	CHECK(std::string(handed_on.error()) == bad.error());
}
