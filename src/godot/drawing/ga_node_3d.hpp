#pragma once

#include "godot/algebra/multivector.hpp"
#include "godot/drawing/drawn_part.hpp"
#include "godot/drawing/form_meshes.hpp"
#include "godot/playground/ga_scene.hpp"
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

/// Draws a multivector as the object that it is, in the editor and in the game; doc_classes/GANode3D.xml documents it.
///
/// Straight on the rendering server: its parts are drawn by drawn_part.hpp from shared meshes (form_meshes.hpp), whose
/// shaders fit what has no end to each view. So a change costs no more than a transform, and a change of the view nothing.
class GANode3D : public godot::Node3D {
	GDCLASS(GANode3D, godot::Node3D)

public:
	GANode3D();
	~GANode3D();

	void set_multivector(const godot::Ref<Multivector> &p_multivector);
	godot::Ref<Multivector> get_multivector() const;
	void set_scene(const godot::Ref<GAScene> &p_scene);
	godot::Ref<GAScene> get_scene() const;
	void set_entry(const godot::StringName &p_entry);
	godot::StringName get_entry() const;
	void set_ipns(bool p_ipns);
	bool is_ipns() const;
	void set_color(const godot::Color &p_color);
	godot::Color get_color() const;
	void set_line_width(double p_pixels);
	double get_line_width() const;
	void set_show_label(bool p_show);
	bool is_showing_label() const;
	void set_label(const godot::String &p_label);
	godot::String get_label() const;

	/// What is drawn: that of the scene's entry, or else the multivector's; null if there is none.
	godot::Ref<Multivector> get_value() const;
	/// One line of text about it.
	godot::String describe() const;
	/// Pixels between a point of the screen and what is drawn there; INFINITY if that is behind the camera.
	double get_screen_distance(godot::Camera3D *p_camera, const godot::Vector2 &p_point);

	/// Draws what has changed, if anything has.
	void update_drawing();

	godot::PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	/// How it is drawn, by the entry's attributes, or else by the node's properties.
	struct Look {
		bool visible = true;
		bool ipns = false;
		godot::Color color;

		bool operator==(const Look &p_other) const { return visible == p_other.visible && ipns == p_other.ipns && color == p_other.color; }
	};

	bool draws_entry() const;
	const playground::Entry *find_entry() const;
	const cga::Multivector *find_value() const;
	Look get_look() const;
	bool is_drawn_as_it_is() const;
	void value_changed();
	void scene_changed();
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
	std::string _entry_name; // the same, as documents have it
	godot::Color _color = godot::Color(0.35f, 0.7f, 1.0f);
	double _line_width = 2.0;
	bool _ipns = false;
	bool _show_label = false;
	godot::String _label;

	// What the figure was made of.
	Look _drawn_look;
	std::optional<cga::Multivector> _drawn_value;
	playground::drawing::Figure _figure;
	std::shared_ptr<FormMeshes> _meshes; // since it was in a world
	std::vector<std::unique_ptr<DrawnPart>> _drawn; // empty while nothing is to be seen
	godot::Label3D *_label_node = nullptr;
	bool _stale = true; // the value has changed since it was drawn
	bool _queued = false;
	bool _in_world = false;
};

} // namespace ga_godot
