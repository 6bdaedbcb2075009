#pragma once

#include <godot_cpp/core/method_bind.hpp>

#include <memory>

namespace godot {

namespace internal {

// A method and the object to call it on. Scripts can call the Callable, so its arguments are checked like those of a bound
// method, and a call after the object was freed is an error.
struct CallableMethod {
	std::unique_ptr<MethodBind> bind;
	Wrapped *instance;
	uint64_t method[3] = {}; // the bytes of the pointer, for comparison
};

Callable create_callable(CallableMethod &&p_method);

template <typename T, typename M>
Callable create_callable(T *p_instance, M p_method) {
	CallableMethod method{ std::make_unique<MethodBindOf<M>>(MethodDefinition(), p_method, std::vector<Variant>()), p_instance };
	static_assert(sizeof(M) <= sizeof(method.method), "The method pointer does not fit.");
	memcpy(method.method, &p_method, sizeof(M));
	return create_callable(std::move(method));
}

} // namespace internal

template <typename T, typename R, typename... P>
Callable create_custom_callable_function_pointer(T *p_instance, R (T::*p_method)(P...)) {
	return internal::create_callable(p_instance, p_method);
}
template <typename T, typename R, typename... P>
Callable create_custom_callable_function_pointer(const T *p_instance, R (T::*p_method)(P...) const) {
	return internal::create_callable(const_cast<T *>(p_instance), p_method);
}

} // namespace godot

// A Callable of a method that need not be bound. Two of them are equal if object and method are.
#define callable_mp(m_instance, m_method) ::godot::create_custom_callable_function_pointer(m_instance, m_method)
