#pragma once

#include "sample_note.hpp"

#include <godot_cpp/classes/multi_mesh.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace bindings_sample {

/// Methods that take and return values of every type, with default arguments, and static methods.
class SampleValues : public godot::RefCounted {
	GDCLASS(SampleValues, godot::RefCounted)

public:
	enum Hue {
		RED = 1,
		GREEN = 2,
		BLUE = 40,
	};

	SampleValues() { _alive++; }
	~SampleValues() { _alive--; }
	/// The number of objects of this class.
	static int64_t count_alive() { return _alive; }
	/// Creates and destroys objects without passing a reference to the engine.
	static void make_and_drop(int64_t count);

	bool negate(bool value) const { return !value; }
	int64_t add_up(int8_t a, uint16_t b, int32_t c, int64_t d) const { return a + b + c + d; }
	double halve(float value) const { return value / 2; }
	godot::String repeat(const godot::String &text, int times, const godot::String &separator) const;
	int64_t count_bytes(const godot::String &text) const;
	godot::StringName prefixed(const godot::StringName &name) const { return godot::StringName(godot::String("pre_") + godot::String(name)); }
	godot::NodePath child_path(const godot::NodePath &path) const { return godot::NodePath(godot::String(path) + godot::String("/child")); }
	godot::Vector2 sum(const godot::Vector2 &a, const godot::Vector2 &b) const { return a + b; }
	/// 2 (a - b) + b (a . b), with its x and y swapped.
	godot::Vector3 combine(const godot::Vector3 &a, const godot::Vector3 &b) const;
	godot::Quaternion conjugate(const godot::Quaternion &rotation) const { return godot::Quaternion(-rotation.x, -rotation.y, -rotation.z, rotation.w); }
	/// The last column, the image of a vector, the product with itself, and a basis with the columns in reverse order.
	godot::Array inspect(const godot::Basis &basis, const godot::Vector3 &vector) const;
	godot::AABB moved_box(const godot::AABB &box, const godot::Vector3 &offset) const { return godot::AABB(box.position + offset, box.size); }
	godot::Color without_red(const godot::Color &color) const { return godot::Color(0, color.g, color.b, color.a); }
	/// Creates and frees an RID of the rendering server. Returns whether it was valid.
	bool make_rid() const;
	/// The product, and the image of a's origin under b.
	godot::Array chain(const godot::Transform3D &a, const godot::Transform3D &b) const { return godot::Array{ a * b, b.xform(a.origin) }; }
	/// Whether the values of each pair are equal; false if == and != disagree.
	bool equal(const godot::Vector2 &a, const godot::Vector2 &b, const godot::Color &c, const godot::Color &d, const godot::Transform3D &e, const godot::Transform3D &f) const;
	Hue mix(Hue a, Hue b) const { return a == b ? a : BLUE; }
	godot::Variant echo(const godot::Variant &value) const { return value; }
	godot::String type_of(const godot::Variant &value) const { return godot::Variant::get_type_name(value.get_type()); }

	/// The sum, the reversed elements and the first element of an array.
	godot::Dictionary summarize(const godot::Array &numbers) const;
	godot::Array keys_and_values(const godot::Dictionary &entries) const;
	godot::PackedByteArray bytes(const godot::PackedByteArray &bytes) const;
	godot::PackedInt32Array ints(const godot::PackedInt32Array &ints) const;
	godot::PackedVector3Array vectors(const godot::PackedVector3Array &vectors) const;
	godot::PackedFloat32Array floats(const godot::PackedFloat32Array &floats) const;
	godot::PackedFloat64Array doubles(const godot::PackedFloat64Array &doubles) const;
	godot::PackedStringArray strings(const godot::PackedStringArray &strings) const;
	godot::TypedArray<godot::Transform3D> move_all(const godot::TypedArray<godot::Transform3D> &transforms, const godot::Vector3 &offset) const;
	godot::TypedArray<godot::Node3D> only_visible(const godot::TypedArray<godot::Node3D> &nodes) const;
	/// The squares of 0 to count - 1, each computed by a task of a group.
	godot::PackedInt32Array squares(int count) const;
	/// Converts values to the same variables repeatedly, which must not leak.
	int64_t convert_often(const godot::Array &values, int64_t times) const;

	godot::String describe_object(godot::Object *object) const { return object ? object->get_class() : godot::String("null"); }
	godot::String describe_node(godot::Node3D *node) const { return node ? godot::String(node->get_name()) : godot::String("null"); }
	godot::String describe_note(const godot::Ref<SampleNote> &note) const;
	void keep(const godot::Variant &object) { _kept = object; }
	godot::String describe_kept() const;
	bool is_alive(int64_t id) const;
	godot::Ref<SampleNote> new_note(const godot::String &text) const;
	godot::Variant note_as_variant() const;
	void fill_multimesh(const godot::Ref<godot::MultiMesh> &multimesh, const godot::PackedFloat32Array &buffer) const;

	static godot::String join(const godot::String &a, const godot::String &b, int64_t number) { return a + b + godot::String::num_int64(number); }
	static bool is_editor();
	/// Prints the text as an error and as a warning.
	static void say(const godot::String &text);
	static void fail_with(const godot::String &message);

protected:
	static void _bind_methods();

private:
	static int64_t _alive;
	godot::Variant _kept;
};

} // namespace bindings_sample

VARIANT_ENUM_CAST(bindings_sample::SampleValues::Hue);
