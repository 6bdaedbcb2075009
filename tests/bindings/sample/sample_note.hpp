#pragma once

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/packed_float64_array.hpp>

namespace bindings_sample {

/// A resource whose setters emit the engine's signal `changed`.
class SampleNote : public godot::Resource {
	GDCLASS(SampleNote, godot::Resource)

public:
	static godot::Ref<SampleNote> make(const godot::String &text, double weight);

	void set_text(const godot::String &text);
	godot::String get_text() const { return _text; }
	void set_values(const godot::PackedFloat64Array &values);
	godot::PackedFloat64Array get_values() const { return _values; }
	double get_weight() const { return _weight; }

	/// A new note with both texts. If the other is null, prints an error and returns null.
	godot::Ref<SampleNote> joined(const godot::Ref<SampleNote> &other) const;
	godot::Ref<SampleNote> itself() { return this; }
	/// The engine's duplicate of this resource, returned with its first reference.
	godot::Ref<SampleNote> copied() const;

	godot::String _to_string() const { return godot::String("note:") + _text; }

protected:
	static void _bind_methods();

private:
	godot::String _text;
	godot::PackedFloat64Array _values;
	double _weight = 1.0;
};

} // namespace bindings_sample
