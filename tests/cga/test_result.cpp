#include "cga/result.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>

using cga::Result;

namespace {

enum class GreetingError {
	IMPOLITE,
	ASLEEP,
};

Result<std::string, GreetingError> greeting(bool is_polite) {
	if (!is_polite) {
		return GreetingError::IMPOLITE;
	}
	return std::string("good day");
}

Result<size_t, GreetingError> greeting_length(bool is_polite) {
	const Result<std::string, GreetingError> text = greeting(is_polite);
	if (!text) {
		return text.error();
	}
	return text->size();
}

Result<void, GreetingError> wake(bool is_awake) {
	if (!is_awake) {
		return GreetingError::ASLEEP;
	}
	return {};
}

constexpr Result<int, GreetingError> SEVEN = 7;
static_assert(SEVEN.has_value() && *SEVEN == 7);

} // namespace

TEST_CASE("a result is a value or the error that explains why there is none") {
	Result<std::string, GreetingError> good = greeting(true);
	CHECK(good);
	CHECK(good.has_value());
	CHECK(*good == "good day");
	CHECK(good->size() == 8);
	CHECK(*std::move(good) == "good day");
	CHECK(*greeting_length(true) == 8);

	const Result<std::string, GreetingError> bad = greeting(false);
	CHECK_FALSE(bad);
	CHECK_FALSE(bad.has_value());
	CHECK(bad.error() == GreetingError::IMPOLITE);
	CHECK(greeting_length(false).error() == GreetingError::IMPOLITE);
}

TEST_CASE("a result without a value is success or an error") {
	CHECK(wake(true));
	CHECK(wake(true).has_value());
	CHECK_FALSE(wake(false));
	CHECK(wake(false).error() == GreetingError::ASLEEP);
}
