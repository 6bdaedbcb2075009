#pragma once

#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/string_name.hpp>

#include <atomic>

namespace godot {

class ClassDB;
class Object;

namespace internal {

struct ClassInfo;
class WrapperFactory;

} // namespace internal

// The C++ side of an engine object. An object of an extension class has one for its whole life. Any other engine object
// gets a wrapper when C++ first accesses it, of its most derived class in the build profile, and both are freed together.
// Wrapped must be the first base of each class, and not a virtual one.
class Wrapped {
	friend class ClassDB;
	friend class internal::WrapperFactory;
	friend void internal::post_initialize(Wrapped *p_object);

public:
	GDExtensionObjectPtr _owner = nullptr;

	// True if this is an object of the class or of a derived one.
	virtual bool _is_a(const StringName &p_class) const = 0;

	template <typename T>
	static T *cast_to(Wrapped *p_object) {
		return p_object && p_object->_is_a(T::get_class_static()) ? static_cast<T *>(p_object) : nullptr;
	}
	template <typename T>
	static const T *cast_to(const Wrapped *p_object) {
		return cast_to<T>(const_cast<Wrapped *>(p_object));
	}

	// The extension class to construct; null for a class of the engine.
	static const StringName *_extension_class_name() { return nullptr; }

protected:
	// Creates the engine object for the C++ object under construction.
	explicit Wrapped(const StringName &p_engine_class);
	explicit Wrapped(GDExtensionObjectPtr p_owner) :
			_owner(p_owner) {}
	virtual ~Wrapped() = default;

	void _notification(int) {}
	String _to_string() const { return String(); }

	static constexpr auto _notification_method() { return &Wrapped::_notification; }
	static constexpr auto _to_string_method() { return &Wrapped::_to_string; }
	static void _notify(GDExtensionClassInstancePtr, int32_t, GDExtensionBool) {}
};

namespace internal {

// The C++ side of an engine object, created on first use; null for null.
Object *get_binding(GDExtensionObjectPtr p_object);

class WrapperFactory {
public:
	template <typename T>
	static Wrapped *create(GDExtensionObjectPtr p_object) { return new (EngineMemory{}) T(p_object); }

	static void destroy(Wrapped *p_wrapped);
};

// An engine class in the build profile; engine_classes is generated.
struct EngineClass {
	const char *name;
	Wrapped *(*create_wrapper)(GDExtensionObjectPtr p_object);
	void *tag;
};

extern EngineClass engine_classes[];
extern const int ENGINE_CLASS_COUNT;

// Looks up the class tags that are still unset.
void find_class_tags();

// The wrapper of an engine singleton, looked up once. It is reset if the engine frees the wrapper. Wrappers that exist
// when the library is unloaded are freed then, because the engine would call into the library later.
class Singleton {
	std::atomic<Object *> _object{ nullptr };
	Singleton *_next = nullptr;

public:
	Object *get(const char *p_name);

	static void forget(const Wrapped *p_wrapper);
	static void free_all();
};

} // namespace internal

} // namespace godot

// Begins the definition of an extension class. m_class must have a protected static void _bind_methods(), and may have
// _notification(int) and _to_string() const. Overridden virtual methods must be public.
#define GDCLASS(m_class, m_inherits) \
private: \
	friend class ::godot::ClassDB; \
	m_class &operator=(const m_class &) = delete; \
\
protected: \
	static constexpr auto _notification_method() { \
		return &m_class::_notification; \
	} \
	static constexpr auto _to_string_method() { \
		return &m_class::_to_string; \
	} \
\
	/* Calls the _notification of each class that has its own, the parent's first, or last if reversed. */ \
	static void _notify(GDExtensionClassInstancePtr p_instance, int32_t p_what, GDExtensionBool p_reversed) { \
		if (!p_reversed) { \
			m_inherits::_notify(p_instance, p_what, p_reversed); \
		} \
		if constexpr (!std::is_same_v<decltype(m_class::_notification_method()), decltype(m_inherits::_notification_method())>) { \
			static_cast<m_class *>(static_cast<::godot::Wrapped *>(p_instance))->_notification(p_what); \
		} \
		if (p_reversed) { \
			m_inherits::_notify(p_instance, p_what, p_reversed); \
		} \
	} \
\
	static void _describe(GDExtensionClassInstancePtr p_instance, GDExtensionBool *r_is_valid, GDExtensionStringPtr r_text) { \
		*static_cast<::godot::String *>(r_text) = static_cast<const m_class *>(static_cast<::godot::Wrapped *>(p_instance))->_to_string(); \
		*r_is_valid = true; \
	} \
\
	GODOT_CPP_CLASS(m_class, m_inherits) \
	static const ::godot::StringName *_extension_class_name() { \
		return &get_class_static(); \
	} \
\
private:

// Begins the definition of a generated class.
#define GDEXTENSION_CLASS(m_class, m_inherits) \
	friend class ::godot::ClassDB; \
	friend class ::godot::internal::WrapperFactory; \
\
protected: \
	explicit m_class(GDExtensionObjectPtr p_owner) : \
			m_inherits(p_owner) {} \
	explicit m_class(const ::godot::StringName &p_engine_class) : \
			m_inherits(p_engine_class) {} \
	static void _bind_methods() {} \
\
	GODOT_CPP_CLASS(m_class, m_inherits) \
	m_class() : \
			m_class(get_class_static()) {} \
\
private:

// Members of both kinds of classes.
#define GODOT_CPP_CLASS(m_class, m_inherits) \
public: \
	using self_type = m_class; \
	using parent_type = m_inherits; \
\
	static const ::godot::StringName &get_class_static() { \
		static const ::godot::internal::NeverDestroyed<::godot::StringName> name(#m_class, true); \
		return name.value; \
	} \
	bool _is_a(const ::godot::StringName &p_class) const override { \
		if constexpr (std::is_same_v<m_inherits, ::godot::Wrapped>) { \
			return p_class == get_class_static(); \
		} else { \
			return p_class == get_class_static() || m_inherits::_is_a(p_class); \
		} \
	}
