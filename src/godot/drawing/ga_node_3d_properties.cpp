#include "godot/drawing/ga_node_3d.hpp"

#include "cga/object/classify.hpp"
#include "godot/algebra/conversions.hpp"
#include "playground/drawing/pick.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>
#include <variant>

// Properties, picking and bindings of GANode3D.

namespace ga_godot {

using godot::Callable;
using godot::Ref;
using godot::String;
using godot::StringName;
using godot::vformat;

// From "#rrggbb" or "#rrggbbaa", the format of the attribute `color`.
static godot::Color parse_color(const std::string &text) {
	const auto channel = [&](size_t index) {
		const std::string digits = text.size() >= 2 * index + 3 ? text.substr(2 * index + 1, 2) : "ff";
		return float(std::strtol(digits.c_str(), nullptr, 16)) / 255.0f;
	};
	return godot::Color(channel(0), channel(1), channel(2), channel(3));
}

// Moves the connection of `on_change` to another resource. Returns false if it is the same resource.
template <class T>
static bool replace_resource(Ref<T> &resource, const Ref<T> &next, const Callable &on_change) {
	if (next == resource) {
		return false;
	}
	const Ref<T> previous = std::exchange(resource, next);
	if (previous.is_valid()) {
		previous->disconnect("changed", on_change);
	}
	if (next.is_valid()) {
		next->connect("changed", on_change);
	}
	return true;
}

void GANode3D::set_multivector(const Ref<Multivector> &multivector) {
	if (replace_resource(_multivector, multivector, callable_mp(this, &GANode3D::value_changed))) {
		queue_update();
		update_configuration_warnings();
	}
}

void GANode3D::set_scene(const Ref<GAScene> &scene) {
	if (replace_resource(_scene, scene, callable_mp(this, &GANode3D::value_changed))) {
		queue_update();
		update_configuration_warnings();
	}
}

void GANode3D::set_entry(const StringName &entry) {
	_entry = entry;
	_entry_name = to_utf8(String(entry));
	queue_update();
	update_configuration_warnings();
}

bool GANode3D::draws_entry() const {
	return _scene.is_valid() && !_entry_name.empty();
}

// A missing entry is not an error: the user may still be typing the name.
const playground::Entry *GANode3D::find_entry() const {
	return draws_entry() ? _scene->find_entry(_entry_name) : nullptr;
}

const cga::Multivector *GANode3D::find_value() const {
	if (draws_entry()) {
		const playground::Entry *entry = find_entry();
		return entry && entry->value ? &*entry->value : nullptr;
	}
	return _multivector.is_valid() ? &_multivector->get_value() : nullptr;
}

GANode3D::Appearance GANode3D::get_appearance() const {
	Appearance appearance{ true, _ipns, _color };
	if (const playground::Entry *entry = find_entry()) {
		appearance.visible = playground::is_set(entry->attributes, "visible");
		appearance.ipns = _ipns || playground::is_set(entry->attributes, "ipns");
		const playground::AttributeValue color = playground::get_attribute(entry->attributes, "color");
		const std::string *text = std::get_if<std::string>(&color);
		if (text && !text->empty()) {
			appearance.color = parse_color(*text);
		}
	}
	return appearance;
}

Ref<Multivector> GANode3D::get_value() const {
	if (draws_entry()) {
		const cga::Multivector *value = find_value();
		return value ? Multivector::make(*value) : Ref<Multivector>();
	}
	return _multivector;
}

void GANode3D::set_ipns(bool ipns) {
	_ipns = ipns;
	queue_update();
}

void GANode3D::set_color(const godot::Color &color) {
	_color = color;
	queue_update();
}

void GANode3D::set_line_width(double pixels) {
	ERR_FAIL_COND_MSG(!std::isfinite(pixels) || pixels <= 0.0 || pixels > 100.0, vformat("GANode3D.line_width: the width must be above 0 and at most 100 pixels, not %s.", pixels));
	_line_width = pixels;
	write_parts();
}

void GANode3D::set_show_label(bool show) {
	_show_label = show;
	if (_in_world) {
		update_label();
	}
}

void GANode3D::set_label(const String &label) {
	_label = label;
	if (_in_world) {
		update_label();
	}
}

double GANode3D::get_screen_distance(godot::Camera3D *camera, const godot::Vector2 &point) {
	constexpr double NOTHING = std::numeric_limits<double>::infinity();
	ERR_FAIL_COND_V_MSG(!camera || !camera->is_inside_tree(), NOTHING, "GANode3D.get_screen_distance: the camera is null or outside the scene tree; pass the camera that renders this node.");
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), NOTHING, "GANode3D.get_screen_distance: the node is outside the scene tree; add it first.");
	update_drawing();
	const godot::Vector2 beside = point + godot::Vector2(1, 0);
	const cga::Vector3<double> origin = to_glm(camera->project_ray_origin(point)), direction = to_glm(camera->project_ray_normal(point));
	const cga::Vector3<double> next_origin = to_glm(camera->project_ray_origin(beside)), next_direction = to_glm(camera->project_ray_normal(beside));
	// Transform the ray into the node's space. The node's scale is uniform.
	const godot::Transform3D global = get_global_transform();
	const cga::Vector3<double> x = to_glm(global.basis.get_column(0)), y = to_glm(global.basis.get_column(1)), z = to_glm(global.basis.get_column(2));
	const double scale = glm::length(x);
	if (!(scale > 0.0)) {
		return NOTHING;
	}
	const auto to_local = [&](const cga::Vector3<double> &vector) {
		return cga::Vector3<double>(glm::dot(vector, x), glm::dot(vector, y), glm::dot(vector, z)) / scale;
	};
	playground::drawing::PickRay ray;
	ray.origin = to_local(origin - to_glm(global.origin)) / scale;
	ray.direction = glm::normalize(to_local(direction));
	ray.pixel_at_origin = glm::length(next_origin - origin) / scale;
	ray.pixel_per_meter = glm::length(next_direction - direction);
	const std::optional<playground::drawing::PickHit> hit = playground::drawing::pick(_figure, ray);
	return hit ? hit->pixels : NOTHING;
}

godot::PackedStringArray GANode3D::_get_configuration_warnings() const {
	godot::PackedStringArray warnings;
	if (_scene.is_valid() && String(_entry).is_empty()) {
		warnings.push_back("\"entry\" is empty, so nothing is drawn. Set it to the name of an entry of the scene.");
	} else if (_scene.is_valid() && !_scene->has_entry(_entry)) {
		warnings.push_back(vformat("The scene has no entry named \"%s\". Set \"entry\" to the name of an existing one.", _entry));
	} else if (_scene.is_null() && _multivector.is_null()) {
		warnings.push_back("There is nothing to draw. Assign a multivector, or a scene and the name of one of its entries.");
	}
	return warnings;
}

void GANode3D::_bind_methods() {
	using godot::ClassDB;
	using godot::D_METHOD;
	using godot::PropertyInfo;
	using godot::Variant;

	ClassDB::bind_method(D_METHOD("set_multivector", "multivector"), guarded<&GANode3D::set_multivector>());
	ClassDB::bind_method(D_METHOD("get_multivector"), guarded<&GANode3D::get_multivector>());
	ClassDB::bind_method(D_METHOD("set_scene", "scene"), guarded<&GANode3D::set_scene>());
	ClassDB::bind_method(D_METHOD("get_scene"), guarded<&GANode3D::get_scene>());
	ClassDB::bind_method(D_METHOD("set_entry", "entry"), guarded<&GANode3D::set_entry>());
	ClassDB::bind_method(D_METHOD("get_entry"), guarded<&GANode3D::get_entry>());
	ClassDB::bind_method(D_METHOD("set_ipns", "ipns"), guarded<&GANode3D::set_ipns>());
	ClassDB::bind_method(D_METHOD("is_ipns"), guarded<&GANode3D::is_ipns>());
	ClassDB::bind_method(D_METHOD("set_color", "color"), guarded<&GANode3D::set_color>());
	ClassDB::bind_method(D_METHOD("get_color"), guarded<&GANode3D::get_color>());
	ClassDB::bind_method(D_METHOD("set_line_width", "pixels"), guarded<&GANode3D::set_line_width>());
	ClassDB::bind_method(D_METHOD("get_line_width"), guarded<&GANode3D::get_line_width>());
	ClassDB::bind_method(D_METHOD("set_show_label", "show"), guarded<&GANode3D::set_show_label>());
	ClassDB::bind_method(D_METHOD("is_showing_label"), guarded<&GANode3D::is_showing_label>());
	ClassDB::bind_method(D_METHOD("set_label", "label"), guarded<&GANode3D::set_label>());
	ClassDB::bind_method(D_METHOD("get_label"), guarded<&GANode3D::get_label>());

	ClassDB::bind_method(D_METHOD("get_value"), guarded<&GANode3D::get_value>());
	ClassDB::bind_method(D_METHOD("describe"), guarded<&GANode3D::describe>());
	ClassDB::bind_method(D_METHOD("get_screen_distance", "camera", "point"), guarded<&GANode3D::get_screen_distance>());
	ClassDB::bind_method(D_METHOD("update_drawing"), guarded<&GANode3D::update_drawing>());

	using godot::PROPERTY_HINT_RANGE;
	using godot::PROPERTY_HINT_RESOURCE_TYPE;
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "multivector", PROPERTY_HINT_RESOURCE_TYPE, "Multivector"), "set_multivector", "get_multivector");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "scene", PROPERTY_HINT_RESOURCE_TYPE, "GAScene"), "set_scene", "get_scene");
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "entry"), "set_entry", "get_entry");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "ipns"), "set_ipns", "is_ipns");
	ADD_PROPERTY(PropertyInfo(Variant::COLOR, "color"), "set_color", "get_color");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "line_width", PROPERTY_HINT_RANGE, "0.5,10,0.1,or_greater,suffix:px"), "set_line_width", "get_line_width");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "show_label"), "set_show_label", "is_showing_label");
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "label"), "set_label", "get_label");
}

} // namespace ga_godot
