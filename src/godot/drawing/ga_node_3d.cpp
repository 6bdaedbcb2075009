#include "godot/drawing/ga_node_3d.hpp"

#include "godot/algebra/conversions.hpp"

#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>
#include <cstring>

// Updates of the drawing of a GANode3D.

namespace ga_godot {

using playground::drawing::Form;
using playground::drawing::Placement;

GANode3D::GANode3D() {
	set_notify_transform(true);
}

GANode3D::~GANode3D() = default;

void GANode3D::_notification(int what) {
	if (what == NOTIFICATION_PREDELETE) {
		_free_guard.before_free(*this);
		return;
	}
	const FreeGuard::Scope scope(_free_guard);
	switch (what) {
		case NOTIFICATION_ENTER_WORLD:
			if (!is_inside_tree()) {
				break; // a script can send any notification
			}
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

// Defers drawing, so that all changes in a frame cause one update.
void GANode3D::queue_update() {
	_stale = true;
	if (_in_world && !_queued) {
		_queued = true;
		call_deferred("update_drawing");
	}
}

// A scene reports each change to all nodes, and most changes concern other entries. Comparing values is faster than
// searching the names of the changed entries: a thousand nodes listen while a drag changes hundreds of entries.
void GANode3D::value_changed() {
	if (!is_main_thread()) {
		ERR_PRINT(godot::vformat("GANode3D %s: another thread changed its scene or multivector, which is not drawn. Change what a node draws in the main thread, for example by call_deferred().", get_name()));
		return;
	}
	if (!_stale && !is_up_to_date()) {
		queue_update();
	}
}

// Compares bit for bit.
static bool is_same(const cga::Multivector *value, const std::optional<cga::Multivector> &drawn) {
	if (!value || !drawn) {
		return !value && !drawn;
	}
	return std::memcmp(value->coefficients().data(), drawn->coefficients().data(), sizeof(cga::Multivector::Coefficients)) == 0;
}

bool GANode3D::is_up_to_date() const {
	return get_appearance() == _drawn_appearance && is_same(find_value(), _drawn_value);
}

void GANode3D::update_drawing() {
	const FreeGuard::Scope scope(_free_guard);
	_queued = false;
	if (!_stale) {
		return;
	}
	_stale = false;
	const cga::Multivector *value = find_value();
	_drawn_value = value ? std::optional<cga::Multivector>(*value) : std::nullopt;
	_drawn_appearance = get_appearance();
	_figure = value && _drawn_appearance.visible ? playground::drawing::figure_of(*value, _drawn_appearance.ipns) : playground::drawing::Figure();
	if (_in_world) {
		show_parts();
		update_label();
	}
}

// A hidden node has no instances on the rendering server.
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
		same = _drawn[i]->form() == _figure.parts[i].form && _figure.parts[i].form != Form::CUSTOM;
	}
	return same;
}

// Keeps the parts if the new value has the same forms, as it does during a drag.
void GANode3D::draw_parts() {
	if (!has_drawn_forms()) {
		_drawn.clear();
		const godot::RID scenario = get_world_3d()->get_scenario();
		for (const playground::drawing::Part &part : _figure.parts) {
			_drawn.push_back(std::make_unique<DrawnPart>(*_meshes, part.form, _figure.custom, scenario));
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
		const Placement placement = playground::drawing::placed(part.placement, space);
		InstanceData data;
		data.transform = godot::Transform3D(godot::Basis(to_godot(placement.x * radius), to_godot(placement.y * radius), to_godot(placement.z * radius)), to_godot(placement.origin));
		data.bounds = playground::drawing::placed(playground::drawing::bounds_of(part, _figure.custom), placement);
		data.color = _drawn_appearance.color;
		data.custom = godot::Color(part.radius < 0.0 ? -1.0f : 1.0f, dashed ? 1.0f : 0.0f, _figure.dual ? 1.0f : 0.0f, float(width));
		_drawn[i]->write(data);
	}
}

} // namespace ga_godot
