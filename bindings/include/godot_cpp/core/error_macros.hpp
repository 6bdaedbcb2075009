#pragma once

#include <godot_cpp/core/defs.hpp>

#include <cstdint>

namespace godot {

class String;

namespace internal {

struct ErrorPlace {
	const char *function;
	const char *file;
	int32_t line;
};

void print_error(const ErrorPlace &p_place, const char *p_what, const char *p_message);
void print_error(const ErrorPlace &p_place, const char *p_what, const String &p_message);
void print_warning(const ErrorPlace &p_place, const char *p_what);
void print_warning(const ErrorPlace &p_place, const String &p_what);

} // namespace internal

} // namespace godot

#define GODOT_CPP_PLACE (::godot::internal::ErrorPlace{ __FUNCTION__, __FILE__, __LINE__ })

#define ERR_PRINT(m_message) ::godot::internal::print_error(GODOT_CPP_PLACE, "", m_message)
#define WARN_PRINT(m_message) ::godot::internal::print_warning(GODOT_CPP_PLACE, m_message)

// Base of all macros below: if the condition holds, prints an error and returns.
#define GODOT_CPP_FAIL_IF(m_condition, m_return, m_what, m_message) \
	if (unlikely(m_condition)) { \
		::godot::internal::print_error(GODOT_CPP_PLACE, m_what, m_message); \
		m_return; \
	} else \
		((void)0)

#define ERR_FAIL_MSG(m_message) GODOT_CPP_FAIL_IF(true, return, "Method/function failed.", m_message)
#define ERR_FAIL_V_MSG(m_value, m_message) GODOT_CPP_FAIL_IF(true, return m_value, "Method/function failed. Returning: " #m_value, m_message)

#define ERR_FAIL_COND_MSG(m_condition, m_message) GODOT_CPP_FAIL_IF(m_condition, return, "Condition \"" #m_condition "\" is true.", m_message)
#define ERR_FAIL_COND_V_MSG(m_condition, m_value, m_message) GODOT_CPP_FAIL_IF(m_condition, return m_value, "Condition \"" #m_condition "\" is true. Returning: " #m_value, m_message)

#define ERR_FAIL_NULL_MSG(m_pointer, m_message) GODOT_CPP_FAIL_IF((m_pointer) == nullptr, return, "Parameter \"" #m_pointer "\" is null.", m_message)
#define ERR_FAIL_NULL_V_MSG(m_pointer, m_value, m_message) GODOT_CPP_FAIL_IF((m_pointer) == nullptr, return m_value, "Parameter \"" #m_pointer "\" is null.", m_message)
