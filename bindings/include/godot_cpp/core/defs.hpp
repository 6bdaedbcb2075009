#pragma once

#include <cstddef>
#include <cstdint>

// Godot's name for its floating-point type; the bindings support single precision only.
typedef float real_t;

#ifndef likely
#ifdef __GNUC__
#define likely(m_condition) __builtin_expect(!!(m_condition), 1)
#define unlikely(m_condition) __builtin_expect(!!(m_condition), 0)
#else
#define likely(m_condition) (m_condition)
#define unlikely(m_condition) (m_condition)
#endif
#endif

#ifdef _WIN32
#define GDE_EXPORT __declspec(dllexport)
#else
#define GDE_EXPORT __attribute__((visibility("default")))
#endif

#ifdef _MSC_VER
#define _FORCE_INLINE_ __forceinline
#define _ALWAYS_INLINE_ __forceinline
#else
#define _FORCE_INLINE_ inline
#define _ALWAYS_INLINE_ __attribute__((always_inline)) inline
#endif
