#include "godot/drawing/ga_node_3d.hpp"

#include "cga/object/classify.hpp"
#include "godot/algebra/conversions.hpp"

#include <godot_cpp/classes/base_material3d.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/variant/variant.hpp>

// The label of a GANode3D.

namespace ga_godot {

using godot::Color;
using godot::Label3D;
using godot::String;

// The font is rendered at twice its size on the screen, to stay sharp. PIXEL_SIZE is in meters at a depth of one meter.
static constexpr int FONT_SIZE = 36, OUTLINE_SIZE = 12;
static constexpr float PIXEL_SIZE = 0.00085f;

String GANode3D::label_text() const {
	if (!_label.is_empty()) {
		return _label;
	}
	if (draws_entry()) {
		return String(_entry);
	}
	return String(get_name());
}

String GANode3D::describe() const {
	const cga::Multivector *value = find_value();
	return value ? to_godot(cga::describe(cga::classify(*value, get_appearance().ipns))) : String("no value");
}

void GANode3D::update_label() {
	// Handlers of the label's and of this node's signals may free either.
	const FreeGuard::Scope scope(_free_guard);
	Label3D *label = _label_node.get();
	const bool wanted = _show_label && _figure.label_position.has_value();
	if (!wanted) {
		if (label != nullptr) {
			label->set_visible(false);
		}
		return;
	}
	const bool is_new = label == nullptr;
	if (is_new) {
		label = memnew(Label3D);
		label->set_billboard_mode(godot::BaseMaterial3D::BILLBOARD_ENABLED);
		label->set_draw_flag(Label3D::FLAG_FIXED_SIZE, true);
		label->set_draw_flag(Label3D::FLAG_DISABLE_DEPTH_TEST, true);
		label->set_draw_flag(Label3D::FLAG_SHADED, false);
		label->set_font_size(FONT_SIZE);
		label->set_outline_size(OUTLINE_SIZE);
		label->set_pixel_size(PIXEL_SIZE);
		label->set_horizontal_alignment(godot::HORIZONTAL_ALIGNMENT_LEFT);
		label->set_vertical_alignment(godot::VERTICAL_ALIGNMENT_BOTTOM);
		label->set_offset(godot::Vector2(18, 14));
		label->set_render_priority(3);
		label->set_outline_render_priority(2);
		_label_node = WeakNode<Label3D>(label);
	}
	// A dark outline around light text, or the reverse, is readable on any background.
	const float lightness = 0.3f * _drawn_appearance.color.r + 0.59f * _drawn_appearance.color.g + 0.11f * _drawn_appearance.color.b;
	label->set_modulate(Color(_drawn_appearance.color.r, _drawn_appearance.color.g, _drawn_appearance.color.b));
	label->set_outline_modulate(lightness > 0.5f ? Color(0.08f, 0.09f, 0.11f, 0.85f) : Color(1, 1, 1, 0.85f));
	label->set_text(label_text());
	label->set_position(to_godot(*_figure.label_position));
	if (is_new) {
		add_child(label, false, INTERNAL_MODE_FRONT);
	} else if (_label_node.get() != nullptr) {
		label->set_visible(true);
	}
}

} // namespace ga_godot
