#include "sample_node.hpp"

#include <godot_cpp/classes/multiplayer_peer.hpp>
#include <godot_cpp/classes/multiplayer_synchronizer.hpp>
#include <godot_cpp/classes/performance.hpp>
#include <godot_cpp/classes/scene_multiplayer.hpp>
#include <godot_cpp/classes/scene_replication_config.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/core/class_db.hpp>

namespace bindings_sample {

using namespace godot;

void SampleNode::_ready() {
	record("ready");
	set_process(true);
}

void SampleNode::_process(double) {
	_frames++;
	emit_signal("stepped", _frames, get_name());
}

PackedStringArray SampleNode::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (_target.is_empty()) {
		warnings.push_back("no target");
	}
	return warnings;
}

void SampleNode::set_target(const NodePath &p_path) {
	_target = p_path;
}

NodePath SampleNode::get_target() const {
	return _target;
}

void SampleNode::set_note(const Ref<SampleNote> &p_note) {
	_note = p_note;
}

Ref<SampleNote> SampleNode::get_note() const {
	return _note;
}

PackedStringArray SampleNode::get_log() const {
	return _log;
}

int64_t SampleNode::get_frames() const {
	return _frames;
}

String SampleNode::find_target() const {
	const Node3D *target = get_node<Node3D>(_target);
	return target ? String(target->get_name()) : String("none");
}

String SampleNode::find_missing() const {
	return get_node_or_null(NodePath("no/such/node")) ? String("found") : String("missing");
}

Node *SampleNode::grow(const String &p_name) {
	SampleMover *child = memnew(SampleMover);
	child->set_name(p_name);
	add_child(child);
	return child;
}

int64_t SampleNode::prune() {
	int64_t count = 0;
	for (; get_child_count() > 0; count++) {
		memdelete(get_child(0));
	}
	return count;
}

Variant SampleNode::call_other(Object *p_other, const StringName &p_method, const Variant &p_a, const Variant &p_b) const {
	return p_other ? p_other->call(p_method, p_a, p_b) : Variant();
}

void SampleNode::listen(Object *p_source, const StringName &p_signal) {
	p_source->connect(p_signal, Callable(this, "_heard").bindv(Array{ "bound" }));
}

void SampleNode::stop_listening(Object *p_source, const StringName &p_signal) {
	p_source->disconnect(p_signal, Callable(this, "_heard"));
}

void SampleNode::_heard(const Variant &p_what, const String &p_bound) {
	record(vformat("%s %s", p_what, p_bound));
}

Callable SampleNode::callable_of(const StringName &p_method) {
	return Callable(this, p_method);
}

Variant SampleNode::call_it(const Callable &p_callable, const Array &p_arguments) const {
	return p_callable.is_valid() ? p_callable.callv(p_arguments) : Variant("invalid");
}

Array SampleNode::describe_multiplayer() const {
	const Ref<MultiplayerAPI> api = get_multiplayer();
	const Ref<SceneMultiplayer> scene_api = api;
	const Ref<MultiplayerPeer> peer = scene_api->get_multiplayer_peer();
	return Array{ api->get_class(), scene_api->get_root_path(), api->get_unique_id(), api->get_peers().size(), int64_t(peer->get_connection_status()) };
}

int64_t SampleNode::send(const PackedByteArray &p_bytes, int64_t p_peer) const {
	const Ref<SceneMultiplayer> api = get_multiplayer();
	return int64_t(api->send_bytes(p_bytes, int32_t(p_peer), MultiplayerPeer::TRANSFER_MODE_UNRELIABLE));
}

PackedStringArray SampleNode::names_in_group(const StringName &p_group) const {
	PackedStringArray names;
	const TypedArray<Node> nodes = get_tree()->get_nodes_in_group(p_group);
	for (int64_t i = 0; i < nodes.size(); i++) {
		names.push_back(Object::cast_to<Node>(nodes[i])->get_name());
	}
	return names;
}

bool SampleNode::monitor_frames(const StringName &p_name, bool p_on) {
	Performance *performance = Performance::get_singleton();
	if (p_on) {
		performance->add_custom_monitor(p_name, Callable(this, "get_frames"));
	} else {
		performance->remove_custom_monitor(p_name);
	}
	return performance->has_custom_monitor(p_name);
}

PackedStringArray SampleNode::sent_properties(Node *p_synchronizer) const {
	PackedStringArray names;
	MultiplayerSynchronizer *synchronizer = Object::cast_to<MultiplayerSynchronizer>(p_synchronizer);
	const Ref<SceneReplicationConfig> config = synchronizer->get_replication_config();
	const TypedArray<NodePath> properties = config->get_properties();
	for (int64_t i = 0; i < properties.size(); i++) {
		const NodePath path = properties[i];
		names.push_back(path.get_concatenated_subnames());
	}
	return names;
}

void SampleNode::_notification(int p_what) {
	switch (p_what) {
		case NOTIFICATION_POSTINITIALIZE:
			record("postinitialize");
			break;
		case NOTIFICATION_ENTER_TREE:
			record("enter");
			break;
		case NOTIFICATION_EXIT_TREE:
			record("exit");
			break;
	}
}

void SampleNode::record(const String &p_what) {
	_log.push_back(p_what);
}

void SampleNode::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_target", "path"), &SampleNode::set_target);
	ClassDB::bind_method(D_METHOD("get_target"), &SampleNode::get_target);
	ClassDB::bind_method(D_METHOD("set_note", "note"), &SampleNode::set_note);
	ClassDB::bind_method(D_METHOD("get_note"), &SampleNode::get_note);
	ClassDB::bind_method(D_METHOD("get_log"), &SampleNode::get_log);
	ClassDB::bind_method(D_METHOD("get_frames"), &SampleNode::get_frames);
	ClassDB::bind_method(D_METHOD("find_target"), &SampleNode::find_target);
	ClassDB::bind_method(D_METHOD("find_missing"), &SampleNode::find_missing);
	ClassDB::bind_method(D_METHOD("grow", "name"), &SampleNode::grow);
	ClassDB::bind_method(D_METHOD("prune"), &SampleNode::prune);
	ClassDB::bind_method(D_METHOD("call_other", "other", "method", "a", "b"), &SampleNode::call_other);
	ClassDB::bind_method(D_METHOD("listen", "source", "signal"), &SampleNode::listen);
	ClassDB::bind_method(D_METHOD("stop_listening", "source", "signal"), &SampleNode::stop_listening);
	ClassDB::bind_method(D_METHOD("_heard", "what", "bound"), &SampleNode::_heard);
	ClassDB::bind_method(D_METHOD("callable_of", "method"), &SampleNode::callable_of);
	ClassDB::bind_method(D_METHOD("call_it", "callable", "arguments"), &SampleNode::call_it);
	ClassDB::bind_method(D_METHOD("describe_multiplayer"), &SampleNode::describe_multiplayer);
	ClassDB::bind_method(D_METHOD("send", "bytes", "peer"), &SampleNode::send);
	ClassDB::bind_method(D_METHOD("names_in_group", "group"), &SampleNode::names_in_group);
	ClassDB::bind_method(D_METHOD("monitor_frames", "name", "on"), &SampleNode::monitor_frames);
	ClassDB::bind_method(D_METHOD("sent_properties", "synchronizer"), &SampleNode::sent_properties);
	ADD_PROPERTY(PropertyInfo(Variant::NODE_PATH, "target", PROPERTY_HINT_NODE_PATH_VALID_TYPES, "Node3D"), "set_target", "get_target");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "note", PROPERTY_HINT_RESOURCE_TYPE, "SampleNote"), "set_note", "get_note");
	ADD_SIGNAL(MethodInfo("stepped", PropertyInfo(Variant::INT, "frame"), PropertyInfo(Variant::STRING_NAME, "who")));
}

void SampleChild::_process(double p_delta) {
	SampleNode::_process(p_delta);
	_time += p_delta;
}

double SampleChild::get_time() const {
	return _time;
}

void SampleChild::_notification(int p_what) {
	if (p_what == NOTIFICATION_ENTER_TREE) {
		record("child enter");
	} else if (p_what == NOTIFICATION_EXIT_TREE) {
		record("child exit");
	}
}

void SampleChild::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_time"), &SampleChild::get_time);
}

void SampleMover::place(const Vector3 &p_position) {
	set_transform(Transform3D(get_transform().basis, p_position));
}

void SampleMover::place_other(Node3D *p_other, const Transform3D &p_transform) const {
	if (p_other) {
		p_other->set_global_transform(p_transform);
	}
}

Vector3 SampleMover::parent_position() const {
	const Node3D *parent = Object::cast_to<Node3D>(get_parent());
	return parent ? parent->get_global_transform().origin : Vector3();
}

void SampleMover::_bind_methods() {
	ClassDB::bind_method(D_METHOD("place", "position"), &SampleMover::place);
	ClassDB::bind_method(D_METHOD("place_other", "other", "transform"), &SampleMover::place_other);
	ClassDB::bind_method(D_METHOD("parent_position"), &SampleMover::parent_position);
}

} // namespace bindings_sample
