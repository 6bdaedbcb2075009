#pragma once

#include <godot_cpp/classes/ref_counted.hpp>

namespace godot {

// A counted reference to a RefCounted object. T need not be complete where a Ref to it is only declared or destroyed.
template <typename T>
class Ref {
	RefCounted *_object = nullptr;

	template <typename Other>
	friend class Ref;
	friend struct internal::Arg<Ref<T>>;

	enum Count {
		ALREADY_COUNTED,
		FIRST_MAYBE,
		ONE_MORE,
	};

	// A new object has an initial count that no reference owns; init_ref takes ownership of it.
	Ref(T *p_object, Count p_count) :
			_object(p_object) {
		if (_object && p_count != ALREADY_COUNTED && !(p_count == FIRST_MAYBE ? _object->init_ref() : _object->reference())) {
			_object = nullptr;
		}
	}

public:
	Ref() = default;
	Ref(const Ref &p_other) :
			_object(p_other._object) {
		if (_object) {
			_object->reference();
		}
	}
	Ref(Ref &&p_other) { std::swap(_object, p_other._object); }
	template <typename Other>
	Ref(const Ref<Other> &p_other) :
			Ref(Object::cast_to<T>(p_other._object), ONE_MORE) {}
	Ref(T *p_object) :
			Ref(p_object, FIRST_MAYBE) {}
	Ref(const Variant &p_variant) :
			Ref(Object::cast_to<T>(p_variant.get_validated_object()), ONE_MORE) {}
	~Ref() { unref(); }

	Ref &operator=(Ref p_other) {
		std::swap(_object, p_other._object);
		return *this;
	}

	// Replaces the referenced object with a new one.
	template <typename... Args>
	void instantiate(const Args &...p_args) { *this = Ref(memnew(T(p_args...))); }

	void unref() {
		RefCounted *released = std::exchange(_object, nullptr);
		if (released && released->unreference()) {
			memdelete(released);
		}
	}

	T *ptr() const { return static_cast<T *>(_object); }
	T *operator->() const { return ptr(); }

	bool is_valid() const { return _object != nullptr; }
	bool is_null() const { return _object == nullptr; }

	bool operator==(const Ref &p_other) const { return _object == p_other._object; }

	operator Variant() const { return Variant(_object); }
};

namespace internal {

template <typename T>
struct Arg<Ref<T>> : ObjectArg<T> {
	using Result = GDExtensionObjectPtr;

	static GDExtensionObjectPtr encode(const Ref<T> &p_value) { return p_value.is_valid() ? p_value.ptr()->_owner : nullptr; }
	static Ref<T> decode(const void *p_argument) {
		const GDExtensionObjectPtr object = p_argument ? gdextension_interface::ref_get_object(p_argument) : nullptr;
		return Ref<T>(Object::cast_to<T>(get_binding(object)), Ref<T>::ONE_MORE);
	}
	static void store(void *r_result, const Ref<T> &p_value) { gdextension_interface::ref_set_object(r_result, encode(p_value)); }
	// The engine has already incremented the count for the reference that it returns.
	static Ref<T> from_result(Result p_result) { return Ref<T>(Object::cast_to<T>(get_binding(p_result)), Ref<T>::ALREADY_COUNTED); }
	static Ref<T> from_variant(const Variant &p_variant) { return Ref<T>(p_variant); }
};

} // namespace internal

} // namespace godot
