#pragma once

#include <godot_cpp/core/object.hpp>

#include <tuple>
#include <vector>

// Calls from the engine into methods of extension classes.
namespace godot {

// The name of a method and of its arguments.
struct MethodDefinition {
	StringName name;
	std::vector<StringName> arguments;
};

template <typename... Args>
MethodDefinition D_METHOD(const StringName &p_name, const Args &...p_arguments) {
	return MethodDefinition{ p_name, { StringName(p_arguments)... } };
}

namespace internal {

struct ArgumentType {
	GDExtensionVariantType type;
	GDExtensionClassMethodArgumentMetadata metadata;
	bool (*accepts)(const Variant &);
	PropertyInfo (*info)();
};

template <typename T>
constexpr ArgumentType argument_type() {
	using A = Arg<std::decay_t<T>>;
	return { A::TYPE, A::METADATA, A::ACCEPTS, &A::info };
}

// The signature of a method: const, non-const or static.
template <typename M>
struct Signature;

template <typename C, typename R, typename... Args>
struct Signature<R (C::*)(Args...)> {
	using Class = C;
	using Instance = C;
	using Result = R;
	using Arguments = std::tuple<std::decay_t<Args>...>;
	static constexpr uint32_t FLAGS = GDEXTENSION_METHOD_FLAG_NORMAL;
	static constexpr ArgumentType TYPES[] = { argument_type<Args>()..., {} };
};

template <typename C, typename R, typename... Args>
struct Signature<R (C::*)(Args...) const> : Signature<R (C::*)(Args...)> {
	using Instance = const C;
	static constexpr uint32_t FLAGS = GDEXTENSION_METHOD_FLAG_NORMAL | GDEXTENSION_METHOD_FLAG_CONST;
};

template <typename R, typename... Args>
struct Signature<R (*)(Args...)> : Signature<R (Wrapped::*)(Args...)> {
	static constexpr uint32_t FLAGS = GDEXTENSION_METHOD_FLAG_STATIC;
};

template <typename S>
inline constexpr size_t ARGUMENT_COUNT = std::tuple_size_v<typename S::Arguments>;

// Calls a method, which may be static. p_get returns the argument of a given type and index.
template <typename M, typename Get, size_t... I>
auto invoke(M p_method, [[maybe_unused]] GDExtensionClassInstancePtr p_instance, [[maybe_unused]] const Get &p_get, std::index_sequence<I...>) {
	using S = Signature<M>;
	using Arguments = typename S::Arguments;
	if constexpr ((S::FLAGS & GDEXTENSION_METHOD_FLAG_STATIC) != 0) {
		return p_method(p_get(Arg<std::tuple_element_t<I, Arguments>>(), I)...);
	} else {
		auto *instance = static_cast<typename S::Class *>(static_cast<Wrapped *>(p_instance));
		return (instance->*p_method)(p_get(Arg<std::tuple_element_t<I, Arguments>>(), I)...);
	}
}

// Calls a method with arguments in the engine's representation and stores the result.
template <typename M>
void invoke_typed(M p_method, GDExtensionClassInstancePtr p_instance, const GDExtensionConstTypePtr *p_args, [[maybe_unused]] GDExtensionTypePtr r_result) {
	using R = typename Signature<M>::Result;
	const auto get = [p_args](auto p_arg, size_t p_index) { return decltype(p_arg)::decode(p_args[p_index]); };
	const auto indices = std::make_index_sequence<ARGUMENT_COUNT<Signature<M>>>();
	if constexpr (std::is_void_v<R>) {
		invoke(p_method, p_instance, get, indices);
	} else {
		Arg<std::decay_t<R>>::store(r_result, invoke(p_method, p_instance, get, indices));
	}
}

} // namespace internal

// A method of an extension class that scripts can call.
class MethodBind {
public:
	const MethodDefinition definition;
	const std::vector<Variant> defaults; // of the last arguments
	const uint32_t flags;
	const int argument_count;
	const internal::ArgumentType *const argument_types;
	const internal::ArgumentType result_type; // its info is null if there is no result
	const GDExtensionClassMethodCall call;
	const GDExtensionClassMethodPtrCall typed_call;

	virtual ~MethodBind() = default;

protected:
	template <typename S>
	MethodBind(const S &, const MethodDefinition &p_definition, std::vector<Variant> &&p_defaults, GDExtensionClassMethodCall p_call, GDExtensionClassMethodPtrCall p_typed_call) :
			definition(p_definition), defaults(std::move(p_defaults)), flags(S::FLAGS), argument_count(internal::ARGUMENT_COUNT<S>), argument_types(S::TYPES), result_type(result<typename S::Result>()), call(p_call), typed_call(p_typed_call) {}

	// Fills r_complete with the arguments, and with defaults for missing ones. Returns false and sets r_error if their
	// number or a type is wrong.
	bool complete_arguments(GDExtensionClassInstancePtr p_instance, const GDExtensionConstVariantPtr *p_args, int64_t p_count, const Variant **r_complete, GDExtensionCallError &r_error) const;

private:
	template <typename R>
	static constexpr internal::ArgumentType result() {
		if constexpr (std::is_void_v<R>) {
			return {};
		} else {
			return internal::argument_type<R>();
		}
	}
};

namespace internal {

template <typename M>
class MethodBindOf final : public MethodBind {
	using S = Signature<M>;
	using Indices = std::make_index_sequence<internal::ARGUMENT_COUNT<S>>;

	const M _method;

	static void call_with_variants(void *p_bind, GDExtensionClassInstancePtr p_instance, const GDExtensionConstVariantPtr *p_args, GDExtensionInt p_count, GDExtensionVariantPtr r_result, GDExtensionCallError *r_error) {
		const MethodBindOf *bind = static_cast<const MethodBindOf *>(p_bind);
		const Variant *complete[internal::ARGUMENT_COUNT<S> + 1];
		if (!bind->complete_arguments(p_instance, p_args, p_count, complete, *r_error)) {
			return;
		}
		const auto get = [&complete](auto p_arg, size_t p_index) { return decltype(p_arg)::from_variant(*complete[p_index]); };
		if constexpr (std::is_void_v<typename S::Result>) {
			invoke(bind->_method, p_instance, get, Indices());
		} else {
			*static_cast<Variant *>(r_result) = Variant(invoke(bind->_method, p_instance, get, Indices()));
		}
	}

	static void call_typed(void *p_bind, GDExtensionClassInstancePtr p_instance, const GDExtensionConstTypePtr *p_args, GDExtensionTypePtr r_result) {
		invoke_typed(static_cast<const MethodBindOf *>(p_bind)->_method, p_instance, p_args, r_result);
	}

public:
	MethodBindOf(const MethodDefinition &p_definition, M p_method, std::vector<Variant> &&p_defaults) :
			MethodBind(S(), p_definition, std::move(p_defaults), &call_with_variants, &call_typed), _method(p_method) {}
};

} // namespace internal

} // namespace godot
