#include "godot/algebra/conversions.hpp"
#include "godot/playground/ga_scene.hpp"
#include "playground/handles/drag.hpp"
#include "playground/handles/handles.hpp"

#include <godot_cpp/core/error_macros.hpp>

#include <cmath>

// What a person takes hold of in a viewport.

namespace ga_godot {

using godot::Dictionary;
using godot::Error;
using godot::String;
using godot::Vector3;
using godot::vformat;
using playground::handles::Handle;
using playground::handles::Motion;

// In the order of Motion.
static constexpr const char *MOTIONS[] = { "free", "line", "circle", "sphere" };

static Dictionary to_dictionary(const Handle &p_handle) {
	Dictionary dictionary;
	dictionary["key"] = to_godot(p_handle.key);
	dictionary["motion"] = MOTIONS[int(p_handle.constraint.motion)];
	dictionary["place"] = to_godot(p_handle.constraint.position);
	dictionary["center"] = to_godot(p_handle.constraint.center);
	dictionary["axis"] = to_godot(p_handle.constraint.axis);
	dictionary["stem"] = to_godot(p_handle.stem);
	dictionary["is_arm"] = p_handle.is_arm;
	dictionary["moves_body"] = p_handle.moves_body;
	dictionary["grab"] = Vector3();
	return dictionary;
}

// False if it is none of get_handles().
static bool to_handle(const Dictionary &p_dictionary, Handle &r_handle) {
	const String key = p_dictionary.get("key", ""), motion = p_dictionary.get("motion", "");
	r_handle.key = to_utf8(key);
	bool is_motion = false;
	for (int i = 0; i < 4; i++) {
		if (motion == MOTIONS[i]) {
			r_handle.constraint.motion = Motion(i);
			is_motion = true;
		}
	}
	const auto read = [&p_dictionary](const char *p_key, cga::Vector3<double> &r_vector) {
		const godot::Variant value = p_dictionary.get(p_key, godot::Variant());
		if (value.get_type() != godot::Variant::VECTOR3) {
			return false;
		}
		const Vector3 vector = value;
		r_vector = to_glm(vector);
		return is_finite(vector);
	};
	return is_motion && read("place", r_handle.constraint.position) && read("center", r_handle.constraint.center) && read("axis", r_handle.constraint.axis) && read("stem", r_handle.stem) && read("grab", r_handle.grab);
}

godot::TypedArray<Dictionary> GAScene::get_handles(const String &p_name, const Vector3 &p_right) const {
	godot::TypedArray<Dictionary> handles;
	if (const playground::Entry *entry = find(p_name, "get_handles")) {
		for (const Handle &handle : playground::handles::handles_of(_document, entry->name, to_glm(p_right))) {
			handles.push_back(to_dictionary(handle));
		}
	}
	return handles;
}

Error GAScene::drag_handle(const String &p_name, const Dictionary &p_handle, const Vector3 &p_ray_origin, const Vector3 &p_ray_direction, const Vector3 &p_view, double p_step, double p_angle_step) {
	const playground::Entry *entry = find(p_name, "drag_handle");
	if (!entry) {
		return godot::ERR_INVALID_PARAMETER;
	}
	Handle handle;
	ERR_FAIL_COND_V_MSG(!to_handle(p_handle, handle), godot::ERR_INVALID_PARAMETER, "GAScene.drag_handle: the handle must be one of get_handles(), with all of its keys.");
	ERR_FAIL_COND_V_MSG(!std::isfinite(p_step) || !std::isfinite(p_angle_step) || p_step < 0.0 || p_angle_step < 0.0, godot::ERR_INVALID_PARAMETER, vformat("GAScene.drag_handle: the steps are finite and not below 0, 0 for none, not %f and %f.", p_step, p_angle_step));
	const std::optional<playground::handles::Drag> drag = playground::handles::drag(_document, entry->name, handle, { to_glm(p_ray_origin), to_glm(p_ray_direction), to_glm(p_view) }, { p_step, p_angle_step });
	if (!drag) {
		return godot::ERR_SKIP;
	}
	const playground::ChangeResult change = _document.set_parameter(entry->name, drag->parameter, drag->value);
	// While it is dragged that happens, and is no mistake of the caller's.
	return change ? finish(change, "drag_handle") : godot::ERR_SKIP;
}

} // namespace ga_godot
