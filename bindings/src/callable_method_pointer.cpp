#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <godot_cpp/godot.hpp>

#include <algorithm>

namespace godot::internal {

namespace {

struct CustomCallable {
	CallableMethod method;
	GDObjectInstanceID object;
};

GDExtensionBool is_valid(void *p_callable) {
	return gdextension_interface::object_get_instance_from_id(static_cast<const CustomCallable *>(p_callable)->object) != nullptr;
}

void call(void *p_callable, const GDExtensionConstVariantPtr *p_args, GDExtensionInt p_count, GDExtensionVariantPtr r_result, GDExtensionCallError *r_error) {
	const CallableMethod &method = static_cast<const CustomCallable *>(p_callable)->method;
	method.bind->call(method.bind.get(), is_valid(p_callable) ? method.instance : nullptr, p_args, p_count, r_result, r_error);
}

void destroy(void *p_callable) {
	delete static_cast<CustomCallable *>(p_callable);
}

uint32_t hash(void *p_callable) {
	const CustomCallable *callable = static_cast<const CustomCallable *>(p_callable);
	return static_cast<uint32_t>(std::hash<uint64_t>()(callable->object * 31 + callable->method.method[0]));
}

GDExtensionBool is_equal(void *p_left, void *p_right) {
	const CustomCallable *left = static_cast<const CustomCallable *>(p_left);
	const CustomCallable *right = static_cast<const CustomCallable *>(p_right);
	return left->object == right->object && std::equal(std::begin(left->method.method), std::end(left->method.method), right->method.method);
}

GDExtensionInt count_arguments(void *p_callable, GDExtensionBool *r_is_valid) {
	*r_is_valid = true;
	return static_cast<const CustomCallable *>(p_callable)->method.bind->argument_count;
}

} // namespace

Callable create_callable(CallableMethod &&p_method) {
	GDExtensionCallableCustomInfo2 info{};
	info.token = gdextension_interface::token;
	info.object_id = gdextension_interface::object_get_instance_id(p_method.instance->_owner);
	info.callable_userdata = new CustomCallable{ std::move(p_method), info.object_id };
	info.call_func = &call;
	info.is_valid_func = &is_valid;
	info.free_func = &destroy;
	info.hash_func = &hash;
	info.equal_func = &is_equal;
	info.get_argument_count_func = &count_arguments;
	Callable callable{ Uninitialized() };
	gdextension_interface::callable_custom_create2(callable._native_ptr(), &info);
	return callable;
}

} // namespace godot::internal
