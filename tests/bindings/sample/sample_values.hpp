#pragma once

#include "sample_note.hpp"

#include <godot_cpp/classes/multi_mesh.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace bindings_sample {

/// Values of every type in both directions, defaults, statics, and what C++ does with them in between.
class SampleValues : public godot::RefCounted {
	GDCLASS(SampleValues, godot::RefCounted)

public:
	enum Colour {
		RED = 1,
		GREEN = 2,
		BLUE = 40,
	};

	static constexpr int64_t LIMIT = 1000;

	SampleValues() { _alive++; }
	~SampleValues() { _alive--; }
	/// How many objects of this class there are.
	static int64_t count_alive();
	/// Makes objects and drops them, without that the engine sees a reference to one.
	static void make_and_drop(int64_t p_count);

	bool negate(bool p_value) const;
	int64_t add_up(int8_t p_a, uint16_t p_b, int32_t p_c, int64_t p_d) const;
	double halve(float p_value) const;
	godot::String repeat(const godot::String &p_text, int p_times, const godot::String &p_separator) const;
	int64_t count_bytes(const godot::String &p_text) const;
	godot::StringName prefixed(const godot::StringName &p_name) const;
	godot::NodePath child_path(const godot::NodePath &p_path) const;
	godot::Vector3 cross(const godot::Vector3 &p_a, const godot::Vector3 &p_b) const;
	godot::Quaternion turn_twice(const godot::Quaternion &p_rotation) const;
	godot::Basis to_basis(const godot::Quaternion &p_rotation) const;
	godot::Quaternion to_quaternion(const godot::Basis &p_basis) const;
	godot::Vector2 halfway(const godot::Vector2 &p_a, const godot::Vector2 &p_b) const;
	godot::AABB moved_box(const godot::AABB &p_box, const godot::Vector3 &p_offset) const;
	godot::Color without_red(const godot::Color &p_color) const;
	/// An id of the rendering server, made and freed here; whether it was valid.
	bool make_rid() const;
	/// Those of the vectors and colours of which there is one each, in one array.
	godot::Array pack(const godot::PackedVector2Array &p_flat, const godot::PackedVector3Array &p_vectors, const godot::PackedColorArray &p_colors) const;
	godot::Transform3D chain(const godot::Transform3D &p_a, const godot::Transform3D &p_b) const;
	/// a.b, |a|, |a - b|, the determinant, whether all is finite and a nearly b, and b with length 1.
	godot::Array measure(const godot::Vector3 &p_a, const godot::Vector3 &p_b, const godot::Basis &p_basis) const;
	Colour mix(Colour p_a, Colour p_b) const;
	godot::Variant echo(const godot::Variant &p_value) const;
	godot::String type_of(const godot::Variant &p_value) const;

	/// The sum, and the elements reversed, of an array that C++ walks over.
	godot::Dictionary summarise(const godot::Array &p_numbers) const;
	godot::Array keys_and_values(const godot::Dictionary &p_entries) const;
	godot::PackedByteArray bytes(const godot::PackedByteArray &p_bytes) const;
	godot::PackedInt32Array ints(const godot::PackedInt32Array &p_ints) const;
	godot::PackedFloat32Array floats(const godot::PackedFloat32Array &p_floats) const;
	godot::PackedFloat64Array doubles(const godot::PackedFloat64Array &p_doubles) const;
	godot::PackedStringArray strings(const godot::PackedStringArray &p_strings) const;
	godot::TypedArray<godot::Transform3D> move_all(const godot::TypedArray<godot::Transform3D> &p_transforms, const godot::Vector3 &p_offset) const;
	godot::TypedArray<godot::Node3D> only_visible(const godot::TypedArray<godot::Node3D> &p_nodes) const;
	/// The squares of 0 to p_count - 1, each computed by a task of a group.
	godot::PackedInt32Array squares(int p_count) const;
	/// Converts into the same variables again and again, which must not leak.
	int64_t convert_often(const godot::Array &p_values, int64_t p_times) const;

	godot::String describe_object(godot::Object *p_object) const;
	godot::String describe_node(godot::Node3D *p_node) const;
	godot::String describe_note(const godot::Ref<SampleNote> &p_note) const;
	void keep(const godot::Variant &p_object);
	godot::String describe_kept() const;
	bool is_alive(int64_t p_id) const;
	godot::Ref<SampleNote> new_note(const godot::String &p_text) const;
	godot::Variant note_as_variant() const;
	void fill_multimesh(const godot::Ref<godot::MultiMesh> &p_multimesh, const godot::PackedFloat32Array &p_buffer) const;

	static godot::String join(const godot::String &p_a, const godot::String &p_b, int64_t p_number);
	static bool is_editor();
	/// Prints the text in all the ways there are.
	static void say(const godot::String &p_text);
	static void fail_with(const godot::String &p_message);

protected:
	static void _bind_methods();

private:
	static int64_t _alive;
	godot::Variant _kept;
};

} // namespace bindings_sample

VARIANT_ENUM_CAST(bindings_sample::SampleValues::Colour);
