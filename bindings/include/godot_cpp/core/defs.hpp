#pragma once

#include <cstddef>
#include <cstdint>

// Godot's name for its floating-point type; the bindings support single precision only.
typedef float real_t;

#define likely(m_condition) __builtin_expect(!!(m_condition), 1)
#define unlikely(m_condition) __builtin_expect(!!(m_condition), 0)

#ifdef _WIN32
#define GDE_EXPORT __declspec(dllexport)
#else
#define GDE_EXPORT __attribute__((visibility("default")))
#endif
