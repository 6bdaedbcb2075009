#include <godot_cpp/core/binder_common.hpp>

namespace godot::internal {

String enum_class_name(const char *p_qualified) {
	const String name = p_qualified;
	const int64_t last = name.get_slice_count("::") - 1;
	return last > 0 ? name.get_slice("::", last - 1) + "." + name.get_slice("::", last) : name;
}

} // namespace godot::internal
