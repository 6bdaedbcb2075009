#pragma once

#include "sample_note.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/callable.hpp>

namespace bindings_sample {

/// A node that records what the engine calls on it.
class SampleNode : public godot::Node {
	GDCLASS(SampleNode, godot::Node)

public:
	void _ready() override;
	void _process(double delta) override;
	godot::PackedStringArray _get_configuration_warnings() const override;

	void set_target(const godot::NodePath &path) { _target = path; }
	godot::NodePath get_target() const { return _target; }
	void set_note(const godot::Ref<SampleNote> &note) { _note = note; }
	godot::Ref<SampleNote> get_note() const { return _note; }
	godot::PackedStringArray get_log() const { return _log; }
	int64_t get_frames() const { return _frames; }
	godot::String find_target() const;
	godot::String find_missing() const;
	/// Creates a child in C++ and returns it.
	godot::Node *grow(const godot::String &name);
	/// Frees all children. Returns their number.
	int64_t prune();
	/// Calls a method of another object by name, with two arguments.
	godot::Variant call_other(godot::Object *other, const godot::StringName &method, const godot::Variant &a, const godot::Variant &b) const { return other ? other->call(method, a, b) : godot::Variant(); }

	/// Connects a signal of another object to overheard(), with "overheard" as the last argument.
	void overhear(godot::Object *source, const godot::StringName &signal);
	void stop_overhearing(godot::Object *source, const godot::StringName &signal);
	/// Callables of methods that are not bound: overheard(what, bound), count(node) and add(a, b) const.
	godot::Array private_callables();
	/// The class of the node's MultiplayerAPI, its root path, this peer's id, the number of other peers, and the
	/// connection status.
	godot::Array describe_multiplayer() const;
	/// Sends bytes to a peer. Returns the Error.
	int64_t send(const godot::PackedByteArray &bytes, int64_t peer) const;
	godot::PackedStringArray names_in_group(const godot::StringName &group) const;
	/// The properties that a MultiplayerSynchronizer replicates.
	godot::PackedStringArray sent_properties(godot::Node *node) const;

protected:
	static void _bind_methods();
	void _notification(int what);
	void record(const godot::String &what) { _log.push_back(what); }

private:
	void overheard(const godot::Variant &what, const godot::String &bound);
	int64_t count(godot::Node *node);
	double add(double a, int64_t b) const { return a + double(b); }

	godot::NodePath _target;
	godot::Ref<SampleNote> _note;
	godot::PackedStringArray _log;
	int64_t _frames = 0;
};

/// A class derived from another extension class. It receives notifications after its parent class, and inherits the
/// virtual methods that it does not override.
class SampleChild : public SampleNode {
	GDCLASS(SampleChild, SampleNode)

public:
	void _process(double delta) override;
	double get_time() const { return _time; }

protected:
	static void _bind_methods();
	void _notification(int what);

private:
	double _time = 0;
};

/// A Node3D that moves itself and other nodes.
class SampleMover : public godot::Node3D {
	GDCLASS(SampleMover, godot::Node3D)

public:
	void place(const godot::Vector3 &position);
	void place_other(godot::Node3D *other, const godot::Transform3D &transform) const;
	/// The global position of the parent; the origin if that is not a Node3D.
	godot::Vector3 parent_position() const;
	/// Places a Node2D, and shows or hides it. Returns its position, rotation, scale, global position and visibility;
	/// empty if the node is not a Node2D.
	godot::Array place_flat(godot::Node *other, const godot::Vector2 &position, double rotation, const godot::Vector2 &scale, bool visible) const;

protected:
	static void _bind_methods();
};

} // namespace bindings_sample
