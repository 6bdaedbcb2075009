#include "sample_values.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/worker_thread_pool.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/object.hpp>

namespace bindings_sample {

using namespace godot;

int64_t SampleValues::_alive = 0;

void SampleValues::make_and_drop(int64_t count) {
	for (int64_t i = 0; i < count; i++) {
		Ref<SampleValues> dropped;
		dropped.instantiate();
		const Ref<SampleValues> also = memnew(SampleValues);
		dropped = also;
	}
}

String SampleValues::repeat(const String &text, int times, const String &separator) const {
	String result;
	for (int i = 0; i < times; i++) {
		if (!result.is_empty()) {
			result += separator;
		}
		result += text;
	}
	return result;
}

int64_t SampleValues::count_bytes(const String &text) const {
	return text == String::utf8(text.utf8().get_data()) ? text.utf8().length() : -1;
}

Vector3 SampleValues::combine(const Vector3 &a, const Vector3 &b) const {
	const Vector3 combined = (a - b) * 2 + b * a.dot(b);
	Vector3 swapped = combined;
	swapped[0] = combined[1];
	swapped[1] = combined[0];
	return swapped;
}

Array SampleValues::inspect(const Basis &basis, const Vector3 &vector) const {
	return Array{ basis.get_column(2), basis.xform(vector), basis * basis, Basis(basis.get_column(2), basis.get_column(1), basis.get_column(0)) };
}

bool SampleValues::make_rid() const {
	RenderingServer *server = RenderingServer::get_singleton();
	const RID mesh = server->mesh_create();
	const Variant as_variant = mesh;
	const bool valid = mesh.is_valid() && !RID().is_valid() && RID(as_variant).get_id() == mesh.get_id();
	server->free_rid(mesh);
	return valid;
}

bool SampleValues::equal(const Vector2 &a, const Vector2 &b, const Color &c, const Color &d, const Transform3D &e, const Transform3D &f) const {
	const bool all_equal = a == b && c == d && e == f;
	return all_equal == !(a != b || c != d || e != f) && all_equal;
}

Dictionary SampleValues::summarize(const Array &numbers) const {
	double sum = 0;
	Array reversed;
	for (const Variant &number : numbers) {
		sum += double(number);
		reversed.push_front(number);
	}
	Dictionary result;
	result["sum"] = sum;
	result["reversed"] = reversed;
	result["first"] = numbers.is_empty() ? Variant() : numbers[0];
	return result;
}

Array SampleValues::keys_and_values(const Dictionary &entries) const {
	Array result;
	const Array keys = entries.keys();
	for (int64_t i = 0; i < keys.size(); i++) {
		result.push_back(keys[i]);
		result.push_back(entries[keys[i]]);
	}
	return result;
}

PackedByteArray SampleValues::bytes(const PackedByteArray &bytes) const {
	PackedByteArray result = bytes;
	uint8_t *data = result.ptrw();
	for (int64_t i = 0; i < result.size(); i++) {
		data[i] ^= 255;
	}
	return result;
}

PackedInt32Array SampleValues::ints(const PackedInt32Array &ints) const {
	PackedInt32Array result;
	result.push_back(7);
	result.append_array(ints);
	return result;
}

PackedVector3Array SampleValues::vectors(const PackedVector3Array &vectors) const {
	PackedVector3Array result = vectors;
	result.push_back(vectors[0] + vectors[1]);
	return result;
}

PackedFloat32Array SampleValues::floats(const PackedFloat32Array &floats) const {
	PackedFloat32Array result;
	result.resize(floats.size());
	const float *source = floats.ptr();
	float *target = result.ptrw();
	for (int64_t i = 0; i < floats.size(); i++) {
		target[i] = source[i] * 2;
	}
	return result;
}

PackedFloat64Array SampleValues::doubles(const PackedFloat64Array &doubles) const {
	PackedFloat64Array result;
	for (int64_t i = 0; i < doubles.size(); i++) {
		result.push_back(doubles[i] + 1);
	}
	return result;
}

PackedStringArray SampleValues::strings(const PackedStringArray &strings) const {
	PackedStringArray result;
	for (int64_t i = 0; i < strings.size(); i++) {
		result.push_back(strings[i].to_upper());
	}
	if (result.size() > 1) {
		result[1] += "!";
	}
	return result;
}

TypedArray<Transform3D> SampleValues::move_all(const TypedArray<Transform3D> &transforms, const Vector3 &offset) const {
	TypedArray<Transform3D> result;
	result.resize(transforms.size());
	for (int64_t i = 0; i < transforms.size(); i++) {
		Transform3D transform = transforms[i];
		transform.origin = transform.origin + offset;
		result[i] = transform;
	}
	return result;
}

TypedArray<Node3D> SampleValues::only_visible(const TypedArray<Node3D> &nodes) const {
	TypedArray<Node3D> result;
	for (int64_t i = 0; i < nodes.size(); i++) {
		Node3D *node = Object::cast_to<Node3D>(nodes[i].get_validated_object());
		if (node && node->is_visible()) {
			result.push_back(node);
		}
	}
	return result;
}

PackedInt32Array SampleValues::squares(int count) const {
	PackedInt32Array results;
	results.resize(count);
	const auto square = [](void *data, uint32_t index) { static_cast<int32_t *>(data)[index] = int32_t(index * index); };
	WorkerThreadPool *pool = WorkerThreadPool::get_singleton();
	pool->wait_for_group_task_completion(pool->add_native_group_task(square, results.ptrw(), count));
	return results;
}

int64_t SampleValues::convert_often(const Array &values, int64_t times) const {
	int64_t size = 0;
	for (int64_t i = 0; i < times; i++) {
		const Array array = values[0];
		const Dictionary dictionary = values[1];
		const String text = values[2];
		const PackedFloat32Array floats = values[3];
		const TypedArray<Transform3D> typed = values[4];
		size += array.size() + dictionary.size() + text.length() + floats.size() + typed.size();
	}
	return size;
}

String SampleValues::describe_note(const Ref<SampleNote> &note) const {
	return note.is_valid() ? vformat("%s %d", note->get_text(), note->get_reference_count()) : String("null");
}

String SampleValues::describe_kept() const {
	const Object *object = _kept.get_validated_object();
	return object ? object->get_class() : String("gone");
}

bool SampleValues::is_alive(int64_t id) const {
	return ObjectDB::get_instance(uint64_t(id)) != nullptr;
}

Ref<SampleNote> SampleValues::new_note(const String &text) const {
	Ref<SampleNote> note = memnew(SampleNote);
	note->set_text(text);
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

void SampleValues::fill_multimesh(const Ref<MultiMesh> &multimesh, const PackedFloat32Array &buffer) const {
	ERR_FAIL_COND_MSG(multimesh.is_null(), "SampleValues.fill_multimesh: the multimesh is null.");
	multimesh->set_transform_format(MultiMesh::TRANSFORM_3D);
	multimesh->set_instance_count(int32_t(buffer.size() / 12));
	multimesh->set_buffer(buffer);
}

bool SampleValues::is_editor() {
	return Engine::get_singleton()->is_editor_hint();
}

void SampleValues::fail_with(const String &message) {
	ERR_FAIL_MSG(message);
}

void SampleValues::say(const String &text) {
	ERR_PRINT(String("wrong: ") + text);
	WARN_PRINT(String("odd: ") + text);
}

void SampleValues::_bind_methods() {
	BIND_ENUM_CONSTANT(RED);
	BIND_ENUM_CONSTANT(GREEN);
	BIND_ENUM_CONSTANT(BLUE);

	ClassDB::bind_static_method("SampleValues", D_METHOD("count_alive"), &SampleValues::count_alive);
	ClassDB::bind_static_method("SampleValues", D_METHOD("make_and_drop", "count"), &SampleValues::make_and_drop);
	ClassDB::bind_method(D_METHOD("negate", "value"), &SampleValues::negate);
	ClassDB::bind_method(D_METHOD("add_up", "a", "b", "c", "d"), &SampleValues::add_up);
	ClassDB::bind_method(D_METHOD("halve", "value"), &SampleValues::halve);
	ClassDB::bind_method(D_METHOD("repeat", "text", "times", "separator"), &SampleValues::repeat, DEFVAL(2), DEFVAL("-"));
	ClassDB::bind_method(D_METHOD("count_bytes", "text"), &SampleValues::count_bytes);
	ClassDB::bind_method(D_METHOD("prefixed", "name"), &SampleValues::prefixed);
	ClassDB::bind_method(D_METHOD("child_path", "path"), &SampleValues::child_path);
	ClassDB::bind_method(D_METHOD("sum", "a", "b"), &SampleValues::sum);
	ClassDB::bind_method(D_METHOD("combine", "a", "b"), &SampleValues::combine);
	ClassDB::bind_method(D_METHOD("conjugate", "rotation"), &SampleValues::conjugate);
	ClassDB::bind_method(D_METHOD("inspect", "basis", "vector"), &SampleValues::inspect);
	ClassDB::bind_method(D_METHOD("moved_box", "box", "offset"), &SampleValues::moved_box);
	ClassDB::bind_method(D_METHOD("without_red", "color"), &SampleValues::without_red);
	ClassDB::bind_method(D_METHOD("make_rid"), &SampleValues::make_rid);
	ClassDB::bind_method(D_METHOD("chain", "a", "b"), &SampleValues::chain);
	ClassDB::bind_method(D_METHOD("equal", "a", "b", "c", "d", "e", "f"), &SampleValues::equal);
	ClassDB::bind_method(D_METHOD("mix", "a", "b"), &SampleValues::mix);
	ClassDB::bind_method(D_METHOD("echo", "value"), &SampleValues::echo, DEFVAL(Variant()));
	ClassDB::bind_method(D_METHOD("type_of", "value"), &SampleValues::type_of);
	ClassDB::bind_method(D_METHOD("summarize", "numbers"), &SampleValues::summarize, DEFVAL(Array()));
	ClassDB::bind_method(D_METHOD("keys_and_values", "entries"), &SampleValues::keys_and_values);
	ClassDB::bind_method(D_METHOD("bytes", "bytes"), &SampleValues::bytes);
	ClassDB::bind_method(D_METHOD("ints", "ints"), &SampleValues::ints);
	ClassDB::bind_method(D_METHOD("vectors", "vectors"), &SampleValues::vectors);
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
