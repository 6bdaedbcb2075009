#include "godot/drawing/ga_node_3d.hpp"

#include "godot/algebra/conversions.hpp"

#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>
#include <cstring>

// How a GANode3D follows its value, and when it draws it.

namespace ga_godot {

using playground::drawing::Form;
using playground::drawing::Placement;

GANode3D::GANode3D() {
	set_notify_transform(true);
}

GANode3D::~GANode3D() = default;

void GANode3D::_notification(int p_what) {
	switch (p_what) {
		case NOTIFICATION_ENTER_WORLD:
			_in_world = true;
			_meshes = FormMeshes::shared();
			_stale = true;
			update_drawing();
			break;
		case NOTIFICATION_EXIT_WORLD:
			_in_world = false;
			_drawn.clear();
			break;
		case NOTIFICATION_TRANSFORM_CHANGED:
			write_parts();
			break;
		case NOTIFICATION_VISIBILITY_CHANGED:
			show_parts();
			break;
		default:
			break;
	}
}

// Many changes in one frame are drawn once.
void GANode3D::queue_update() {
	_stale = true;
	if (_in_world && !_queued) {
		_queued = true;
		call_deferred("update_drawing");
	}
}

void GANode3D::value_changed() {
	queue_update();
}

// Comes after each change of the scene, of which most are none of this entry's. To compare takes less than to look for its
// name among those that have changed: a thousand nodes listen while hundreds of entries follow a drag.
void GANode3D::scene_changed() {
	if (!_stale && !is_drawn_as_it_is()) {
		queue_update();
	}
}

// Bit for bit.
static bool is_same(const cga::Multivector *p_value, const std::optional<cga::Multivector> &p_drawn) {
	if (!p_value || !p_drawn) {
		return !p_value && !p_drawn;
	}
	return std::memcmp(p_value->coefficients().data(), p_drawn->coefficients().data(), sizeof(cga::Multivector::Coefficients)) == 0;
}

bool GANode3D::is_drawn_as_it_is() const {
	return get_look() == _drawn_look && is_same(find_value(), _drawn_value);
}

void GANode3D::update_drawing() {
	_queued = false;
	if (!_stale) {
		return;
	}
	_stale = false;
	const cga::Multivector *value = find_value();
	_drawn_value = value ? std::optional<cga::Multivector>(*value) : std::nullopt;
	_drawn_look = get_look();
	_figure = value && _drawn_look.visible ? playground::drawing::figure_of(*value, _drawn_look.ipns) : playground::drawing::Figure();
	if (_in_world) {
		show_parts();
		update_label();
	}
}

// What is hidden, by itself or a parent, costs nothing.
void GANode3D::show_parts() {
	if (_in_world && is_visible_in_tree()) {
		draw_parts();
	} else {
		_drawn.clear();
	}
}

bool GANode3D::has_drawn_forms() const {
	bool same = _drawn.size() == _figure.parts.size();
	for (size_t i = 0; same && i < _drawn.size(); i++) {
		same = _drawn[i]->form() == _figure.parts[i].form && _figure.parts[i].form != Form::own;
	}
	return same;
}

// Parts stay where the new value has the same forms as the old one, which it has while something is dragged.
void GANode3D::draw_parts() {
	if (!has_drawn_forms()) {
		_drawn.clear();
		const godot::RID scenario = get_world_3d()->get_scenario();
		for (const playground::drawing::Part &part : _figure.parts) {
			_drawn.push_back(std::make_unique<DrawnPart>(*_meshes, part.form, _figure.own, scenario));
		}
	}
	write_parts();
}

void GANode3D::write_parts() {
	if (_drawn.empty()) {
		return;
	}
	const godot::Transform3D global = get_global_transform();
	const Placement space{ to_glm(global.basis.get_column(0)), to_glm(global.basis.get_column(1)), to_glm(global.basis.get_column(2)), to_glm(global.origin) };
	for (size_t i = 0; i < _drawn.size(); i++) {
		const playground::drawing::Part &part = _figure.parts[i];
		const bool dashed = _figure.imaginary || part.dashed;
		const double width = part.dashed ? 0.6 * _line_width : _line_width;
		const double radius = std::abs(part.radius);
		const Placement place = playground::drawing::placed(part.placement, space);
		InstanceLook look;
		look.place = godot::Transform3D(godot::Basis(to_godot(place.x * radius), to_godot(place.y * radius), to_godot(place.z * radius)), to_godot(place.origin));
		look.bounds = playground::drawing::placed(playground::drawing::box_of(part, _figure.own), place);
		look.color = _drawn_look.color;
		look.style = godot::Color(part.radius < 0.0 ? -1.0f : 1.0f, dashed ? 1.0f : 0.0f, _figure.dual ? 1.0f : 0.0f, float(width));
		_drawn[i]->write(look);
	}
}

} // namespace ga_godot
