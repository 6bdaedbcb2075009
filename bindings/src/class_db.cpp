#include <godot_cpp/core/class_db.hpp>

#include <godot_cpp/godot.hpp>

#include <algorithm>

namespace godot {

using internal::ArgumentType;
using internal::ClassInfo;

GDExtensionInitializationLevel ClassDB::current_level = GDEXTENSION_INITIALIZATION_CORE;

// In the order of registration. On the heap, and emptied before the library is unloaded: a static destructor would run
// after the engine has shut down.
static std::vector<std::unique_ptr<ClassInfo>> *classes = nullptr;

static ClassInfo *find_class(const StringName &p_name) {
	for (const std::unique_ptr<ClassInfo> &info : *classes) {
		if (info->name == p_name) {
			return info.get();
		}
	}
	return nullptr;
}

static bool has_method(const ClassInfo &p_class, const StringName &p_name) {
	return std::any_of(p_class.methods.begin(), p_class.methods.end(), [&](const std::unique_ptr<MethodBind> &p_bind) { return p_bind->definition.name == p_name; });
}

bool MethodBind::complete_arguments(GDExtensionClassInstancePtr p_instance, const GDExtensionConstVariantPtr *p_args, int64_t p_count, const Variant **r_complete, GDExtensionCallError &r_error) const {
	r_error.error = GDEXTENSION_CALL_OK;
	const int64_t required = argument_count - static_cast<int64_t>(defaults.size());
	if (p_instance == nullptr && !(flags & GDEXTENSION_METHOD_FLAG_STATIC)) {
		r_error.error = GDEXTENSION_CALL_ERROR_INSTANCE_IS_NULL;
	} else if (p_count > argument_count) {
		r_error.error = GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS;
		r_error.expected = argument_count;
	} else if (p_count < required) {
		r_error.error = GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS;
		r_error.expected = static_cast<int32_t>(required);
	}
	for (int i = 0; i < argument_count && r_error.error == GDEXTENSION_CALL_OK; i++) {
		const Variant &argument = i < p_count ? *static_cast<const Variant *>(p_args[i]) : defaults[static_cast<size_t>(i - required)];
		const ArgumentType &wanted = argument_types[i];
		const bool fits = wanted.type == GDEXTENSION_VARIANT_TYPE_NIL || Variant::can_convert_strict(argument.get_type(), static_cast<Variant::Type>(wanted.type));
		if (!fits || (wanted.accepts && !wanted.accepts(argument))) {
			r_error.error = GDEXTENSION_CALL_ERROR_INVALID_ARGUMENT;
			r_error.argument = i;
			r_error.expected = wanted.type;
		}
		r_complete[i] = &argument;
	}
	return r_error.error == GDEXTENSION_CALL_OK;
}

ClassInfo *ClassDB::register_extension_class(const StringName &p_name, const StringName &p_parent, GDExtensionClassCreationInfo5 &r_info) {
	if (classes == nullptr) {
		classes = new std::vector<std::unique_ptr<ClassInfo>>;
	}
	classes->push_back(std::unique_ptr<ClassInfo>(new ClassInfo{ p_name, current_level, {}, {} }));
	ClassInfo *added = classes->back().get();
	r_info.is_exposed = true;
	r_info.free_instance_func = &free_instance;
	r_info.get_virtual_func = &get_virtual;
	r_info.class_userdata = added;
	// Godot 4.4 has only the older function, with the same structure by another name.
	const GDExtensionInterfaceClassdbRegisterExtensionClass5 register_class = gdextension_interface::classdb_register_extension_class5 ? gdextension_interface::classdb_register_extension_class5 : gdextension_interface::classdb_register_extension_class4;
	register_class(gdextension_interface::library, p_name._native_ptr(), p_parent._native_ptr(), &r_info);
	return added;
}

void ClassDB::unregister_classes(GDExtensionInitializationLevel p_level) {
	// Children before their parents.
	while (classes && !classes->empty() && classes->back()->level == p_level) {
		gdextension_interface::classdb_unregister_extension_class(gdextension_interface::library, classes->back()->name._native_ptr());
		classes->pop_back();
	}
	if (classes && classes->empty()) {
		delete std::exchange(classes, nullptr);
	}
}

MethodBind *ClassDB::add_method(const StringName &p_class, MethodBind *p_bind) {
	std::unique_ptr<MethodBind> bind(p_bind);
	const MethodDefinition &definition = bind->definition;
	ClassInfo *info = find_class(p_class);
	ERR_FAIL_NULL_V_MSG(info, nullptr, vformat("Class %s is not registered.", p_class));
	ERR_FAIL_COND_V_MSG(has_method(*info, definition.name), nullptr, vformat("Method %s.%s is bound twice.", p_class, definition.name));
	ERR_FAIL_COND_V_MSG(static_cast<int>(definition.arguments.size()) != bind->argument_count, nullptr, vformat("Method %s.%s has %d arguments, but D_METHOD names %d.", p_class, definition.name, bind->argument_count, static_cast<uint64_t>(definition.arguments.size())));
	ERR_FAIL_COND_V_MSG(static_cast<int>(bind->defaults.size()) > bind->argument_count, nullptr, vformat("Method %s.%s has more defaults than arguments.", p_class, definition.name));

	std::vector<PropertyInfo> infos;
	std::vector<GDExtensionPropertyInfo> c_infos;
	std::vector<GDExtensionClassMethodArgumentMetadata> metadata;
	infos.reserve(definition.arguments.size());
	for (size_t i = 0; i < definition.arguments.size(); i++) {
		infos.push_back(bind->argument_types[i].info());
		infos.back().name = definition.arguments[i];
		c_infos.push_back(infos.back()._to_gdextension());
		metadata.push_back(bind->argument_types[i].metadata);
	}
	std::vector<GDExtensionVariantPtr> defaults;
	for (const Variant &value : bind->defaults) {
		defaults.push_back(value._native_ptr());
	}
	const PropertyInfo result = bind->result_type.info ? bind->result_type.info() : PropertyInfo();
	GDExtensionPropertyInfo c_result = result._to_gdextension();

	GDExtensionClassMethodInfo method{};
	method.name = definition.name._native_ptr();
	method.method_userdata = p_bind;
	method.call_func = bind->call;
	method.ptrcall_func = bind->typed_call;
	method.method_flags = bind->flags;
	method.has_return_value = bind->result_type.info != nullptr;
	method.return_value_info = &c_result;
	method.return_value_metadata = bind->result_type.metadata;
	method.argument_count = static_cast<uint32_t>(c_infos.size());
	method.arguments_info = c_infos.data();
	method.arguments_metadata = metadata.data();
	method.default_argument_count = static_cast<uint32_t>(defaults.size());
	method.default_arguments = defaults.data();
	gdextension_interface::classdb_register_extension_class_method(gdextension_interface::library, p_class._native_ptr(), &method);
	info->methods.push_back(std::move(bind));
	return p_bind;
}

void ClassDB::add_property(const StringName &p_class, const PropertyInfo &p_info, const StringName &p_setter, const StringName &p_getter) {
	const ClassInfo *info = find_class(p_class);
	ERR_FAIL_NULL_MSG(info, vformat("Class %s is not registered.", p_class));
	ERR_FAIL_COND_MSG(p_setter != StringName() && !has_method(*info, p_setter), vformat("Property %s.%s: its setter %s must be bound first.", p_class, p_info.name, p_setter));
	ERR_FAIL_COND_MSG(!has_method(*info, p_getter), vformat("Property %s.%s: its getter %s must be bound first.", p_class, p_info.name, p_getter));
	const GDExtensionPropertyInfo c_info = p_info._to_gdextension();
	gdextension_interface::classdb_register_extension_class_property(gdextension_interface::library, p_class._native_ptr(), &c_info, p_setter._native_ptr(), p_getter._native_ptr());
}

void ClassDB::add_signal(const StringName &p_class, const MethodInfo &p_signal) {
	std::vector<GDExtensionPropertyInfo> arguments;
	arguments.reserve(p_signal.arguments.size());
	for (const PropertyInfo &argument : p_signal.arguments) {
		arguments.push_back(argument._to_gdextension());
	}
	gdextension_interface::classdb_register_extension_class_signal(gdextension_interface::library, p_class._native_ptr(), p_signal.name._native_ptr(), arguments.data(), static_cast<GDExtensionInt>(arguments.size()));
}

void ClassDB::bind_integer_constant(const StringName &p_class, const StringName &p_enum, const StringName &p_name, int64_t p_value) {
	gdextension_interface::classdb_register_extension_class_integer_constant(gdextension_interface::library, p_class._native_ptr(), p_enum._native_ptr(), p_name._native_ptr(), p_value, false);
}

GDExtensionClassCallVirtual ClassDB::get_virtual(void *p_class, GDExtensionConstStringNamePtr p_name, uint32_t p_hash) {
	const StringName &name = *static_cast<const StringName *>(p_name);
	for (const internal::VirtualMethod &method : static_cast<const ClassInfo *>(p_class)->virtual_methods) {
		if (method.name == name && method.hash == p_hash) {
			return method.call;
		}
	}
	return nullptr;
}

void ClassDB::free_instance(void *, GDExtensionClassInstancePtr p_instance) {
	internal::WrapperFactory::destroy(static_cast<Wrapped *>(p_instance));
}

} // namespace godot
