#pragma once

#include "cga/algebra/algebra_error.hpp"

#include <string>
#include <utility>

namespace playground {

// Why a request was refused: what was wrong and what is accepted, without a final period. An error with a position in a
// text is a cga::TextError.
struct Error {
	std::string message;

	Error(std::string reason) :
			message(std::move(reason)) {}
	Error(const char *reason) :
			message(reason) {}
	Error(cga::AlgebraError reason) :
			message(cga::describe(reason)) {}
};

} // namespace playground
