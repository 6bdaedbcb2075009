#pragma once

#include <godot_cpp/variant/opaque.hpp>
#include <godot_cpp/variant/variant_type.hpp>

#include <type_traits>

namespace godot {

class Object;
class String;

namespace internal {

// The engine's type of values of type T.
template <typename T>
inline constexpr GDExtensionVariantType TYPE_OF = GDEXTENSION_VARIANT_TYPE_VARIANT_MAX;

// Members of Variant that do not depend on other built-in types. The generated class adds constructors and conversions.
class VariantBase : public VariantType {
	alignas(8) uint8_t _opaque[24];

public:
	VariantBase() { gdextension_interface::variant_new_nil(_opaque); }
	VariantBase(const VariantBase &p_other) { gdextension_interface::variant_new_copy(_opaque, p_other._opaque); }
	VariantBase(VariantBase &&p_other) :
			VariantBase() {
		std::swap(_opaque, p_other._opaque);
	}
	explicit VariantBase(Uninitialized) {}
	~VariantBase() { gdextension_interface::variant_destroy(_opaque); }

	VariantBase &operator=(const VariantBase &p_other) {
		if (this != &p_other) {
			gdextension_interface::variant_destroy(_opaque);
			gdextension_interface::variant_new_copy(_opaque, p_other._opaque);
		}
		return *this;
	}
	VariantBase &operator=(VariantBase &&p_other) {
		std::swap(_opaque, p_other._opaque);
		return *this;
	}

	VariantBase(bool p_value);
	VariantBase(int64_t p_value);
	VariantBase(double p_value);
	VariantBase(const Object *p_value);

	operator bool() const;
	operator int64_t() const;
	operator double() const;

	// Null if this is not an object or the object has been freed.
	Object *get_validated_object() const;

	Type get_type() const { return static_cast<Type>(gdextension_interface::variant_get_type(_opaque)); }
	static String get_type_name(Type p_type);
	static bool can_convert_strict(Type p_from, Type p_to);

	GDExtensionVariantPtr _native_ptr() const { return const_cast<uint8_t *>(_opaque); }

protected:
	void construct(Type p_type, const void *p_value) { builtin_functions[p_type].to_variant(_opaque, const_cast<void *>(p_value)); }

	template <typename T>
	T convert(Type p_type) const {
		if constexpr (std::is_constructible_v<T, Uninitialized>) {
			T result{ Uninitialized() };
			builtin_functions[p_type].from_variant(&result, _native_ptr());
			return result;
		} else {
			T result;
			builtin_functions[p_type].from_variant(&result, _native_ptr());
			return result;
		}
	}
};

} // namespace internal

} // namespace godot
