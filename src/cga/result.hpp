#pragma once

#include <optional>
#include <utility>

namespace cga {

// Why there is no value: a sentence without its period that says what was wrong and what to do about it. A literal:
// only the pointer is kept.
struct Failure {
	const char *reason;
};

// A value, or the reason why there is none. Both convert to it, so that a function returns either:
//
//   return Failure{ "A null vector has no inverse; scale or move it first" };
template <class T>
class [[nodiscard]] Result {
public:
	constexpr Result(T value) :
			_value(std::move(value)) {}
	constexpr Result(Failure failure) :
			_error(failure.reason) {}

	[[nodiscard]] constexpr bool has_value() const noexcept { return _value.has_value(); }
	constexpr explicit operator bool() const noexcept { return _value.has_value(); }

	// Only where there is a value.
	[[nodiscard]] constexpr const T &operator*() const noexcept { return *_value; }
	[[nodiscard]] constexpr const T *operator->() const noexcept { return &*_value; }

	// Why there is no value; empty text where there is one.
	[[nodiscard]] constexpr const char *error() const noexcept { return _error; }
	// The failure itself, to hand on as a Result of another type; only where there is no value.
	[[nodiscard]] constexpr Failure failure() const noexcept { return { _error }; }

private:
	std::optional<T> _value;
	const char *_error = "";
};

} // namespace cga
