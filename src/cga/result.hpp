#pragma once

#include <optional>
#include <type_traits>
#include <utility>

namespace cga {

// A value, or the error that explains why there is none. Both convert to it:
//
//   Result<Pose<double>, MatrixError> to_pose(...) {
//       if (determinant < 0.0) {
//           return MatrixError::MIRRORED;
//       }
//       return pose;
//   }
//
// T has a default constructor. E is an enum with a function `describe`, or a struct with a message. Where there is only one
// reason, use std::optional instead. Ignoring a Result is a compiler warning.
template <class T, class E>
class [[nodiscard]] Result {
	static_assert(!std::is_same_v<T, E>, "A value and an error of the same type are indistinguishable");

public:
	constexpr Result(T value) :
			_value(std::move(value)) {}
	// Constructs the value in place from its members; a copy of a Pose<double> costs 5 ns.
	template <class... Members>
	constexpr Result(std::in_place_t, Members &&...members) :
			_value{ std::forward<Members>(members)... } {}
	constexpr Result(E error) :
			_error(std::move(error)) {}
	// Converts from a Result whose error type converts to E.
	template <class F, class = std::enable_if_t<std::is_convertible_v<F, E>>>
	constexpr Result(const Result<T, F> &other) :
			_value(other ? *other : T()), _error(other ? std::nullopt : std::optional<E>(other.error())) {}

	[[nodiscard]] constexpr bool has_value() const noexcept { return !_error.has_value(); }
	constexpr explicit operator bool() const noexcept { return has_value(); }

	// Precondition: has_value().
	[[nodiscard]] constexpr const T &operator*() const & noexcept { return _value; }
	[[nodiscard]] constexpr T &operator*() & noexcept { return _value; }
	[[nodiscard]] constexpr T &&operator*() && noexcept { return std::move(_value); }
	[[nodiscard]] constexpr const T *operator->() const noexcept { return &_value; }
	[[nodiscard]] constexpr T *operator->() noexcept { return &_value; }

	// Precondition: !has_value(). To propagate it as another Result: `return result.error();`
	[[nodiscard]] constexpr const E &error() const noexcept { return *_error; }

private:
	T _value{};
	std::optional<E> _error;
};

// Success without a value (`return {};`), or an error.
template <class E>
class [[nodiscard]] Result<void, E> {
public:
	constexpr Result() = default;
	constexpr Result(E error) :
			_error(std::move(error)) {}

	[[nodiscard]] constexpr bool has_value() const noexcept { return !_error.has_value(); }
	constexpr explicit operator bool() const noexcept { return has_value(); }

	// Precondition: !has_value().
	[[nodiscard]] constexpr const E &error() const noexcept { return *_error; }

private:
	std::optional<E> _error;
};

} // namespace cga
