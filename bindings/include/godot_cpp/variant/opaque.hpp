#pragma once

#include <godot_cpp/core/gdextension_interface_loader.hpp>

#include <cstring>
#include <utility>

namespace godot::internal {

// Selects a constructor that leaves the memory uninitialized, for values that the engine constructs in place: these would
// leak a default-constructed value.
struct Uninitialized {};

// A value whose destructor never runs. For static StringNames, which must not be destroyed.
template <typename T>
union NeverDestroyed {
	T value;

	template <typename... Args>
	explicit NeverDestroyed(Args... p_args) :
			value(p_args...) {}
	~NeverDestroyed() {}
};

// The engine's functions for each built-in type; set when the library is loaded.
struct BuiltinFunctions {
	GDExtensionPtrConstructor construct;
	GDExtensionPtrConstructor copy;
	GDExtensionPtrDestructor destroy;
	GDExtensionVariantFromTypeConstructorFunc to_variant;
	GDExtensionTypeFromVariantConstructorFunc from_variant;
};

extern BuiltinFunctions builtin_functions[GDEXTENSION_VARIANT_TYPE_VARIANT_MAX];

// A built-in type that is a handle of SIZE bytes to engine memory; the engine copies and destroys it.
template <GDExtensionVariantType TYPE, size_t SIZE>
class Opaque {
	alignas(8) uint8_t _opaque[SIZE];

public:
	Opaque() { builtin_functions[TYPE].construct(_opaque, nullptr); }

	explicit Opaque(Uninitialized) {}

	Opaque(const Opaque &p_other) { copy_from(p_other); }

	Opaque(Opaque &&p_other) :
			Opaque() {
		swap(p_other);
	}

	~Opaque() { builtin_functions[TYPE].destroy(_opaque); }

	Opaque &operator=(const Opaque &p_other) {
		if (this != &p_other) {
			builtin_functions[TYPE].destroy(_opaque);
			copy_from(p_other);
		}
		return *this;
	}

	Opaque &operator=(Opaque &&p_other) {
		swap(p_other);
		return *this;
	}

	// Const as in godot-cpp: the engine's functions take a non-const pointer even if they only read.
	GDExtensionTypePtr _native_ptr() const { return const_cast<uint8_t *>(_opaque); }

protected:
	bool is_same_handle(const Opaque &p_other) const { return memcmp(_opaque, p_other._opaque, SIZE) == 0; }

private:
	void copy_from(const Opaque &p_other) {
		const GDExtensionConstTypePtr arguments[] = { p_other._opaque };
		builtin_functions[TYPE].copy(_opaque, arguments);
	}

	void swap(Opaque &p_other) { std::swap(_opaque, p_other._opaque); }
};

} // namespace godot::internal
