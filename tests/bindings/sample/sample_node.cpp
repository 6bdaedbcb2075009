#include "sample_node.hpp"

#include <godot_cpp/classes/multiplayer_peer.hpp>
#include <godot_cpp/classes/multiplayer_synchronizer.hpp>
#include <godot_cpp/classes/node2d.hpp>
#include <godot_cpp/classes/scene_multiplayer.hpp>
#include <godot_cpp/classes/scene_replication_config.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

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

String SampleNode::find_target() const {
	const Node3D *target = Object::cast_to<Node3D>(get_node_or_null(_target));
	return target ? String(target->get_name()) : String("none");
}

String SampleNode::find_missing() const {
	return get_node_or_null(NodePath("no/such/node")) ? String("found") : String("missing");
}

Node *SampleNode::grow(const String &name) {
	SampleMover *child = memnew(SampleMover);
	child->set_name(name);
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

void SampleNode::overhear(Object *source, const StringName &signal) {
	source->connect(signal, callable_mp(this, &SampleNode::overheard).bindv(Array{ "overheard" }));
}

void SampleNode::stop_overhearing(Object *source, const StringName &signal) {
	source->disconnect(signal, callable_mp(this, &SampleNode::overheard));
}

void SampleNode::overheard(const Variant &what, const String &bound) {
	record(vformat("%s %s", what, bound));
}

int64_t SampleNode::count(Node *node) {
	record("counted");
	return node != nullptr ? node->get_child_count() : -1;
}

Array SampleNode::private_callables() {
	const SampleNode *constant = this;
	return Array{ callable_mp(this, &SampleNode::overheard), callable_mp(this, &SampleNode::count), callable_mp(constant, &SampleNode::add) };
}

Array SampleNode::describe_multiplayer() const {
	const Ref<MultiplayerAPI> api = get_multiplayer();
	const Ref<SceneMultiplayer> scene_api = api;
	const Ref<MultiplayerPeer> peer = scene_api->get_multiplayer_peer();
	return Array{ api->get_class(), scene_api->get_root_path(), api->get_unique_id(), api->get_peers().size(), int64_t(peer->get_connection_status()) };
}

int64_t SampleNode::send(const PackedByteArray &bytes, int64_t peer) const {
	const Ref<SceneMultiplayer> api = get_multiplayer();
	return int64_t(api->send_bytes(bytes, int32_t(peer), MultiplayerPeer::TRANSFER_MODE_UNRELIABLE));
}

PackedStringArray SampleNode::names_in_group(const StringName &group) const {
	PackedStringArray names;
	const TypedArray<Node> nodes = get_tree()->get_nodes_in_group(group);
	for (int64_t i = 0; i < nodes.size(); i++) {
		names.push_back(Object::cast_to<Node>(nodes[i].get_validated_object())->get_name());
	}
	return names;
}

PackedStringArray SampleNode::sent_properties(Node *node) const {
	PackedStringArray names;
	MultiplayerSynchronizer *synchronizer = Object::cast_to<MultiplayerSynchronizer>(node);
	const Ref<SceneReplicationConfig> config = synchronizer->get_replication_config();
	const TypedArray<NodePath> properties = config->get_properties();
	for (int64_t i = 0; i < properties.size(); i++) {
		const NodePath path = properties[i];
		names.push_back(path.get_concatenated_subnames());
	}
	return names;
}

void SampleNode::_notification(int what) {
	switch (what) {
		case NOTIFICATION_POSTINITIALIZE:
			record("postinitialize");
			break;
		case NOTIFICATION_ENTER_TREE:
			record("enter");
			break;
		case NOTIFICATION_EXIT_TREE:
			record("exit");
			break;
		default:
			break;
	}
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
	ClassDB::bind_method(D_METHOD("overhear", "source", "signal"), &SampleNode::overhear);
	ClassDB::bind_method(D_METHOD("stop_overhearing", "source", "signal"), &SampleNode::stop_overhearing);
	ClassDB::bind_method(D_METHOD("private_callables"), &SampleNode::private_callables);
	ClassDB::bind_method(D_METHOD("describe_multiplayer"), &SampleNode::describe_multiplayer);
	ClassDB::bind_method(D_METHOD("send", "bytes", "peer"), &SampleNode::send);
	ClassDB::bind_method(D_METHOD("names_in_group", "group"), &SampleNode::names_in_group);
	ClassDB::bind_method(D_METHOD("sent_properties", "synchronizer"), &SampleNode::sent_properties);
	ADD_PROPERTY(PropertyInfo(Variant::NODE_PATH, "target", PROPERTY_HINT_NODE_PATH_VALID_TYPES, "Node3D"), "set_target", "get_target");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "note", PROPERTY_HINT_RESOURCE_TYPE, "SampleNote"), "set_note", "get_note");
	ADD_SIGNAL(MethodInfo("stepped", PropertyInfo(Variant::INT, "frame"), PropertyInfo(Variant::STRING_NAME, "who")));
}

void SampleChild::_process(double delta) {
	SampleNode::_process(delta);
	_time += delta;
}

void SampleChild::_notification(int what) {
	if (what == NOTIFICATION_ENTER_TREE) {
		record("child enter");
	} else if (what == NOTIFICATION_EXIT_TREE) {
		record("child exit");
	}
}

void SampleChild::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_time"), &SampleChild::get_time);
}

void SampleMover::place(const Vector3 &position) {
	set_transform(Transform3D(get_transform().basis, position));
}

void SampleMover::place_other(Node3D *other, const Transform3D &transform) const {
	if (other) {
		other->set_global_transform(transform);
	}
}

Vector3 SampleMover::parent_position() const {
	const Node3D *parent = Object::cast_to<Node3D>(get_parent());
	return parent ? parent->get_global_transform().origin : Vector3();
}

Array SampleMover::place_flat(Node *other, const Vector2 &position, double rotation, const Vector2 &scale, bool visible) const {
	Node2D *node = Object::cast_to<Node2D>(other);
	if (node == nullptr) {
		return Array();
	}
	node->set_position(position);
	node->set_rotation(float(rotation));
	node->set_scale(scale);
	node->set_visible(visible);
	return Array{ node->get_position(), node->get_rotation(), node->get_scale(), node->get_global_position(), node->is_visible() };
}

void SampleMover::_bind_methods() {
	ClassDB::bind_method(D_METHOD("place", "position"), &SampleMover::place);
	ClassDB::bind_method(D_METHOD("place_other", "other", "transform"), &SampleMover::place_other);
	ClassDB::bind_method(D_METHOD("parent_position"), &SampleMover::parent_position);
	ClassDB::bind_method(D_METHOD("place_flat", "other", "position", "rotation", "scale", "visible"), &SampleMover::place_flat);
}

} // namespace bindings_sample
