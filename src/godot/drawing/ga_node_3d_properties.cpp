#include "godot/drawing/ga_node_3d.hpp"

#include "cga/object/classify.hpp"
#include "godot/algebra/conversions.hpp"
#include "playground/drawing/pick.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <variant>

// The properties of a GANode3D, picking, and what scripts see of it.

namespace ga_godot {

using godot::Callable;
using godot::Ref;
using godot::String;
using godot::StringName;
using godot::vformat;

// "#rrggbb" or "#rrggbbaa", which is how entries have it.
static godot::Color color_of(const std::string &p_text) {
	const auto channel = [&](size_t p_index) {
		const std::string digits = p_text.size() >= 2 * p_index + 3 ? p_text.substr(2 * p_index + 1, 2) : "ff";
		return float(std::strtol(digits.c_str(), nullptr, 16)) / 255.0f;
	};
	return godot::Color(channel(0), channel(1), channel(2), channel(3));
}

void GANode3D::set_multivector(const Ref<Multivector> &p_multivector) {
	if (p_multivector == _multivector) {
		return;
	}
	const Callable on_change(this, "_value_changed");
	if (_multivector.is_valid()) {
		_multivector->disconnect("changed", on_change);
	}
	_multivector = p_multivector;
	if (_multivector.is_valid()) {
		_multivector->connect("changed", on_change);
	}
	value_changed();
	update_configuration_warnings();
}

Ref<Multivector> GANode3D::get_multivector() const {
	return _multivector;
}

void GANode3D::set_scene(const Ref<GAScene> &p_scene) {
	if (p_scene == _scene) {
		return;
	}
	const Callable on_change(this, "_scene_changed");
	if (_scene.is_valid()) {
		_scene->disconnect("changed", on_change);
	}
	_scene = p_scene;
	if (_scene.is_valid()) {
		_scene->connect("changed", on_change);
	}
	value_changed();
	update_configuration_warnings();
}

Ref<GAScene> GANode3D::get_scene() const {
	return _scene;
}

void GANode3D::set_entry(const StringName &p_entry) {
	_entry = p_entry;
	_entry_name = to_utf8(String(p_entry));
	value_changed();
	update_configuration_warnings();
}

StringName GANode3D::get_entry() const {
	return _entry;
}

bool GANode3D::draws_entry() const {
	return _scene.is_valid() && !_entry_name.empty();
}

// No entry of that name is a state to be in while names are edited, not an error.
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

GANode3D::Look GANode3D::get_look() const {
	Look look{ true, _ipns, _color };
	if (const playground::Entry *entry = find_entry()) {
		look.visible = playground::is_set(entry->attributes, "visible");
		look.ipns = _ipns || playground::is_set(entry->attributes, "ipns");
		const playground::AttributeValue color = playground::get_attribute(entry->attributes, "color");
		const std::string *text = std::get_if<std::string>(&color);
		if (text && !text->empty()) {
			look.color = color_of(*text);
		}
	}
	return look;
}

Ref<Multivector> GANode3D::get_value() const {
	if (draws_entry()) {
		const cga::Multivector *value = find_value();
		return value ? Multivector::make(*value) : Ref<Multivector>();
	}
	return _multivector;
}

void GANode3D::set_ipns(bool p_ipns) {
	_ipns = p_ipns;
	value_changed();
}

bool GANode3D::is_ipns() const {
	return _ipns;
}

void GANode3D::set_color(const godot::Color &p_color) {
	_color = p_color;
	queue_update();
}

godot::Color GANode3D::get_color() const {
	return _color;
}

void GANode3D::set_line_width(double p_pixels) {
	ERR_FAIL_COND_MSG(!std::isfinite(p_pixels) || p_pixels <= 0.0 || p_pixels > 100.0, vformat("GANode3D: line_width is in pixels, above 0 and at most 100, not %f.", p_pixels));
	_line_width = p_pixels;
	write_parts();
}

double GANode3D::get_line_width() const {
	return _line_width;
}

void GANode3D::set_show_label(bool p_show) {
	_show_label = p_show;
	if (_in_world) {
		update_label();
	}
}

bool GANode3D::is_showing_label() const {
	return _show_label;
}

void GANode3D::set_label(const String &p_label) {
	_label = p_label;
	if (_in_world) {
		update_label();
	}
}

String GANode3D::get_label() const {
	return _label;
}

double GANode3D::get_screen_distance(godot::Camera3D *p_camera, const godot::Vector2 &p_point) {
	constexpr double NOTHING = std::numeric_limits<double>::infinity();
	ERR_FAIL_COND_V_MSG(!p_camera || !p_camera->is_inside_tree(), NOTHING, "GANode3D.get_screen_distance: the camera is null or not in the scene tree; pass the one that shows this node.");
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), NOTHING, "GANode3D.get_screen_distance: the node is not in the scene tree; add it first.");
	update_drawing();
	const godot::Vector2 beside = p_point + godot::Vector2(1, 0);
	const cga::Vector3<double> origin = to_glm(p_camera->project_ray_origin(p_point)), direction = to_glm(p_camera->project_ray_normal(p_point));
	const cga::Vector3<double> next_origin = to_glm(p_camera->project_ray_origin(beside)), next_direction = to_glm(p_camera->project_ray_normal(beside));
	// Into the node's space, whose axes are all scaled alike.
	const godot::Transform3D global = get_global_transform();
	const cga::Vector3<double> x = to_glm(global.basis.get_column(0)), y = to_glm(global.basis.get_column(1)), z = to_glm(global.basis.get_column(2));
	const double scale = glm::length(x);
	if (!(scale > 0.0)) {
		return NOTHING;
	}
	const auto turned = [&](const cga::Vector3<double> &p_vector) {
		return cga::Vector3<double>(glm::dot(p_vector, x), glm::dot(p_vector, y), glm::dot(p_vector, z)) / scale;
	};
	playground::drawing::PickRay ray;
	ray.origin = turned(origin - to_glm(global.origin)) / scale;
	ray.direction = glm::normalize(turned(direction));
	ray.pixel_at_origin = glm::length(next_origin - origin) / scale;
	ray.pixel_per_metre = glm::length(next_direction - direction);
	const std::optional<playground::drawing::Touch> touch = playground::drawing::touch(_figure, ray);
	return touch ? touch->pixels : NOTHING;
}

godot::PackedStringArray GANode3D::_get_configuration_warnings() const {
	godot::PackedStringArray warnings;
	if (_scene.is_valid() && String(_entry).is_empty()) {
		warnings.push_back("\"entry\" is empty: nothing of the scene is drawn. Give the name of one of its entries.");
	} else if (_scene.is_valid() && !_scene->has_entry(_entry)) {
		warnings.push_back(vformat("The scene has no entry \"%s\". Give the name of one that it has.", _entry));
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

	ClassDB::bind_method(D_METHOD("set_multivector", "multivector"), &GANode3D::set_multivector);
	ClassDB::bind_method(D_METHOD("get_multivector"), &GANode3D::get_multivector);
	ClassDB::bind_method(D_METHOD("set_scene", "scene"), &GANode3D::set_scene);
	ClassDB::bind_method(D_METHOD("get_scene"), &GANode3D::get_scene);
	ClassDB::bind_method(D_METHOD("set_entry", "entry"), &GANode3D::set_entry);
	ClassDB::bind_method(D_METHOD("get_entry"), &GANode3D::get_entry);
	ClassDB::bind_method(D_METHOD("set_ipns", "ipns"), &GANode3D::set_ipns);
	ClassDB::bind_method(D_METHOD("is_ipns"), &GANode3D::is_ipns);
	ClassDB::bind_method(D_METHOD("set_color", "color"), &GANode3D::set_color);
	ClassDB::bind_method(D_METHOD("get_color"), &GANode3D::get_color);
	ClassDB::bind_method(D_METHOD("set_line_width", "pixels"), &GANode3D::set_line_width);
	ClassDB::bind_method(D_METHOD("get_line_width"), &GANode3D::get_line_width);
	ClassDB::bind_method(D_METHOD("set_show_label", "show"), &GANode3D::set_show_label);
	ClassDB::bind_method(D_METHOD("is_showing_label"), &GANode3D::is_showing_label);
	ClassDB::bind_method(D_METHOD("set_label", "label"), &GANode3D::set_label);
	ClassDB::bind_method(D_METHOD("get_label"), &GANode3D::get_label);

	ClassDB::bind_method(D_METHOD("get_value"), &GANode3D::get_value);
	ClassDB::bind_method(D_METHOD("describe"), &GANode3D::describe);
	ClassDB::bind_method(D_METHOD("get_screen_distance", "camera", "point"), &GANode3D::get_screen_distance);
	ClassDB::bind_method(D_METHOD("update_drawing"), &GANode3D::update_drawing);
	ClassDB::bind_method(D_METHOD("_value_changed"), &GANode3D::value_changed);
	ClassDB::bind_method(D_METHOD("_scene_changed"), &GANode3D::scene_changed);

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
