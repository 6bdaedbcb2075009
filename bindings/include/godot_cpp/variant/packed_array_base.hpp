#pragma once

#include <godot_cpp/variant/opaque.hpp>

namespace godot::internal {

// Members of packed arrays that are not methods of the engine. SELF is the packed array's class; INDEX and INDEX_CONST
// are the engine's functions that return the address of an element; INDEX first makes a copy if the data is shared.
//
// ptr() and ptrw() are null for an empty array. Call them once before a loop: each is a call into the engine.
template <typename SELF, typename ELEMENT, GDExtensionVariantType TYPE, auto &INDEX, auto &INDEX_CONST>
class PackedArrayBase : public Opaque<TYPE, 16> {
	int64_t count() const { return static_cast<const SELF *>(this)->size(); }

public:
	using Opaque<TYPE, 16>::Opaque;
	PackedArrayBase() = default;

	const ELEMENT *ptr() const { return count() == 0 ? nullptr : &(*this)[0]; }
	ELEMENT *ptrw() { return count() == 0 ? nullptr : &(*this)[0]; }

	const ELEMENT &operator[](int64_t p_index) const { return *static_cast<const ELEMENT *>(INDEX_CONST(this->_native_ptr(), p_index)); }
	ELEMENT &operator[](int64_t p_index) { return *static_cast<ELEMENT *>(INDEX(this->_native_ptr(), p_index)); }
};

} // namespace godot::internal
