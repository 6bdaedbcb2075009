#pragma once

#include "godot/algebra/conversions.hpp"
#include "godot/motion/multivector_lerp.hpp"
#include "net/stream/stream_settings.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>

namespace ga_godot {

/// The settings of a stream as properties of SELF, a registered class, which has `void settings_changed()` and calls
/// bind_stream_properties() in its _bind_methods(). A value that makes no sense is an error and changes nothing.
template <class SELF>
class StreamProperties {
public:
	void set_position_tolerance(double p_metres) {
		ERR_FAIL_COND_MSG(!is_positive(p_metres), godot::vformat("%s: position_tolerance is in metres and positive, not %f.", SELF::get_class_static(), p_metres));
		set(_settings.position_tolerance, p_metres);
	}
	double get_position_tolerance() const { return _settings.position_tolerance; }

	void set_rotation_tolerance(double p_degrees) {
		ERR_FAIL_COND_MSG(!is_positive(p_degrees), godot::vformat("%s: rotation_tolerance is in degrees and positive, not %f.", SELF::get_class_static(), p_degrees));
		set(_settings.rotation_tolerance, p_degrees);
	}
	double get_rotation_tolerance() const { return _settings.rotation_tolerance; }

	void set_max_latency(double p_seconds) {
		ERR_FAIL_COND_MSG(!is_positive(p_seconds), godot::vformat("%s: max_latency is in seconds and positive, not %f.", SELF::get_class_static(), p_seconds));
		set(_settings.max_latency, p_seconds);
	}
	double get_max_latency() const { return _settings.max_latency; }

	void set_send_rate(double p_hertz) {
		ERR_FAIL_COND_MSG(!is_positive(p_hertz), godot::vformat("%s: send_rate is in packets a second and positive, not %f.", SELF::get_class_static(), p_hertz));
		set(_settings.send_rate, p_hertz);
	}
	double get_send_rate() const { return _settings.send_rate; }

	void set_mode(MultivectorLerp::Mode p_mode) {
		ERR_FAIL_COND_MSG(!is_mode(p_mode), godot::vformat("%s: mode %d is none of LINEAR (0), SCREW (1), SEPARATE (2).", SELF::get_class_static(), int64_t(p_mode)));
		set(_settings.mode, cga::Mode(p_mode));
	}
	MultivectorLerp::Mode get_mode() const { return MultivectorLerp::Mode(_settings.mode); }

protected:
	static bool is_positive(double p_value) { return std::isfinite(p_value) && p_value > 0.0; }

	static void bind_stream_properties() {
		using godot::PROPERTY_HINT_ENUM;
		using godot::PROPERTY_HINT_RANGE;
		using godot::PropertyInfo;
		using godot::Variant;
		bind_property<double>("position_tolerance", "metres", &SELF::set_position_tolerance, &SELF::get_position_tolerance, PropertyInfo(Variant::FLOAT, "position_tolerance", PROPERTY_HINT_RANGE, "0.0001,0.1,0.0001,or_greater,suffix:m"));
		bind_property<double>("rotation_tolerance", "degrees", &SELF::set_rotation_tolerance, &SELF::get_rotation_tolerance, PropertyInfo(Variant::FLOAT, "rotation_tolerance", PROPERTY_HINT_RANGE, "0.01,10,0.01,or_greater,suffix:°"));
		bind_property<double>("max_latency", "seconds", &SELF::set_max_latency, &SELF::get_max_latency, PropertyInfo(Variant::FLOAT, "max_latency", PROPERTY_HINT_RANGE, "0.02,1,0.01,or_greater,suffix:s"));
		bind_property<double>("send_rate", "hertz", &SELF::set_send_rate, &SELF::get_send_rate, PropertyInfo(Variant::FLOAT, "send_rate", PROPERTY_HINT_RANGE, "1,60,1,or_greater,suffix:Hz"));
		bind_property<MultivectorLerp::Mode>("mode", "mode", &SELF::set_mode, &SELF::get_mode, PropertyInfo(Variant::INT, "mode", PROPERTY_HINT_ENUM, "Linear,Screw,Separate"));
	}

	net::StreamSettings _settings;

private:
	template <class T>
	void set(T &r_setting, T p_value) {
		if (r_setting != p_value) {
			r_setting = p_value;
			static_cast<SELF *>(this)->settings_changed();
		}
	}

	/// The pointers to this class's methods become ones to SELF's, which is the class that scripts know.
	template <class T>
	static void bind_property(const char *p_name, const char *p_argument, void (SELF::*p_setter)(T), T (SELF::*p_getter)() const, const godot::PropertyInfo &p_info) {
		const godot::String setter = godot::vformat("set_%s", p_name);
		const godot::String getter = godot::vformat("get_%s", p_name);
		godot::ClassDB::bind_method(godot::D_METHOD(godot::StringName(setter), p_argument), p_setter);
		godot::ClassDB::bind_method(godot::D_METHOD(godot::StringName(getter)), p_getter);
		godot::ClassDB::add_property(SELF::get_class_static(), p_info, setter, getter);
	}
};

} // namespace ga_godot
