#pragma once

#include <godot_cpp/core/defs.hpp>

#include <type_traits>
#include <utility>

namespace godot {

class StringName;
class Wrapped;

namespace internal {

// Selects the engine's allocator in a new expression: new (EngineMemory{}) T.
struct EngineMemory {};

void *allocate(size_t p_size);
void release(void *p_memory);
void post_initialize(Wrapped *p_object);

// Passes the extension class under construction to the constructor of Wrapped, which knows only the engine class.
// Scopes nest, because an argument of a constructor may call memnew.
class Construction {
	const StringName *_extension_class;
	Construction *_outer;

public:
	explicit Construction(const StringName *p_extension_class);

	// Closes the innermost scope and returns its class; null for a class of the engine.
	static const StringName *take();
};

template <typename T>
T *finish_construction(T *p_object) {
	post_initialize(p_object);
	return p_object;
}

} // namespace internal

void memdelete(Wrapped *p_object);

} // namespace godot

inline void *operator new(size_t p_size, ::godot::internal::EngineMemory) {
	return ::godot::internal::allocate(p_size);
}

inline void operator delete(void *p_memory, ::godot::internal::EngineMemory) {
	::godot::internal::release(p_memory);
}

// Constructs an object of a class of the engine or of an extension. m_class is a type, optionally with constructor arguments
// in parentheses.
#define memnew(m_class) \
	(::godot::internal::Construction(std::remove_pointer_t<decltype(new (::godot::internal::EngineMemory{}) m_class)>::_extension_class_name()), \
			::godot::internal::finish_construction(new (::godot::internal::EngineMemory{}) m_class))
