#pragma once

#include "godot/net/playback_properties.hpp"
#include "godot/thread_guard.hpp"
#include "net/endpoint/receiver.hpp"

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace ga_godot {

/// The receiving half of MotorSynchronizer, for any transport; doc_classes/MotorReceiver.xml documents it.
class MotorReceiver : public godot::RefCounted, public PlaybackProperties<MotorReceiver>, public OneThread<MotorReceiver> {
	GDCLASS(MotorReceiver, godot::RefCounted)
	friend class PlaybackProperties<MotorReceiver>;

public:
	MotorReceiver();

	void set_max_bodies(int64_t count);
	int64_t get_max_bodies() const { return _max_bodies; }

	godot::String accept(const godot::PackedByteArray &packet, double now);
	godot::PackedByteArray take_ack(double now);
	bool is_ready() const { return _receiver.is_ready(); }
	void advance(double now);

	godot::Transform3D get_transform(int64_t id) const;
	bool has_body(int64_t id) const { return find_pose(id).has_value(); }
	godot::PackedInt32Array get_bodies() const;
	double get_media_time() const { return is_ready() ? _receiver.media_time() : 0.0; }
	double get_known_time() const { return is_ready() ? _receiver.known_time() : 0.0; }
	void clear();
	godot::Dictionary get_statistics() const;

protected:
	static void _bind_methods();

private:
	void limits_changed();
	[[nodiscard]] std::optional<cga::Pose<double>> find_pose(int64_t id) const;

	int64_t _max_bodies = 65536;
	net::Receiver _receiver{ size_t(_max_bodies) };
	// Kept between calls, so that a steady stream allocates only what it returns.
	std::vector<uint8_t> _ack;
	std::vector<net::BodyEvent> _taken;
	std::vector<net::BodyEvent> _events; // whose signals advance() has not emitted yet, from _next_event
	size_t _next_event = 0;
	bool _is_emitting = false;
};

} // namespace ga_godot
