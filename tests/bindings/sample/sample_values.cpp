#include "sample_values.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/worker_thread_pool.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/core/print_string.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

namespace bindings_sample {

using namespace godot;

int64_t SampleValues::_alive = 0;

int64_t SampleValues::count_alive() {
	return _alive;
}

void SampleValues::make_and_drop(int64_t p_count) {
	for (int64_t i = 0; i < p_count; i++) {
		Ref<SampleValues> dropped;
		dropped.instantiate();
		const Ref<SampleValues> also = memnew(SampleValues);
		dropped = also;
	}
}

bool SampleValues::negate(bool p_value) const {
	return !p_value;
}

int64_t SampleValues::add_up(int8_t p_a, uint16_t p_b, int32_t p_c, int64_t p_d) const {
	return p_a + p_b + p_c + p_d;
}

double SampleValues::halve(float p_value) const {
	return p_value / 2;
}

String SampleValues::repeat(const String &p_text, int p_times, const String &p_separator) const {
	String result;
	for (int i = 0; i < p_times; i++) {
		if (!result.is_empty()) {
			result += p_separator;
		}
		result += p_text;
	}
	return result;
}

int64_t SampleValues::count_bytes(const String &p_text) const {
	return p_text == String::utf8(p_text.utf8().get_data()) ? p_text.utf8().length() : -1;
}

StringName SampleValues::prefixed(const StringName &p_name) const {
	return StringName("pre_" + String(p_name));
}

NodePath SampleValues::child_path(const NodePath &p_path) const {
	return NodePath(String(p_path) + String("/child"));
}

Vector3 SampleValues::cross(const Vector3 &p_a, const Vector3 &p_b) const {
	return p_a.cross(p_b);
}

Quaternion SampleValues::turn_twice(const Quaternion &p_rotation) const {
	return p_rotation * p_rotation;
}

Basis SampleValues::to_basis(const Quaternion &p_rotation) const {
	return Basis(p_rotation);
}

Quaternion SampleValues::to_quaternion(const Basis &p_basis) const {
	return p_basis.get_quaternion();
}

Vector2 SampleValues::halfway(const Vector2 &p_a, const Vector2 &p_b) const {
	return (p_a + p_b) * 0.5f;
}

AABB SampleValues::moved_box(const AABB &p_box, const Vector3 &p_offset) const {
	return AABB(p_box.position + p_offset, p_box.size);
}

Color SampleValues::without_red(const Color &p_color) const {
	return Color(0, p_color.g, p_color.b, p_color.a);
}

bool SampleValues::make_rid() const {
	RenderingServer *server = RenderingServer::get_singleton();
	const RID mesh = server->mesh_create();
	const Variant as_variant = mesh;
	const bool valid = mesh.is_valid() && mesh != RID() && RID(as_variant) == mesh;
	server->free_rid(mesh);
	return valid;
}

Array SampleValues::pack(const PackedVector2Array &p_flat, const PackedVector3Array &p_vectors, const PackedColorArray &p_colors) const {
	Array packed;
	for (const Vector2 &vector : p_flat) {
		packed.push_back(vector);
	}
	for (const Vector3 &vector : p_vectors) {
		packed.push_back(vector);
	}
	for (const Color &color : p_colors) {
		packed.push_back(color);
	}
	return packed;
}

Transform3D SampleValues::chain(const Transform3D &p_a, const Transform3D &p_b) const {
	return p_a * p_b;
}

Array SampleValues::measure(const Vector3 &p_a, const Vector3 &p_b, const Basis &p_basis) const {
	return Array{ p_a.dot(p_b), p_a.length(), p_a.distance_to(p_b), p_basis.determinant(), p_a.is_finite() && p_b.is_finite() && p_basis.is_finite(), p_a.is_equal_approx(p_b), p_b.normalized() };
}

SampleValues::Colour SampleValues::mix(Colour p_a, Colour p_b) const {
	return p_a == p_b ? p_a : BLUE;
}

Variant SampleValues::echo(const Variant &p_value) const {
	return p_value;
}

String SampleValues::type_of(const Variant &p_value) const {
	return Variant::get_type_name(p_value.get_type());
}

Dictionary SampleValues::summarise(const Array &p_numbers) const {
	double sum = 0;
	Array reversed;
	for (const Variant &number : p_numbers) {
		sum += double(number);
		reversed.push_front(number);
	}
	Dictionary result;
	result["sum"] = sum;
	result["reversed"] = reversed;
	result["first"] = p_numbers.is_empty() ? Variant() : p_numbers[0];
	return result;
}

Array SampleValues::keys_and_values(const Dictionary &p_entries) const {
	Array result;
	const Array keys = p_entries.keys();
	for (int64_t i = 0; i < keys.size(); i++) {
		result.push_back(keys[i]);
		result.push_back(p_entries[keys[i]]);
	}
	return result;
}

PackedByteArray SampleValues::bytes(const PackedByteArray &p_bytes) const {
	PackedByteArray result = p_bytes;
	uint8_t *data = result.ptrw();
	for (int64_t i = 0; i < result.size(); i++) {
		data[i] ^= 255;
	}
	return result;
}

PackedInt32Array SampleValues::ints(const PackedInt32Array &p_ints) const {
	PackedInt32Array result{ 7, -7 };
	result.append_array(p_ints);
	return result;
}

PackedFloat32Array SampleValues::floats(const PackedFloat32Array &p_floats) const {
	PackedFloat32Array result;
	result.resize(p_floats.size());
	const float *source = p_floats.ptr();
	float *target = result.ptrw();
	for (int64_t i = 0; i < p_floats.size(); i++) {
		target[i] = source[i] * 2;
	}
	return result;
}

PackedFloat64Array SampleValues::doubles(const PackedFloat64Array &p_doubles) const {
	PackedFloat64Array result;
	for (const double &value : p_doubles) {
		result.push_back(value + 1);
	}
	return result;
}

PackedStringArray SampleValues::strings(const PackedStringArray &p_strings) const {
	PackedStringArray result;
	for (const String &text : p_strings) {
		result.push_back(text.to_upper());
	}
	if (result.size() > 1) {
		result[1] += "!";
	}
	return result;
}

TypedArray<Transform3D> SampleValues::move_all(const TypedArray<Transform3D> &p_transforms, const Vector3 &p_offset) const {
	TypedArray<Transform3D> result;
	result.resize(p_transforms.size());
	for (int64_t i = 0; i < p_transforms.size(); i++) {
		Transform3D transform = p_transforms[i];
		transform.origin += p_offset;
		result[i] = transform;
	}
	return result;
}

TypedArray<Node3D> SampleValues::only_visible(const TypedArray<Node3D> &p_nodes) const {
	TypedArray<Node3D> result;
	for (int64_t i = 0; i < p_nodes.size(); i++) {
		Node3D *node = Object::cast_to<Node3D>(p_nodes[i].get_validated_object());
		if (node && node->is_visible()) {
			result.push_back(node);
		}
	}
	return result;
}

PackedInt32Array SampleValues::squares(int p_count) const {
	PackedInt32Array results;
	results.resize(p_count);
	const auto square = [](void *p_results, uint32_t p_index) { static_cast<int32_t *>(p_results)[p_index] = int32_t(p_index * p_index); };
	WorkerThreadPool *pool = WorkerThreadPool::get_singleton();
	pool->wait_for_group_task_completion(pool->add_native_group_task(square, results.ptrw(), p_count));
	return results;
}

int64_t SampleValues::convert_often(const Array &p_values, int64_t p_times) const {
	int64_t size = 0;
	for (int64_t i = 0; i < p_times; i++) {
		const Array array = p_values[0];
		const Dictionary dictionary = p_values[1];
		const String text = p_values[2];
		const PackedFloat32Array floats = p_values[3];
		const TypedArray<Transform3D> typed = p_values[4];
		size += array.size() + dictionary.size() + text.length() + floats.size() + typed.size();
	}
	return size;
}

String SampleValues::describe_object(Object *p_object) const {
	return p_object ? p_object->get_class() : String("null");
}

String SampleValues::describe_node(Node3D *p_node) const {
	return p_node ? String(p_node->get_name()) : String("null");
}

String SampleValues::describe_note(const Ref<SampleNote> &p_note) const {
	return p_note.is_valid() ? vformat("%s %d", p_note->get_text(), p_note->get_reference_count()) : String("null");
}

void SampleValues::keep(const Variant &p_object) {
	_kept = p_object;
}

String SampleValues::describe_kept() const {
	const Object *object = _kept.get_validated_object();
	return object ? object->get_class() : String("gone");
}

bool SampleValues::is_alive(int64_t p_id) const {
	return ObjectDB::get_instance(uint64_t(p_id)) != nullptr;
}

Ref<SampleNote> SampleValues::new_note(const String &p_text) const {
	Ref<SampleNote> note = memnew(SampleNote);
	note->set_text(p_text);
	const Ref<Resource> as_resource = note;
	const Ref<SampleNote> back = as_resource;
	Ref<SampleValues> wrong = as_resource;
	return wrong.is_null() && back == note ? back : Ref<SampleNote>();
}

Variant SampleValues::note_as_variant() const {
	Array notes;
	notes.push_back(new_note("inside"));
	const Ref<SampleNote> note = notes[0];
	return note;
}

void SampleValues::fill_multimesh(const Ref<MultiMesh> &p_multimesh, const PackedFloat32Array &p_buffer) const {
	ERR_FAIL_COND_MSG(p_multimesh.is_null(), "SampleValues.fill_multimesh: the multimesh is null.");
	p_multimesh->set_transform_format(MultiMesh::TRANSFORM_3D);
	p_multimesh->set_instance_count(int32_t(p_buffer.size() / 12));
	p_multimesh->set_buffer(p_buffer);
}

String SampleValues::join(const String &p_a, const String &p_b, int64_t p_number) {
	return p_a + p_b + String::num_int64(p_number);
}

bool SampleValues::is_editor() {
	return Engine::get_singleton()->is_editor_hint();
}

void SampleValues::fail_with(const String &p_message) {
	ERR_FAIL_MSG(p_message);
}

void SampleValues::say(const String &p_text) {
	print_line(p_text, 1, "two");
	UtilityFunctions::push_warning("careful: ", p_text);
	UtilityFunctions::push_error("wrong: ", p_text);
	WARN_PRINT("odd: " + p_text);
}

void SampleValues::_bind_methods() {
	BIND_ENUM_CONSTANT(RED);
	BIND_ENUM_CONSTANT(GREEN);
	BIND_ENUM_CONSTANT(BLUE);
	BIND_CONSTANT(LIMIT);

	ClassDB::bind_static_method("SampleValues", D_METHOD("count_alive"), &SampleValues::count_alive);
	ClassDB::bind_static_method("SampleValues", D_METHOD("make_and_drop", "count"), &SampleValues::make_and_drop);
	ClassDB::bind_method(D_METHOD("negate", "value"), &SampleValues::negate);
	ClassDB::bind_method(D_METHOD("add_up", "a", "b", "c", "d"), &SampleValues::add_up);
	ClassDB::bind_method(D_METHOD("halve", "value"), &SampleValues::halve);
	ClassDB::bind_method(D_METHOD("repeat", "text", "times", "separator"), &SampleValues::repeat, DEFVAL(2), DEFVAL("-"));
	ClassDB::bind_method(D_METHOD("count_bytes", "text"), &SampleValues::count_bytes);
	ClassDB::bind_method(D_METHOD("prefixed", "name"), &SampleValues::prefixed);
	ClassDB::bind_method(D_METHOD("child_path", "path"), &SampleValues::child_path);
	ClassDB::bind_method(D_METHOD("cross", "a", "b"), &SampleValues::cross);
	ClassDB::bind_method(D_METHOD("turn_twice", "rotation"), &SampleValues::turn_twice);
	ClassDB::bind_method(D_METHOD("to_basis", "rotation"), &SampleValues::to_basis);
	ClassDB::bind_method(D_METHOD("to_quaternion", "basis"), &SampleValues::to_quaternion);
	ClassDB::bind_method(D_METHOD("halfway", "a", "b"), &SampleValues::halfway);
	ClassDB::bind_method(D_METHOD("moved_box", "box", "offset"), &SampleValues::moved_box);
	ClassDB::bind_method(D_METHOD("without_red", "color"), &SampleValues::without_red);
	ClassDB::bind_method(D_METHOD("make_rid"), &SampleValues::make_rid);
	ClassDB::bind_method(D_METHOD("pack", "flat", "vectors", "colors"), &SampleValues::pack);
	ClassDB::bind_method(D_METHOD("chain", "a", "b"), &SampleValues::chain);
	ClassDB::bind_method(D_METHOD("measure", "a", "b", "basis"), &SampleValues::measure);
	ClassDB::bind_method(D_METHOD("mix", "a", "b"), &SampleValues::mix);
	ClassDB::bind_method(D_METHOD("echo", "value"), &SampleValues::echo, DEFVAL(Variant()));
	ClassDB::bind_method(D_METHOD("type_of", "value"), &SampleValues::type_of);
	ClassDB::bind_method(D_METHOD("summarise", "numbers"), &SampleValues::summarise, DEFVAL(Array()));
	ClassDB::bind_method(D_METHOD("keys_and_values", "entries"), &SampleValues::keys_and_values);
	ClassDB::bind_method(D_METHOD("bytes", "bytes"), &SampleValues::bytes);
	ClassDB::bind_method(D_METHOD("ints", "ints"), &SampleValues::ints);
	ClassDB::bind_method(D_METHOD("floats", "floats"), &SampleValues::floats);
	ClassDB::bind_method(D_METHOD("doubles", "doubles"), &SampleValues::doubles);
	ClassDB::bind_method(D_METHOD("strings", "strings"), &SampleValues::strings);
	ClassDB::bind_method(D_METHOD("move_all", "transforms", "offset"), &SampleValues::move_all);
	ClassDB::bind_method(D_METHOD("only_visible", "nodes"), &SampleValues::only_visible);
	ClassDB::bind_method(D_METHOD("squares", "count"), &SampleValues::squares);
	ClassDB::bind_method(D_METHOD("convert_often", "values", "times"), &SampleValues::convert_often);
	ClassDB::bind_method(D_METHOD("describe_object", "object"), &SampleValues::describe_object);
	ClassDB::bind_method(D_METHOD("describe_node", "node"), &SampleValues::describe_node);
	ClassDB::bind_method(D_METHOD("describe_note", "note"), &SampleValues::describe_note);
	ClassDB::bind_method(D_METHOD("keep", "object"), &SampleValues::keep);
	ClassDB::bind_method(D_METHOD("describe_kept"), &SampleValues::describe_kept);
	ClassDB::bind_method(D_METHOD("is_alive", "id"), &SampleValues::is_alive);
	ClassDB::bind_method(D_METHOD("new_note", "text"), &SampleValues::new_note);
	ClassDB::bind_method(D_METHOD("note_as_variant"), &SampleValues::note_as_variant);
	ClassDB::bind_method(D_METHOD("fill_multimesh", "multimesh", "buffer"), &SampleValues::fill_multimesh);
	ClassDB::bind_static_method("SampleValues", D_METHOD("join", "a", "b", "number"), &SampleValues::join, DEFVAL("b"), DEFVAL(3));
	ClassDB::bind_static_method("SampleValues", D_METHOD("is_editor"), &SampleValues::is_editor);
	ClassDB::bind_static_method("SampleValues", D_METHOD("say", "text"), &SampleValues::say);
	ClassDB::bind_static_method("SampleValues", D_METHOD("fail_with", "message"), &SampleValues::fail_with);
}

} // namespace bindings_sample
