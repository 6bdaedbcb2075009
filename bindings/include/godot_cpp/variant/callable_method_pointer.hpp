#pragma once

#include <godot_cpp/core/method_bind.hpp>

#include <memory>

namespace godot::internal {

// A method and the object to call it on. Scripts can call the Callable, so its arguments are checked like those of a bound
// method, and a call after the object was freed is an error.
struct CallableMethod {
	std::unique_ptr<MethodBind> bind;
	Wrapped *instance;
	uint64_t method[3] = {}; // the bytes of the pointer, for comparison
};

Callable create_callable(CallableMethod &&p_method);

template <typename M>
Callable create_callable(typename Signature<M>::Instance *p_instance, M p_method) {
	auto *instance = const_cast<typename Signature<M>::Class *>(p_instance);
	CallableMethod method{ std::make_unique<MethodBindOf<M>>(MethodDefinition(), p_method, std::vector<Variant>()), instance };
	static_assert(sizeof(M) <= sizeof(method.method), "The method pointer does not fit.");
	memcpy(method.method, &p_method, sizeof(M));
	return create_callable(std::move(method));
}

} // namespace godot::internal

// A Callable of a method that need not be bound. Two of them are equal if object and method are.
#define callable_mp(m_instance, m_method) ::godot::internal::create_callable(m_instance, m_method)
