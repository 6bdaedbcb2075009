#pragma once

#include <godot_cpp/variant/aabb.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/basis.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/color.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_color_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_float64_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/quaternion.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/vector2.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <cstddef>

namespace godot {

class Object;

// A value of any type. Conversions to another type than get_type() give the result of the engine's own conversion, for
// example 0 for a number.
class Variant {
	alignas(8) uint8_t _opaque[24];

public:
	enum Type {
		NIL,
		BOOL,
		INT,
		FLOAT,
		STRING,
		VECTOR2,
		VECTOR2I,
		RECT2,
		RECT2I,
		VECTOR3,
		VECTOR3I,
		TRANSFORM2D,
		VECTOR4,
		VECTOR4I,
		PLANE,
		QUATERNION,
		AABB,
		BASIS,
		TRANSFORM3D,
		PROJECTION,
		COLOR,
		STRING_NAME,
		NODE_PATH,
		RID,
		OBJECT,
		CALLABLE,
		SIGNAL,
		DICTIONARY,
		ARRAY,
		PACKED_BYTE_ARRAY,
		PACKED_INT32_ARRAY,
		PACKED_INT64_ARRAY,
		PACKED_FLOAT32_ARRAY,
		PACKED_FLOAT64_ARRAY,
		PACKED_STRING_ARRAY,
		PACKED_VECTOR2_ARRAY,
		PACKED_VECTOR3_ARRAY,
		PACKED_COLOR_ARRAY,
		PACKED_VECTOR4_ARRAY,
		VARIANT_MAX
	};

	Variant() { gdextension_interface::variant_new_nil(_opaque); }
	Variant(std::nullptr_t) :
			Variant() {}
	Variant(const Variant &p_other) { gdextension_interface::variant_new_copy(_opaque, p_other._opaque); }
	Variant(Variant &&p_other) :
			Variant() {
		std::swap(_opaque, p_other._opaque);
	}
	explicit Variant(internal::Uninitialized) {}
	~Variant() { gdextension_interface::variant_destroy(_opaque); }

	Variant &operator=(const Variant &p_other) {
		if (this != &p_other) {
			gdextension_interface::variant_destroy(_opaque);
			gdextension_interface::variant_new_copy(_opaque, p_other._opaque);
		}
		return *this;
	}
	Variant &operator=(Variant &&p_other) {
		std::swap(_opaque, p_other._opaque);
		return *this;
	}

	Variant(bool p_value);
	Variant(int64_t p_value);
	Variant(int32_t p_value) :
			Variant(static_cast<int64_t>(p_value)) {}
	Variant(int16_t p_value) :
			Variant(static_cast<int64_t>(p_value)) {}
	Variant(int8_t p_value) :
			Variant(static_cast<int64_t>(p_value)) {}
	Variant(uint64_t p_value) :
			Variant(static_cast<int64_t>(p_value)) {}
	Variant(uint32_t p_value) :
			Variant(static_cast<int64_t>(p_value)) {}
	Variant(uint16_t p_value) :
			Variant(static_cast<int64_t>(p_value)) {}
	Variant(uint8_t p_value) :
			Variant(static_cast<int64_t>(p_value)) {}
	Variant(double p_value);
	Variant(float p_value) :
			Variant(static_cast<double>(p_value)) {}
	Variant(const char *p_latin1) :
			Variant(String(p_latin1)) {}
	Variant(const String &p_value) { construct(STRING, &p_value); }
	Variant(const Vector2 &p_value) { construct(VECTOR2, &p_value); }
	Variant(const Vector3 &p_value) { construct(VECTOR3, &p_value); }
	Variant(const Quaternion &p_value) { construct(QUATERNION, &p_value); }
	Variant(const ::godot::AABB &p_value) { construct(AABB, &p_value); }
	Variant(const Basis &p_value) { construct(BASIS, &p_value); }
	Variant(const Transform3D &p_value) { construct(TRANSFORM3D, &p_value); }
	Variant(const Color &p_value) { construct(COLOR, &p_value); }
	Variant(const StringName &p_value) { construct(STRING_NAME, &p_value); }
	Variant(const NodePath &p_value) { construct(NODE_PATH, &p_value); }
	Variant(const ::godot::RID &p_value) { construct(RID, &p_value); }
	Variant(const Object *p_value);
	Variant(const Callable &p_value) { construct(CALLABLE, &p_value); }
	Variant(const Dictionary &p_value) { construct(DICTIONARY, &p_value); }
	Variant(const Array &p_value) { construct(ARRAY, &p_value); }
	Variant(const PackedByteArray &p_value) { construct(PACKED_BYTE_ARRAY, &p_value); }
	Variant(const PackedInt32Array &p_value) { construct(PACKED_INT32_ARRAY, &p_value); }
	Variant(const PackedFloat32Array &p_value) { construct(PACKED_FLOAT32_ARRAY, &p_value); }
	Variant(const PackedFloat64Array &p_value) { construct(PACKED_FLOAT64_ARRAY, &p_value); }
	Variant(const PackedStringArray &p_value) { construct(PACKED_STRING_ARRAY, &p_value); }
	Variant(const PackedVector2Array &p_value) { construct(PACKED_VECTOR2_ARRAY, &p_value); }
	Variant(const PackedVector3Array &p_value) { construct(PACKED_VECTOR3_ARRAY, &p_value); }
	Variant(const PackedColorArray &p_value) { construct(PACKED_COLOR_ARRAY, &p_value); }

	operator bool() const;
	operator int64_t() const;
	operator int32_t() const { return static_cast<int32_t>(operator int64_t()); }
	operator int16_t() const { return static_cast<int16_t>(operator int64_t()); }
	operator int8_t() const { return static_cast<int8_t>(operator int64_t()); }
	operator uint64_t() const { return static_cast<uint64_t>(operator int64_t()); }
	operator uint32_t() const { return static_cast<uint32_t>(operator int64_t()); }
	operator uint16_t() const { return static_cast<uint16_t>(operator int64_t()); }
	operator uint8_t() const { return static_cast<uint8_t>(operator int64_t()); }
	operator double() const;
	operator float() const { return static_cast<float>(operator double()); }
	operator String() const { return convert<String>(STRING); }
	operator Vector2() const { return convert<Vector2>(VECTOR2); }
	operator Vector3() const { return convert<Vector3>(VECTOR3); }
	operator Quaternion() const { return convert<Quaternion>(QUATERNION); }
	operator ::godot::AABB() const { return convert<::godot::AABB>(AABB); }
	operator Basis() const { return convert<Basis>(BASIS); }
	operator Transform3D() const { return convert<Transform3D>(TRANSFORM3D); }
	operator Color() const { return convert<Color>(COLOR); }
	operator StringName() const { return convert<StringName>(STRING_NAME); }
	operator NodePath() const { return convert<NodePath>(NODE_PATH); }
	operator ::godot::RID() const { return convert<::godot::RID>(RID); }
	operator Callable() const { return convert<Callable>(CALLABLE); }
	operator Dictionary() const { return convert<Dictionary>(DICTIONARY); }
	operator Array() const { return convert<Array>(ARRAY); }
	operator PackedByteArray() const { return convert<PackedByteArray>(PACKED_BYTE_ARRAY); }
	operator PackedInt32Array() const { return convert<PackedInt32Array>(PACKED_INT32_ARRAY); }
	operator PackedFloat32Array() const { return convert<PackedFloat32Array>(PACKED_FLOAT32_ARRAY); }
	operator PackedFloat64Array() const { return convert<PackedFloat64Array>(PACKED_FLOAT64_ARRAY); }
	operator PackedStringArray() const { return convert<PackedStringArray>(PACKED_STRING_ARRAY); }
	operator PackedVector2Array() const { return convert<PackedVector2Array>(PACKED_VECTOR2_ARRAY); }
	operator PackedVector3Array() const { return convert<PackedVector3Array>(PACKED_VECTOR3_ARRAY); }
	operator PackedColorArray() const { return convert<PackedColorArray>(PACKED_COLOR_ARRAY); }

	// Null if this is not an object or the object has been freed.
	operator Object *() const { return get_validated_object(); }
	Object *get_validated_object() const;

	Type get_type() const { return static_cast<Type>(gdextension_interface::variant_get_type(_opaque)); }
	static String get_type_name(Type p_type);
	static bool can_convert_strict(Type p_from, Type p_to);

	bool operator==(const Variant &p_other) const;
	bool operator!=(const Variant &p_other) const { return !(*this == p_other); }

	GDExtensionVariantPtr _native_ptr() const { return const_cast<uint8_t *>(_opaque); }

private:
	void construct(Type p_type, const void *p_value) { internal::builtin_functions[p_type].to_variant(_opaque, const_cast<void *>(p_value)); }

	template <typename T>
	T convert(Type p_type) const {
		if constexpr (std::is_constructible_v<T, internal::Uninitialized>) {
			T result{ internal::Uninitialized() };
			internal::builtin_functions[p_type].from_variant(&result, _native_ptr());
			return result;
		} else {
			T result;
			internal::builtin_functions[p_type].from_variant(&result, _native_ptr());
			return result;
		}
	}
};

// p_text with each placeholder (%s, %d, ...) replaced by the next argument, as by the % operator of GDScript.
template <typename... Args>
String vformat(const String &p_text, const Args &...p_args) {
	return p_text % Array{ Variant(p_args)... };
}

} // namespace godot
