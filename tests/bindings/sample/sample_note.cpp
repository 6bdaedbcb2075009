#include "sample_note.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>

namespace bindings_sample {

using godot::PackedFloat64Array;
using godot::Ref;
using godot::String;

Ref<SampleNote> SampleNote::make(const String &text, double weight) {
	Ref<SampleNote> note;
	note.instantiate();
	note->_text = text;
	note->_weight = weight;
	return note;
}

void SampleNote::set_text(const String &text) {
	_text = text;
	emit_changed();
}

void SampleNote::set_values(const PackedFloat64Array &values) {
	ERR_FAIL_COND_MSG(values.size() > 4, godot::vformat("SampleNote: %d values are more than 4.", values.size()));
	_values = values;
	emit_changed();
}

Ref<SampleNote> SampleNote::joined(const Ref<SampleNote> &other) const {
	ERR_FAIL_COND_V_MSG(other.is_null(), Ref<SampleNote>(), "SampleNote.joined: the other note is null.");
	return make(_text + String("+") + other->_text, _weight + other->_weight);
}

Ref<SampleNote> SampleNote::copied() const {
	const Ref<Resource> copy = duplicate();
	return copy;
}

void SampleNote::_bind_methods() {
	using godot::ClassDB;
	using godot::D_METHOD;
	using godot::PropertyInfo;
	using godot::Variant;

	ClassDB::bind_static_method("SampleNote", D_METHOD("make", "text", "weight"), &SampleNote::make, DEFVAL(2.5));
	ClassDB::bind_method(D_METHOD("set_text", "text"), &SampleNote::set_text);
	ClassDB::bind_method(D_METHOD("get_text"), &SampleNote::get_text);
	ClassDB::bind_method(D_METHOD("set_values", "values"), &SampleNote::set_values);
	ClassDB::bind_method(D_METHOD("get_values"), &SampleNote::get_values);
	ClassDB::bind_method(D_METHOD("get_weight"), &SampleNote::get_weight);
	ClassDB::bind_method(D_METHOD("joined", "other"), &SampleNote::joined);
	ClassDB::bind_method(D_METHOD("itself"), &SampleNote::itself);
	ClassDB::bind_method(D_METHOD("copied"), &SampleNote::copied);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "text"), "set_text", "get_text");
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_FLOAT64_ARRAY, "values"), "set_values", "get_values");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "weight"), "", "get_weight");
}

} // namespace bindings_sample
