#pragma once

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>

namespace ga_godot {

/// The limits of the playback delay as properties of Self, a registered class, which has `void limits_changed()` and
/// calls bind_playback_properties() in its _bind_methods().
template <class Self>
class PlaybackProperties {
public:
	void set_min_delay(double seconds) {
		ERR_FAIL_COND_MSG(!is_duration(seconds), godot::vformat("%s: min_delay is %f, but must be at least 0 seconds.", Self::get_class_static(), seconds));
		_min_delay = seconds;
		static_cast<Self *>(this)->limits_changed();
	}
	double get_min_delay() const { return _min_delay; }

	void set_jitter_allowance(double seconds) {
		ERR_FAIL_COND_MSG(!is_duration(seconds), godot::vformat("%s: jitter_allowance is %f, but must be at least 0 seconds.", Self::get_class_static(), seconds));
		_jitter_allowance = seconds;
		static_cast<Self *>(this)->limits_changed();
	}
	double get_jitter_allowance() const { return _jitter_allowance; }

protected:
	static void bind_playback_properties() {
		using godot::ClassDB;
		using godot::D_METHOD;
		using godot::PROPERTY_HINT_RANGE;
		using godot::PropertyInfo;
		using godot::Variant;
		void (Self::*set_min)(double) = &Self::set_min_delay;
		double (Self::*get_min)() const = &Self::get_min_delay;
		void (Self::*set_jitter)(double) = &Self::set_jitter_allowance;
		double (Self::*get_jitter)() const = &Self::get_jitter_allowance;
		ClassDB::bind_method(D_METHOD("set_min_delay", "seconds"), set_min);
		ClassDB::bind_method(D_METHOD("get_min_delay"), get_min);
		ClassDB::add_property(Self::get_class_static(), PropertyInfo(Variant::FLOAT, "min_delay", PROPERTY_HINT_RANGE, "0,1,0.01,or_greater,suffix:s"), "set_min_delay", "get_min_delay");
		ClassDB::bind_method(D_METHOD("set_jitter_allowance", "seconds"), set_jitter);
		ClassDB::bind_method(D_METHOD("get_jitter_allowance"), get_jitter);
		ClassDB::add_property(Self::get_class_static(), PropertyInfo(Variant::FLOAT, "jitter_allowance", PROPERTY_HINT_RANGE, "0,1,0.01,or_greater,suffix:s"), "set_jitter_allowance", "get_jitter_allowance");
	}

private:
	static bool is_duration(double value) { return std::isfinite(value) && value >= 0.0; }

	double _min_delay = 0.0;
	double _jitter_allowance = 0.2;
};

} // namespace ga_godot
