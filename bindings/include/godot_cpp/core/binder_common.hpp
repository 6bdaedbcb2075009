#pragma once

#include <godot_cpp/classes/wrapped.hpp>
#include <godot_cpp/core/property_info.hpp>
#include <godot_cpp/core/type_info.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace godot::internal {

// How values of a type are passed to and from the engine: Arg<T> below, with
//   TYPE, METADATA    the engine's type and metadata
//   ACCEPTS           a check of a Variant in addition to its type, or null
//   encode(value)     the representation that the engine expects as an argument
//   decode(pointer)   the value of an argument from the engine
//   store(pointer, v) writes a result to a constructed value of the engine
//   Result            the type of a result that the engine writes; from_result(Result) returns its value
//   from_variant(v)   the value in a Variant that passed the checks
//   info()            its description for the editor and scripts
template <GDExtensionVariantType T_TYPE, GDExtensionClassMethodArgumentMetadata T_METADATA = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE>
struct ArgBase {
	static constexpr GDExtensionVariantType TYPE = T_TYPE;
	static constexpr GDExtensionClassMethodArgumentMetadata METADATA = T_METADATA;
	static constexpr bool (*ACCEPTS)(const Variant &) = nullptr;

	static PropertyInfo info() { return PropertyInfo(static_cast<Variant::Type>(TYPE), StringName()); }
};

// Types with the same memory layout in the engine.
template <typename T, GDExtensionVariantType TYPE>
struct ValueArg : ArgBase<TYPE> {
	using Result = T;

	static const T &encode(const T &p_value) { return p_value; }
	static T decode(const void *p_argument) { return *static_cast<const T *>(p_argument); }
	static void store(void *r_result, const T &p_value) { *static_cast<T *>(r_result) = p_value; }
	static T from_result(Result &p_result) { return std::move(p_result); }
	static T from_variant(const Variant &p_variant) { return p_variant; }
};

// Types that the engine passes in a wider type: integers as 64 bits, floats as doubles.
template <typename T, typename WIDE, GDExtensionVariantType TYPE, GDExtensionClassMethodArgumentMetadata METADATA = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE>
struct WideArg : ArgBase<TYPE, METADATA> {
	using Result = WIDE;

	static WIDE encode(T p_value) { return static_cast<WIDE>(p_value); }
	static T decode(const void *p_argument) { return static_cast<T>(*static_cast<const WIDE *>(p_argument)); }
	static void store(void *r_result, T p_value) { *static_cast<WIDE *>(r_result) = encode(p_value); }
	static T from_result(Result p_result) { return static_cast<T>(p_result); }
	static T from_variant(const Variant &p_variant) { return static_cast<T>(static_cast<WIDE>(p_variant)); }
};

// Built-in types. Others have a specialization.
template <typename T>
struct Arg : ValueArg<T, TYPE_OF<T>> {
	static_assert(TYPE_OF<T> != GDEXTENSION_VARIANT_TYPE_VARIANT_MAX, "The bindings cannot pass this type to the engine.");
};

template <>
struct Arg<bool> : WideArg<bool, GDExtensionBool, GDEXTENSION_VARIANT_TYPE_BOOL> {
	static bool from_variant(const Variant &p_variant) { return p_variant; }
};

#define GODOT_CPP_INTEGER_ARG(m_type, m_metadata) \
	template <> \
	struct Arg<m_type> : WideArg<m_type, int64_t, GDEXTENSION_VARIANT_TYPE_INT, GDEXTENSION_METHOD_ARGUMENT_METADATA_INT_IS_##m_metadata> {}

GODOT_CPP_INTEGER_ARG(int8_t, INT8);
GODOT_CPP_INTEGER_ARG(int16_t, INT16);
GODOT_CPP_INTEGER_ARG(int32_t, INT32);
GODOT_CPP_INTEGER_ARG(int64_t, INT64);
GODOT_CPP_INTEGER_ARG(uint8_t, UINT8);
GODOT_CPP_INTEGER_ARG(uint16_t, UINT16);
GODOT_CPP_INTEGER_ARG(uint32_t, UINT32);
GODOT_CPP_INTEGER_ARG(uint64_t, UINT64);

template <>
struct Arg<float> : WideArg<float, double, GDEXTENSION_VARIANT_TYPE_FLOAT, GDEXTENSION_METHOD_ARGUMENT_METADATA_REAL_IS_FLOAT> {};
template <>
struct Arg<double> : WideArg<double, double, GDEXTENSION_VARIANT_TYPE_FLOAT, GDEXTENSION_METHOD_ARGUMENT_METADATA_REAL_IS_DOUBLE> {};

template <>
struct Arg<Variant> : ValueArg<Variant, GDEXTENSION_VARIANT_TYPE_NIL> {
	static PropertyInfo info() { return PropertyInfo(Variant::NIL, StringName(), PROPERTY_HINT_NONE, String(), PROPERTY_USAGE_DEFAULT | PROPERTY_USAGE_NIL_IS_VARIANT); }
};

// The engine's name of an array's element type: the class name for objects, otherwise the name of the built-in type.
template <typename T>
String element_type_name() {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		return T::get_class_static();
	} else {
		return Variant::get_type_name(static_cast<Variant::Type>(Arg<T>::TYPE));
	}
}

// In typed calls the engine does not check the element type of arrays, so the conversion here does.
template <typename T>
struct Arg<TypedArray<T>> : ArgBase<GDEXTENSION_VARIANT_TYPE_ARRAY> {
	using Result = TypedArray<T>;

	static const Array &encode(const TypedArray<T> &p_value) { return p_value; }
	static TypedArray<T> decode(const void *p_argument) { return TypedArray<T>(*static_cast<const Array *>(p_argument)); }
	static void store(void *r_result, const TypedArray<T> &p_value) { *static_cast<Array *>(r_result) = p_value; }
	static TypedArray<T> from_result(Result &p_result) { return std::move(p_result); }
	static TypedArray<T> from_variant(const Variant &p_variant) { return TypedArray<T>(p_variant); }
	static PropertyInfo info() { return PropertyInfo(Variant::ARRAY, StringName(), PROPERTY_HINT_ARRAY_TYPE, element_type_name<T>()); }
};

template <typename T>
struct Arg<BitField<T>> : WideArg<BitField<T>, int64_t, GDEXTENSION_VARIANT_TYPE_INT> {};

template <typename T>
struct EnumArg : WideArg<T, int64_t, GDEXTENSION_VARIANT_TYPE_INT> {};

// The engine's name of an enum, "Class.Enum" or "Enum", for its C++ name with or without namespaces.
String enum_class_name(const char *p_qualified);

template <typename T>
T from_variant(const Variant &p_variant) {
	return Arg<T>::from_variant(p_variant);
}

} // namespace godot::internal

namespace godot {

template <typename T>
void TypedArray<T>::set_type() {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		set_typed(Variant::OBJECT, T::get_class_static(), Variant());
	} else {
		set_typed(internal::Arg<T>::TYPE, StringName(), Variant());
	}
}

} // namespace godot

// Allows an enum in bound methods. Place it after the enum's class, outside all namespaces, with the full name.
#define VARIANT_ENUM_CAST(m_enum) \
	namespace godot::internal { \
	template <> \
	struct Arg<m_enum> : EnumArg<m_enum> { \
		static constexpr const char *NAME = #m_enum; \
		static PropertyInfo info() { \
			return PropertyInfo(Variant::INT, StringName(), PROPERTY_HINT_NONE, String(), PROPERTY_USAGE_DEFAULT | PROPERTY_USAGE_CLASS_IS_ENUM, enum_class_name(NAME)); \
		} \
	}; \
	} \
	static_assert(true)
