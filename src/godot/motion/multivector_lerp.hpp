#pragma once

#include "cga/motor/interpolate.hpp"
#include "godot/algebra/multivector.hpp"
#include "godot/free_guard.hpp"
#include "godot/thread_guard.hpp"
#include "godot/weak_node.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <cstdint>

namespace ga_godot {

/// Moves a target node between two poses. Documented in doc_classes/MultivectorLerp.xml.
class MultivectorLerp : public godot::Node, public MainThread<MultivectorLerp, true> {
	GDCLASS(MultivectorLerp, godot::Node)

public:
	/// The values of cga::Mode. The underlying type holds any integer that a script passes.
	enum Mode : int64_t {
		LINEAR,
		SCREW,
		SEPARATE,
	};

	static godot::Ref<Multivector> interpolate(const godot::Ref<Multivector> &from, const godot::Ref<Multivector> &to, double weight, Mode mode);
	static godot::Transform3D interpolate_transform(const godot::Transform3D &from, const godot::Transform3D &to, double weight, Mode mode);
	static godot::Dictionary measure_deviation(const godot::Ref<Multivector> &from, const godot::Ref<Multivector> &to, Mode first, Mode second, double lever_arm);

	void set_start(const godot::NodePath &path) { set_path(_start, path); }
	godot::NodePath get_start() const { return _start.path; }
	void set_end(const godot::NodePath &path) { set_path(_end, path); }
	godot::NodePath get_end() const { return _end.path; }
	void set_target(const godot::NodePath &path) { set_path(_target, path); }
	godot::NodePath get_target() const { return _target.path; }
	void set_start_motor(const godot::Ref<Multivector> &motor) { set_motor(_start, motor); }
	godot::Ref<Multivector> get_start_motor() const { return _start.motor; }
	void set_end_motor(const godot::Ref<Multivector> &motor) { set_motor(_end, motor); }
	godot::Ref<Multivector> get_end_motor() const { return _end.motor; }
	void set_factor(double factor);
	double get_factor() const { return _factor; }
	void set_mode(Mode mode);
	Mode get_mode() const { return _mode; }
	void set_local(bool local);
	bool is_local() const { return _local; }
	void set_auto_play(bool auto_play) { _auto_play = auto_play; }
	bool is_auto_play() const { return _auto_play; }
	void set_duration(double seconds);
	double get_duration() const { return _duration; }

	void play();
	void stop() { _playing = false; }
	bool is_playing() const { return _playing; }

	godot::PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	// Handles READY and PROCESS here, because a script's own _ready and _process would replace those of this class.
	void _notification(int what);

private:
	/// A node path and the node that it was resolved to.
	struct NodeLink {
		godot::NodePath path;
		WeakNode<godot::Node3D> node; // none if not resolved
		bool lost = false; // could not be resolved; the error has been printed
	};

	/// One end of the motion: the motor if it is set, else the node. An end at rest costs one comparison per frame.
	struct End : NodeLink {
		godot::Ref<Multivector> motor;
		uint64_t motor_revision = 0;
		godot::Transform3D transform;
		cga::Pose<double> pose;
		bool known = false; // pose is that of transform or motor_revision
		bool faulty = false; // has no pose; the error has been printed
	};

	void set_path(NodeLink &link, const godot::NodePath &path);
	void set_motor(End &end, const godot::Ref<Multivector> &motor);
	void refresh();
	godot::Node3D *find_node(NodeLink &link, const char *name);
	bool update_end(End &end, const char *name);
	void advance(double delta);
	void update_target();

	FreeGuard _free_guard; // The target's callbacks may free this node.
	End _start;
	End _end;
	NodeLink _target;
	double _factor = 0.0;
	double _duration = 1.0;
	Mode _mode = LINEAR;
	bool _local = false;
	bool _auto_play = false;
	bool _playing = false;
	bool _running = false; // ready and not in the editor
	bool _stale = true; // factor, mode or an end changed since _result was computed
	godot::Transform3D _result;
};

} // namespace ga_godot

VARIANT_ENUM_CAST(ga_godot::MultivectorLerp::Mode);
