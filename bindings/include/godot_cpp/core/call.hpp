#pragma once

#include <godot_cpp/core/binder_common.hpp>

#include <array>

// Calls from here into the engine.
namespace godot::internal {

// Each looks up an engine function by its name and the hash of its signature. If it does not exist, prints an error.
GDExtensionMethodBindPtr find_method(const char *p_class, const char *p_method, int64_t p_hash);
GDExtensionPtrBuiltInMethod find_builtin_method(GDExtensionVariantType p_type, const char *p_method, int64_t p_hash);

// Calls p_call with pointers to the encoded arguments and to memory for the result. Returns the result.
template <typename R, typename Call, typename... Args>
R call_encoded(Call p_call, const Args &...p_encoded) {
	const std::array<GDExtensionConstTypePtr, sizeof...(Args) + 1> pointers = { &p_encoded..., nullptr };
	if constexpr (std::is_void_v<R>) {
		p_call(pointers.data(), nullptr);
	} else {
		typename Arg<R>::Result result{};
		p_call(pointers.data(), &result);
		return Arg<R>::from_result(result);
	}
}

// If the engine does not have the function, the lookup has printed an error, and the call does nothing.
template <typename R, typename... Args>
R call_method(GDExtensionMethodBindPtr p_method, GDExtensionObjectPtr p_owner, const Args &...p_args) {
	const auto call = [&](const GDExtensionConstTypePtr *p_pointers, GDExtensionTypePtr r_result) {
		if (likely(p_method)) {
			gdextension_interface::object_method_bind_ptrcall(p_method, p_owner, p_pointers, r_result);
		}
	};
	return call_encoded<R>(call, Arg<Args>::encode(p_args)...);
}

template <typename R, typename... Args>
R call_builtin_method(GDExtensionPtrBuiltInMethod p_method, GDExtensionTypePtr p_base, const Args &...p_args) {
	const auto call = [&](const GDExtensionConstTypePtr *p_pointers, GDExtensionTypePtr r_result) {
		if (likely(p_method)) {
			p_method(p_base, p_pointers, r_result, sizeof...(Args));
		}
	};
	return call_encoded<R>(call, Arg<Args>::encode(p_args)...);
}

template <typename... Args>
void call_constructor(GDExtensionPtrConstructor p_constructor, GDExtensionUninitializedTypePtr r_base, const Args &...p_args) {
	const auto call = [&](const GDExtensionConstTypePtr *p_pointers, GDExtensionTypePtr) { p_constructor(r_base, p_pointers); };
	call_encoded<void>(call, Arg<Args>::encode(p_args)...);
}

template <typename R>
R call_operator(GDExtensionPtrOperatorEvaluator p_evaluator, GDExtensionConstTypePtr p_left, GDExtensionConstTypePtr p_right) {
	typename Arg<R>::Result result{};
	p_evaluator(p_left, p_right, &result);
	return Arg<R>::from_result(result);
}

Variant call_with_variants(GDExtensionMethodBindPtr p_method, GDExtensionObjectPtr p_owner, const GDExtensionConstVariantPtr *p_args, int64_t p_count);

template <typename... Args>
Variant call_vararg_method(GDExtensionMethodBindPtr p_method, GDExtensionObjectPtr p_owner, const Args &...p_args) {
	const auto call = [&](const auto &...p_variants) {
		const GDExtensionConstVariantPtr pointers[] = { p_variants._native_ptr()... };
		return call_with_variants(p_method, p_owner, pointers, sizeof...(Args));
	};
	return call(Variant(p_args)...);
}

} // namespace godot::internal
