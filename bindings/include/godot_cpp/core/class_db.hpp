#pragma once

#include <godot_cpp/classes/global_constants_binds.hpp>
#include <godot_cpp/core/call.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/method_bind.hpp>

#include <memory>

namespace godot {

#define DEFVAL(m_value) (m_value)

namespace internal {

struct VirtualMethod {
	StringName name;
	uint32_t hash;
	GDExtensionClassCallVirtual call;
};

// A registered class, and the data that must exist while it is registered.
struct ClassInfo {
	StringName name;
	GDExtensionInitializationLevel level;
	std::vector<std::unique_ptr<MethodBind>> methods;
	std::vector<VirtualMethod> virtual_methods;
};

template <auto METHOD>
void call_override(GDExtensionClassInstancePtr p_instance, const GDExtensionConstTypePtr *p_args, GDExtensionTypePtr r_result) {
	invoke_typed(METHOD, p_instance, p_args, r_result);
}

// Makes the engine call a virtual method if T or a parent of T overrides it; the pointers' types differ then.
template <typename T, auto ENGINE_METHOD, auto METHOD>
void bind_override(ClassInfo &r_class, const char *p_name, uint32_t p_hash) {
	if constexpr (!std::is_same_v<decltype(ENGINE_METHOD), decltype(METHOD)>) {
		r_class.virtual_methods.push_back({ StringName(p_name), p_hash, &call_override<METHOD> });
	}
}

} // namespace internal

class ClassDB {
public:
	// Register parents before their children.
	template <typename T>
	static void register_class() {
		static_assert(std::is_same_v<T, typename T::self_type>, "The class does not contain GDCLASS.");
		// As types: with -fsanitize=undefined a comparison of functions is not a constant expression.
		using Own = std::integral_constant<void (*)(), &T::_bind_methods>;
		using Inherited = std::integral_constant<void (*)(), &T::parent_type::_bind_methods>;
		static_assert(!std::is_same_v<Own, Inherited>, "The class has no static void _bind_methods().");
		GDExtensionClassCreationInfo5 info{};
		info.notification_func = &T::_notify;
		info.to_string_func = std::is_same_v<decltype(T::_to_string_method()), decltype(Wrapped::_to_string_method())> ? nullptr : &T::_describe;
		info.create_instance_func = &create<T>;
		internal::ClassInfo *added = register_extension_class(T::get_class_static(), T::parent_type::get_class_static(), info);
		T::template register_virtuals<T>(*added);
		T::_bind_methods();
	}

	// p_defaults are the default values of the last arguments.
	template <typename M, typename... Defaults>
	static MethodBind *bind_method(const MethodDefinition &p_definition, M p_method, const Defaults &...p_defaults) {
		return add_method(internal::Signature<M>::Class::get_class_static(), new internal::MethodBindOf<M>(p_definition, p_method, { Variant(p_defaults)... }));
	}
	template <typename M, typename... Defaults>
	static MethodBind *bind_static_method(const StringName &p_class, const MethodDefinition &p_definition, M p_method, const Defaults &...p_defaults) {
		return add_method(p_class, new internal::MethodBindOf<M>(p_definition, p_method, { Variant(p_defaults)... }));
	}

	// The setter and the getter must be bound already. An empty setter makes the property read-only.
	static void add_property(const StringName &p_class, const PropertyInfo &p_info, const StringName &p_setter, const StringName &p_getter);
	static void add_signal(const StringName &p_class, const MethodInfo &p_signal);
	static void bind_integer_constant(const StringName &p_class, const StringName &p_enum, const StringName &p_name, int64_t p_value);

private:
	friend class GDExtensionBinding;

	static GDExtensionInitializationLevel current_level;

	static internal::ClassInfo *register_extension_class(const StringName &p_name, const StringName &p_parent, GDExtensionClassCreationInfo5 &r_info);
	static void unregister_classes(GDExtensionInitializationLevel p_level);
	static MethodBind *add_method(const StringName &p_class, MethodBind *p_bind);
	static GDExtensionClassCallVirtual get_virtual(void *p_class, GDExtensionConstStringNamePtr p_name, uint32_t p_hash);
	static void free_instance(void *p_class, GDExtensionClassInstancePtr p_instance);

	template <typename T>
	static GDExtensionObjectPtr create(void *, GDExtensionBool p_notify) {
		const internal::Construction construction(T::_extension_class_name());
		T *object = new (internal::EngineMemory{}) T;
		if (p_notify) {
			internal::post_initialize(object);
		}
		return object->_owner;
	}
};

} // namespace godot

#define GDREGISTER_CLASS(m_class) ::godot::ClassDB::register_class<m_class>()

// For use in _bind_methods().
#define ADD_PROPERTY(m_property, m_setter, m_getter) ::godot::ClassDB::add_property(get_class_static(), m_property, m_setter, m_getter)
#define ADD_SIGNAL(m_signal) ::godot::ClassDB::add_signal(get_class_static(), m_signal)
#define BIND_ENUM_CONSTANT(m_constant) ::godot::ClassDB::bind_integer_constant(get_class_static(), ::godot::internal::enum_class_name(::godot::internal::Arg<decltype(m_constant)>::NAME).get_slice(".", 1), #m_constant, m_constant)
