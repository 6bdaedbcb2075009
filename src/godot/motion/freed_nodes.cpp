#include "godot/motion/freed_nodes.hpp"

#include <godot_cpp/godot.hpp>

// The engine reports the end of an object to its instance bindings. The library is not reloadable, so they end before it.

namespace ga_godot {

void *FreedNodes::begin(void *token, void * /*object*/) {
	return token; // The engine calls this again if it is null.
}

void FreedNodes::end(void * /*token*/, void * /*object*/, void * /*binding*/) {
	freed_count.fetch_add(1, std::memory_order_relaxed);
}

void FreedNodes::watch(uint64_t id) {
	namespace interface = godot::gdextension_interface;
	static constexpr GDExtensionInstanceBindingCallbacks CALLBACKS = { &begin, &end, nullptr };
	if (const GDExtensionObjectPtr object = interface::object_get_instance_from_id(id)) {
		interface::object_get_instance_binding(object, &freed_count, &CALLBACKS);
	}
}

} // namespace ga_godot
