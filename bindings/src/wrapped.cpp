#include <godot_cpp/classes/wrapped.hpp>

#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/godot.hpp>

#include <mutex>

namespace godot {

namespace internal {

void *allocate(size_t p_size) {
	if (likely(gdextension_interface::mem_alloc2)) {
		return gdextension_interface::mem_alloc2(p_size, false);
	}
	return gdextension_interface::mem_alloc(p_size); // Godot 4.4 and 4.5
}

void release(void *p_memory) {
	if (likely(gdextension_interface::mem_free2)) {
		gdextension_interface::mem_free2(p_memory, false);
	} else {
		gdextension_interface::mem_free(p_memory); // Godot 4.4 and 4.5
	}
}

static thread_local Construction *innermost_construction = nullptr;

Construction::Construction(const StringName *p_extension_class) :
		_extension_class(p_extension_class), _outer(innermost_construction) {
	innermost_construction = this;
}

const StringName *Construction::take() {
	const Construction *construction = innermost_construction;
	if (construction == nullptr) {
		ERR_FAIL_V_MSG(nullptr, "An object was constructed without memnew().");
	}
	innermost_construction = construction->_outer;
	return construction->_extension_class;
}

void post_initialize(Wrapped *p_object) {
	static_cast<Object *>(p_object)->notification(Object::NOTIFICATION_POSTINITIALIZE);
}

void WrapperFactory::destroy(Wrapped *p_wrapped) {
	p_wrapped->~Wrapped();
	release(p_wrapped);
}

// An extension object is its own binding: the engine frees it with the class's free_instance.
static void *create_no_binding(void *, void *) {
	return nullptr;
}

static void free_no_binding(void *, void *, void *) {
}

static GDExtensionBool allow_reference(void *, void *, GDExtensionBool) {
	return true;
}

static void *create_binding(void *, void *p_object) {
	for (int i = ENGINE_CLASS_COUNT - 1; i > 0; i--) {
		const EngineClass &candidate = engine_classes[i];
		if (candidate.tag && gdextension_interface::object_cast_to(p_object, candidate.tag)) {
			return candidate.create_wrapper(p_object);
		}
	}
	return engine_classes[0].create_wrapper(p_object);
}

static void free_binding(void *, void *, void *p_binding) {
	Wrapped *wrapper = static_cast<Wrapped *>(p_binding);
	Singleton::forget(wrapper);
	WrapperFactory::destroy(wrapper);
}

static constexpr GDExtensionInstanceBindingCallbacks EXTENSION_OBJECT_CALLBACKS = { &create_no_binding, &free_no_binding, &allow_reference };
static constexpr GDExtensionInstanceBindingCallbacks ENGINE_OBJECT_CALLBACKS = { &create_binding, &free_binding, &allow_reference };

Object *get_binding(GDExtensionObjectPtr p_object) {
	if (p_object == nullptr) {
		return nullptr;
	}
	void *binding = gdextension_interface::object_get_instance_binding(p_object, gdextension_interface::token, &ENGINE_OBJECT_CALLBACKS);
	return static_cast<Object *>(static_cast<Wrapped *>(binding));
}

void find_class_tags() {
	for (int i = 0; i < ENGINE_CLASS_COUNT; i++) {
		EngineClass &engine_class = engine_classes[i];
		if (engine_class.tag == nullptr) {
			engine_class.tag = gdextension_interface::classdb_get_class_tag(StringName(engine_class.name)._native_ptr());
		}
	}
}

static std::mutex singletons_mutex;
static Singleton *singletons = nullptr;

Object *Singleton::get(const char *p_name) {
	Object *found = _object.load(std::memory_order_acquire);
	if (likely(found)) {
		return found;
	}
	found = get_binding(gdextension_interface::global_get_singleton(StringName(p_name)._native_ptr()));
	const std::lock_guard<std::mutex> lock(singletons_mutex);
	if (found && _object.load(std::memory_order_relaxed) == nullptr) {
		_object.store(found, std::memory_order_release);
		_next = std::exchange(singletons, this);
	}
	return found;
}

void Singleton::forget(const Wrapped *p_wrapper) {
	const std::lock_guard<std::mutex> lock(singletons_mutex);
	for (Singleton **link = &singletons; *link; link = &(*link)->_next) {
		Singleton *singleton = *link;
		if (singleton->_object.load(std::memory_order_relaxed) == p_wrapper) {
			singleton->_object.store(nullptr, std::memory_order_release);
			*link = singleton->_next;
			return;
		}
	}
}

void Singleton::free_all() {
	while (singletons) {
		const Object *wrapper = singletons->_object.load();
		forget(wrapper);
		gdextension_interface::object_free_instance_binding(wrapper->_owner, gdextension_interface::token);
	}
}

} // namespace internal

void memdelete(Wrapped *p_object) {
	gdextension_interface::object_destroy(p_object->_owner);
}

Wrapped::Wrapped(const StringName &p_engine_class) :
		_owner(gdextension_interface::classdb_construct_object2(p_engine_class._native_ptr())) {
	const StringName *extension_class = internal::Construction::take();
	if (extension_class) {
		gdextension_interface::object_set_instance(_owner, extension_class->_native_ptr(), this);
	}
	gdextension_interface::object_set_instance_binding(_owner, gdextension_interface::token, this, extension_class ? &internal::EXTENSION_OBJECT_CALLBACKS : &internal::ENGINE_OBJECT_CALLBACKS);
}

} // namespace godot
