#pragma once

#include "godot/algebra/conversions.hpp"
#include "godot/bind_property.hpp"
#include "godot/motion/multivector_lerp.hpp"
#include "godot/net/range_message.hpp"
#include "net/stream/stream_settings.hpp"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace ga_godot {

/// The settings of a stream as properties of Self, a registered class, which has `void settings_changed()` and calls
/// bind_stream_properties() in its _bind_methods(). An invalid value is an error and changes nothing.
template <class Self>
class StreamProperties {
public:
	void set_position_tolerance(double meters) { set_number(&net::StreamSettings::position_tolerance, meters, net::POSITION_TOLERANCE_RANGE, "position_tolerance", "meters"); }
	double get_position_tolerance() const { return _settings.position_tolerance; }
	void set_rotation_tolerance(double degrees) { set_number(&net::StreamSettings::rotation_tolerance, degrees, net::ROTATION_TOLERANCE_RANGE, "rotation_tolerance", "degrees"); }
	double get_rotation_tolerance() const { return _settings.rotation_tolerance; }
	void set_max_latency(double seconds) { set_number(&net::StreamSettings::max_latency, seconds, net::MAX_LATENCY_RANGE, "max_latency", "seconds"); }
	double get_max_latency() const { return _settings.max_latency; }
	void set_send_rate(double hertz) { set_number(&net::StreamSettings::send_rate, hertz, net::SEND_RATE_RANGE, "send_rate", "Hz"); }
	double get_send_rate() const { return _settings.send_rate; }

	void set_mode(MultivectorLerp::Mode mode) {
		ERR_FAIL_COND_MSG(!is_mode(mode), godot::vformat("%s: mode is %d, but must be LINEAR (0), SCREW (1) or SEPARATE (2).", Self::get_class_static(), int64_t(mode)));
		change(_settings.mode, cga::Mode(mode));
	}
	MultivectorLerp::Mode get_mode() const { return MultivectorLerp::Mode(_settings.mode); }

	void set_max_packet_size(int64_t bytes) {
		ERR_FAIL_COND_MSG(!net::PACKET_SIZE_RANGE.contains(double(bytes)), range_message(Self::get_class_static(), "max_packet_size", double(bytes), net::PACKET_SIZE_RANGE, "bytes"));
		change(_settings.max_packet_size, size_t(bytes));
	}
	int64_t get_max_packet_size() const { return int64_t(_settings.max_packet_size); }

protected:
	StreamProperties() { _settings.max_latency = 0.1; }

	static void bind_stream_properties() {
		using godot::PROPERTY_HINT_ENUM;
		using godot::PROPERTY_HINT_RANGE;
		using godot::PropertyInfo;
		using godot::Variant;
		bind_property("meters", Self::template guarded<&Self::set_position_tolerance>(), Self::template guarded<&Self::get_position_tolerance>(), PropertyInfo(Variant::FLOAT, "position_tolerance", PROPERTY_HINT_RANGE, "0.0001,0.1,0.0001,or_greater,suffix:m"));
		bind_property("degrees", Self::template guarded<&Self::set_rotation_tolerance>(), Self::template guarded<&Self::get_rotation_tolerance>(), PropertyInfo(Variant::FLOAT, "rotation_tolerance", PROPERTY_HINT_RANGE, "0.01,10,0.01,or_greater,suffix:°"));
		bind_property("seconds", Self::template guarded<&Self::set_max_latency>(), Self::template guarded<&Self::get_max_latency>(), PropertyInfo(Variant::FLOAT, "max_latency", PROPERTY_HINT_RANGE, "0.02,1,0.01,or_greater,suffix:s"));
		bind_property("hertz", Self::template guarded<&Self::set_send_rate>(), Self::template guarded<&Self::get_send_rate>(), PropertyInfo(Variant::FLOAT, "send_rate", PROPERTY_HINT_RANGE, "1,60,1,or_greater,suffix:Hz"));
		bind_property("mode", Self::template guarded<&Self::set_mode>(), Self::template guarded<&Self::get_mode>(), PropertyInfo(Variant::INT, "mode", PROPERTY_HINT_ENUM, "Linear,Screw,Separate"));
		bind_property("bytes", Self::template guarded<&Self::set_max_packet_size>(), Self::template guarded<&Self::get_max_packet_size>(), PropertyInfo(Variant::INT, "max_packet_size", PROPERTY_HINT_RANGE, "256,1500,1,or_greater,suffix:B"));
	}

	net::StreamSettings _settings;

	template <class T>
	void change(T &setting, T value) {
		if (setting != value) {
			setting = value;
			static_cast<Self *>(this)->settings_changed();
		}
	}

	void set_number(double net::StreamSettings::*setting, double value, const net::SettingRange &range, const char *name, const char *unit) {
		ERR_FAIL_COND_MSG(!range.contains(value), range_message(Self::get_class_static(), name, value, range, unit));
		net::StreamSettings next = _settings;
		next.*setting = value;
		ERR_FAIL_COND_MSG(!next.is_valid(), godot::vformat("%s: max_latency would be %s seconds, or %s ticks, but must be at most %s ticks.", Self::get_class_static(), short_number(next.max_latency), short_number(next.max_latency / next.tick), short_number(net::MAX_LATENCY_TICKS)));
		change(_settings.*setting, value);
	}
};

} // namespace ga_godot
