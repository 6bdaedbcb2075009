#include <godot_cpp/core/binder_common.hpp>

namespace godot::internal {

// The start of the last components of a name, which are separated by "::".
static const char *last_component(const char *p_qualified, int p_components) {
	const char *start = p_qualified + strlen(p_qualified);
	while (start > p_qualified && (start[-1] != ':' || --p_components > 0)) {
		start -= start[-1] == ':' ? 2 : 1;
	}
	return start;
}

String enum_class_name(const char *p_qualified) {
	return String(last_component(p_qualified, 2)).replace("::", ".");
}

StringName enum_short_name(const char *p_qualified) {
	return StringName(last_component(p_qualified, 1));
}

} // namespace godot::internal
