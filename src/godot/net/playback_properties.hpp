#pragma once

#include "godot/bind_property.hpp"
#include "godot/net/range_message.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace ga_godot {

/// The limits of the playback delay as properties of Self, a registered class, which has `void limits_changed()` and
/// calls bind_playback_properties() in its _bind_methods().
template <class Self>
class PlaybackProperties {
public:
	void set_min_delay(double seconds) { set_duration(_min_delay, seconds, "min_delay"); }
	double get_min_delay() const { return _min_delay; }
	void set_jitter_allowance(double seconds) { set_duration(_jitter_allowance, seconds, "jitter_allowance"); }
	double get_jitter_allowance() const { return _jitter_allowance; }

protected:
	static void bind_playback_properties() {
		using godot::PROPERTY_HINT_RANGE;
		using godot::PropertyInfo;
		using godot::Variant;
		bind_property("seconds", Self::template guarded<&Self::set_min_delay>(), Self::template guarded<&Self::get_min_delay>(), PropertyInfo(Variant::FLOAT, "min_delay", PROPERTY_HINT_RANGE, "0,1,0.01,or_greater,suffix:s"));
		bind_property("seconds", Self::template guarded<&Self::set_jitter_allowance>(), Self::template guarded<&Self::get_jitter_allowance>(), PropertyInfo(Variant::FLOAT, "jitter_allowance", PROPERTY_HINT_RANGE, "0,1,0.01,or_greater,suffix:s"));
	}

private:
	void set_duration(double &limit, double seconds, const char *name) {
		ERR_FAIL_COND_MSG(!net::DELAY_RANGE.contains(seconds), range_message(Self::get_class_static(), name, seconds, net::DELAY_RANGE, "seconds"));
		limit = seconds;
		static_cast<Self *>(this)->limits_changed();
	}

	double _min_delay = 0.0;
	double _jitter_allowance = 0.2;
};

} // namespace ga_godot
