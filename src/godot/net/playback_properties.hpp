#pragma once

#include "net/endpoint/receiver.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>

namespace ga_godot {

/// The limits of the playback delay as properties of SELF, a registered class, which has `void limits_changed()` and
/// calls bind_playback_properties() in its _bind_methods().
template <class SELF>
class PlaybackProperties {
public:
	void set_least_delay(double p_seconds) {
		ERR_FAIL_COND_MSG(!is_duration(p_seconds), godot::vformat("%s: least_delay is in seconds and not negative, not %f.", SELF::get_class_static(), p_seconds));
		_least_delay = p_seconds;
		static_cast<SELF *>(this)->limits_changed();
	}
	double get_least_delay() const { return _least_delay; }

	void set_jitter_allowance(double p_seconds) {
		ERR_FAIL_COND_MSG(!is_duration(p_seconds), godot::vformat("%s: jitter_allowance is in seconds and not negative, not %f.", SELF::get_class_static(), p_seconds));
		_jitter_allowance = p_seconds;
		static_cast<SELF *>(this)->limits_changed();
	}
	double get_jitter_allowance() const { return _jitter_allowance; }

protected:
	static void bind_playback_properties() {
		using godot::ClassDB;
		using godot::D_METHOD;
		using godot::PROPERTY_HINT_RANGE;
		using godot::PropertyInfo;
		using godot::Variant;
		void (SELF::*set_least)(double) = &SELF::set_least_delay;
		double (SELF::*get_least)() const = &SELF::get_least_delay;
		void (SELF::*set_jitter)(double) = &SELF::set_jitter_allowance;
		double (SELF::*get_jitter)() const = &SELF::get_jitter_allowance;
		ClassDB::bind_method(D_METHOD("set_least_delay", "seconds"), set_least);
		ClassDB::bind_method(D_METHOD("get_least_delay"), get_least);
		ClassDB::add_property(SELF::get_class_static(), PropertyInfo(Variant::FLOAT, "least_delay", PROPERTY_HINT_RANGE, "0,1,0.01,or_greater,suffix:s"), "set_least_delay", "get_least_delay");
		ClassDB::bind_method(D_METHOD("set_jitter_allowance", "seconds"), set_jitter);
		ClassDB::bind_method(D_METHOD("get_jitter_allowance"), get_jitter);
		ClassDB::add_property(SELF::get_class_static(), PropertyInfo(Variant::FLOAT, "jitter_allowance", PROPERTY_HINT_RANGE, "0,1,0.01,or_greater,suffix:s"), "set_jitter_allowance", "get_jitter_allowance");
	}

	void limit(net::Receiver &r_stream) const { r_stream.set_margin_limits(_least_delay, _jitter_allowance); }

private:
	static bool is_duration(double p_value) { return std::isfinite(p_value) && p_value >= 0.0; }

	double _least_delay = 0.0;
	double _jitter_allowance = 0.2;
};

} // namespace ga_godot
