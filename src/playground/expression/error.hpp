#pragma once

#include "cga/algebra/algebra_error.hpp"

#include <string>
#include <utility>

namespace playground {

// Why something was refused, where no place in a text is to blame (that is cga::TextError): what was wrong and what is
// accepted, without a final period.
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
