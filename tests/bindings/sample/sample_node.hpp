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
	void _process(double p_delta) override;
	godot::PackedStringArray _get_configuration_warnings() const override;

	void set_target(const godot::NodePath &p_path);
	godot::NodePath get_target() const;
	void set_note(const godot::Ref<SampleNote> &p_note);
	godot::Ref<SampleNote> get_note() const;
	godot::PackedStringArray get_log() const;
	int64_t get_frames() const;
	godot::String find_target() const;
	godot::String find_missing() const;
	/// Adds a child that C++ makes, and returns it.
	godot::Node *grow(const godot::String &p_name);
	/// Frees all children; how many there were.
	int64_t prune();
	/// Calls a method of another object by name, with two arguments.
	godot::Variant call_other(godot::Object *p_other, const godot::StringName &p_method, const godot::Variant &p_a, const godot::Variant &p_b) const;

	/// Connects a signal of another object to a method here, with "bound" as last argument, and undoes it.
	void listen(godot::Object *p_source, const godot::StringName &p_signal);
	void stop_listening(godot::Object *p_source, const godot::StringName &p_signal);
	godot::Callable callable_of(const godot::StringName &p_method);
	godot::Variant call_it(const godot::Callable &p_callable, const godot::Array &p_arguments) const;
	/// The class of the node's MultiplayerAPI, its root path, this peer's id, how many others there are, and the state
	/// of the connection.
	godot::Array describe_multiplayer() const;
	/// Sends bytes to a peer; the error as a number.
	int64_t send(const godot::PackedByteArray &p_bytes, int64_t p_peer) const;
	godot::PackedStringArray names_in_group(const godot::StringName &p_group) const;
	/// Registers a monitor that gives the number of frames, or removes it; whether it is there then.
	bool monitor_frames(const godot::StringName &p_name, bool p_on);
	/// The properties that a MultiplayerSynchronizer sends.
	godot::PackedStringArray sent_properties(godot::Node *p_synchronizer) const;

protected:
	static void _bind_methods();
	void _notification(int p_what);
	void record(const godot::String &p_what);
	void _heard(const godot::Variant &p_what, const godot::String &p_bound);

private:
	godot::NodePath _target;
	godot::Ref<SampleNote> _note;
	godot::PackedStringArray _log;
	int64_t _frames = 0;
};

/// A class below another extension class: its notifications come after its parent's, and the parent's virtual methods
/// stay its own.
class SampleChild : public SampleNode {
	GDCLASS(SampleChild, SampleNode)

public:
	void _process(double p_delta) override;
	double get_time() const;

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	double _time = 0;
};

/// A node in space that moves itself and others.
class SampleMover : public godot::Node3D {
	GDCLASS(SampleMover, godot::Node3D)

public:
	void place(const godot::Vector3 &p_position);
	void place_other(godot::Node3D *p_other, const godot::Transform3D &p_transform) const;
	/// Where the parent is in the world; the origin if that is no Node3D.
	godot::Vector3 parent_position() const;

protected:
	static void _bind_methods();
};

} // namespace bindings_sample
