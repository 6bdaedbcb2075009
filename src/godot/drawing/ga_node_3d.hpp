#pragma once

#include "godot/algebra/multivector.hpp"
#include "godot/drawing/drawn_part.hpp"
#include "godot/drawing/form_meshes.hpp"
#include "godot/free_guard.hpp"
#include "godot/freed_arguments.hpp"
#include "godot/playground/ga_scene.hpp"
#include "godot/thread_guard.hpp"
#include "godot/weak_node.hpp"
#include "playground/drawing/figure.hpp"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/label3d.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/variant/color.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/vector2.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ga_godot {

/// Draws the geometric object that a multivector represents; doc_classes/GANode3D.xml documents it.
///
/// It draws shared meshes (FormMeshes) through the rendering server, whose shaders fit unbounded objects to each view. A new
/// value of the same kind costs as much as a new transform, and a moving camera costs nothing.
class GANode3D : public godot::Node3D, public MainThread<GANode3D> {
	GDCLASS(GANode3D, godot::Node3D)

public:
	GANode3D();
	~GANode3D();

	void set_multivector(const godot::Ref<Multivector> &multivector);
	godot::Ref<Multivector> get_multivector() const { return _multivector; }
	void set_scene(const godot::Ref<GAScene> &scene);
	godot::Ref<GAScene> get_scene() const { return _scene; }
	void set_entry(const godot::StringName &entry);
	godot::StringName get_entry() const { return _entry; }
	void set_ipns(bool ipns);
	bool is_ipns() const { return _ipns; }
	void set_color(const godot::Color &color);
	godot::Color get_color() const { return _color; }
	void set_line_width(double pixels);
	double get_line_width() const { return _line_width; }
	void set_show_label(bool show);
	bool is_showing_label() const { return _show_label; }
	void set_label(const godot::String &label);
	godot::String get_label() const { return _label; }

	/// The value of the entry if the node draws one, otherwise `multivector`; null if it has no value.
	godot::Ref<Multivector> get_value() const;
	/// One line of text that describes the value.
	godot::String describe() const;
	/// Distance in pixels from a point of the screen to the drawn object; infinite if the object is behind the camera.
	double get_screen_distance(godot::Camera3D *camera, const godot::Vector2 &point);

	/// Draws pending changes now.
	void update_drawing();

	godot::PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	void _notification(int what);

private:
	/// Comes from the entry's attributes if the node draws an entry, otherwise from the node's properties.
	struct Appearance {
		bool visible = true;
		bool ipns = false;
		godot::Color color;

		bool operator==(const Appearance &other) const { return visible == other.visible && ipns == other.ipns && color == other.color; }
	};

	bool draws_entry() const;
	const playground::Entry *find_entry() const;
	const cga::Multivector *find_value() const;
	Appearance get_appearance() const;
	bool is_up_to_date() const;
	void value_changed();
	void queue_update();
	void show_parts();
	void draw_parts();
	void write_parts();
	bool has_drawn_forms() const;
	void update_label();
	godot::String label_text() const;

	godot::Ref<Multivector> _multivector;
	godot::Ref<GAScene> _scene;
	godot::StringName _entry;
	std::string _entry_name; // _entry as UTF-8, as documents store it
	godot::Color _color = godot::Color(0.35f, 0.7f, 1.0f);
	double _line_width = 2.0;
	bool _ipns = false;
	bool _show_label = false;
	godot::String _label;

	// The inputs from which _figure was built.
	Appearance _drawn_appearance;
	std::optional<cga::Multivector> _drawn_value;
	playground::drawing::Figure _figure;
	std::shared_ptr<FormMeshes> _meshes; // null before the node first enters a world
	std::vector<std::unique_ptr<DrawnPart>> _drawn; // empty while nothing is visible
	WeakNode<godot::Label3D> _label_node; // an internal child, which scripts may free
	FreeGuard _free_guard;
	bool _stale = true; // the value may have changed since it was drawn
	bool _queued = false;
	bool _in_world = false;
};

} // namespace ga_godot
