#pragma once

#include "godot/algebra/conversions.hpp"
#include "godot/motion/multivector_lerp.hpp"
#include "net/stream/stream_settings.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>

namespace ga_godot {

/// The settings of a stream as properties of Self, a registered class, which has `void settings_changed()` and calls
/// bind_stream_properties() in its _bind_methods(). An invalid value is an error and changes nothing.
template <class Self>
class StreamProperties {
public:
	void set_position_tolerance(double meters) {
		ERR_FAIL_COND_MSG(!is_positive(meters), godot::vformat("%s: position_tolerance is %f, but must be a positive number of meters.", Self::get_class_static(), meters));
		set(_settings.position_tolerance, meters);
	}
	double get_position_tolerance() const { return _settings.position_tolerance; }

	void set_rotation_tolerance(double degrees) {
		ERR_FAIL_COND_MSG(!is_positive(degrees), godot::vformat("%s: rotation_tolerance is %f, but must be a positive number of degrees.", Self::get_class_static(), degrees));
		set(_settings.rotation_tolerance, degrees);
	}
	double get_rotation_tolerance() const { return _settings.rotation_tolerance; }

	void set_max_latency(double seconds) {
		ERR_FAIL_COND_MSG(!is_positive(seconds), godot::vformat("%s: max_latency is %f, but must be a positive number of seconds.", Self::get_class_static(), seconds));
		set(_settings.max_latency, seconds);
	}
	double get_max_latency() const { return _settings.max_latency; }

	void set_send_rate(double hertz) {
		ERR_FAIL_COND_MSG(!is_positive(hertz), godot::vformat("%s: send_rate is %f, but must be a positive number of packets per second.", Self::get_class_static(), hertz));
		set(_settings.send_rate, hertz);
	}
	double get_send_rate() const { return _settings.send_rate; }

	void set_mode(MultivectorLerp::Mode mode) {
		ERR_FAIL_COND_MSG(!is_mode(mode), godot::vformat("%s: mode is %d, but must be LINEAR (0), SCREW (1) or SEPARATE (2).", Self::get_class_static(), int64_t(mode)));
		set(_settings.mode, cga::Mode(mode));
	}
	MultivectorLerp::Mode get_mode() const { return MultivectorLerp::Mode(_settings.mode); }

protected:
	static bool is_positive(double value) { return std::isfinite(value) && value > 0.0; }

	static void bind_stream_properties() {
		using godot::PROPERTY_HINT_ENUM;
		using godot::PROPERTY_HINT_RANGE;
		using godot::PropertyInfo;
		using godot::Variant;
		bind_property<double>("position_tolerance", "meters", &Self::set_position_tolerance, &Self::get_position_tolerance, PropertyInfo(Variant::FLOAT, "position_tolerance", PROPERTY_HINT_RANGE, "0.0001,0.1,0.0001,or_greater,suffix:m"));
		bind_property<double>("rotation_tolerance", "degrees", &Self::set_rotation_tolerance, &Self::get_rotation_tolerance, PropertyInfo(Variant::FLOAT, "rotation_tolerance", PROPERTY_HINT_RANGE, "0.01,10,0.01,or_greater,suffix:°"));
		bind_property<double>("max_latency", "seconds", &Self::set_max_latency, &Self::get_max_latency, PropertyInfo(Variant::FLOAT, "max_latency", PROPERTY_HINT_RANGE, "0.02,1,0.01,or_greater,suffix:s"));
		bind_property<double>("send_rate", "hertz", &Self::set_send_rate, &Self::get_send_rate, PropertyInfo(Variant::FLOAT, "send_rate", PROPERTY_HINT_RANGE, "1,60,1,or_greater,suffix:Hz"));
		bind_property<MultivectorLerp::Mode>("mode", "mode", &Self::set_mode, &Self::get_mode, PropertyInfo(Variant::INT, "mode", PROPERTY_HINT_ENUM, "Linear,Screw,Separate"));
	}

	net::StreamSettings _settings;

private:
	template <class T>
	void set(T &setting, T value) {
		if (setting != value) {
			setting = value;
			static_cast<Self *>(this)->settings_changed();
		}
	}

	/// Binds methods of this base class as methods of Self, the registered class.
	template <class T>
	static void bind_property(const char *name, const char *argument, void (Self::*setter)(T), T (Self::*getter)() const, const godot::PropertyInfo &info) {
		const godot::String setter_name = godot::vformat("set_%s", name);
		const godot::String getter_name = godot::vformat("get_%s", name);
		godot::ClassDB::bind_method(godot::D_METHOD(godot::StringName(setter_name), argument), setter);
		godot::ClassDB::bind_method(godot::D_METHOD(godot::StringName(getter_name)), getter);
		godot::ClassDB::add_property(Self::get_class_static(), info, setter_name, getter_name);
	}
};

} // namespace ga_godot
