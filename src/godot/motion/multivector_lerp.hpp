#pragma once

#include "cga/motor/interpolate.hpp"
#include "godot/algebra/multivector.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <cstdint>

namespace ga_godot {

/// Moves a target node between two poses; doc_classes/MultivectorLerp.xml documents it.
class MultivectorLerp : public godot::Node {
	GDCLASS(MultivectorLerp, godot::Node)

public:
	/// Signed and of fixed type: a script may pass any number, and an error message shows it.
	enum Mode : int {
		LINEAR,
		SCREW,
		SEPARATE,
	};

	static godot::Ref<Multivector> interpolate(const godot::Ref<Multivector> &p_from, const godot::Ref<Multivector> &p_to, double p_weight, Mode p_mode);
	static godot::Transform3D interpolate_transform(const godot::Transform3D &p_from, const godot::Transform3D &p_to, double p_weight, Mode p_mode);
	static godot::Dictionary measure_deviation(const godot::Ref<Multivector> &p_from, const godot::Ref<Multivector> &p_to, Mode p_first, Mode p_second, double p_lever);

	void set_start(const godot::NodePath &p_path);
	godot::NodePath get_start() const;
	void set_end(const godot::NodePath &p_path);
	godot::NodePath get_end() const;
	void set_target(const godot::NodePath &p_path);
	godot::NodePath get_target() const;
	void set_start_motor(const godot::Ref<Multivector> &p_motor);
	godot::Ref<Multivector> get_start_motor() const;
	void set_end_motor(const godot::Ref<Multivector> &p_motor);
	godot::Ref<Multivector> get_end_motor() const;
	void set_factor(double p_factor);
	double get_factor() const;
	void set_mode(Mode p_mode);
	Mode get_mode() const;
	void set_local(bool p_local);
	bool is_local() const;
	void set_auto_play(bool p_auto_play);
	bool is_auto_play() const;
	void set_duration(double p_seconds);
	double get_duration() const;

	void play();
	void stop();
	bool is_playing() const;

	godot::PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	// Not _ready and _process: a script on the node that has its own would silence them.
	void _notification(int p_what);

private:
	static constexpr const char *UNKNOWN_MODE = "MultivectorLerp: mode %d is none of LINEAR (0), SCREW (1), SEPARATE (2).";

	/// A node of the scene, looked up once.
	struct NodeLink {
		godot::NodePath path;
		uint64_t id = 0; // 0: not looked up, or gone
		godot::Node3D *node = nullptr; // of that id; valid while the engine knows the id
		bool lost = false; // leads to no node, which was reported
	};

	/// One end of the motion: a motor, or else a node. Its pose is kept, so that a resting end costs a comparison a frame.
	struct End : NodeLink {
		godot::Ref<Multivector> motor;
		uint64_t motor_revision = 0;
		godot::Transform3D transform;
		cga::Pose<double> pose;
		bool known = false; // pose is that of transform, or of the motor's revision
		bool faulty = false; // it has none, which was reported
	};

	void relink(NodeLink &r_link, const godot::NodePath &p_path);
	void refresh();
	godot::Node3D *find_node(NodeLink &r_link, const char *p_name);
	bool read_end(End &r_end, const char *p_name);
	void advance(double p_delta);
	void update_target();

	End _start;
	End _end;
	NodeLink _target;
	double _factor = 0.0;
	double _duration = 1.0;
	Mode _mode = LINEAR;
	bool _local = false;
	bool _auto_play = false;
	bool _playing = false;
	bool _running = false; // ready, and not in the editor
	bool _stale = true; // factor, mode or an end changed since _result was computed
	godot::Transform3D _result;
};

} // namespace ga_godot

VARIANT_ENUM_CAST(ga_godot::MultivectorLerp::Mode);
