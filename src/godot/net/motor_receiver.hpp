#pragma once

#include "godot/net/playback_properties.hpp"
#include "net/endpoint/receiver.hpp"

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace ga_godot {

/// The receiving half of MotorSynchronizer, for any transport; doc_classes/MotorReceiver.xml documents it.
class MotorReceiver : public godot::RefCounted, public PlaybackProperties<MotorReceiver> {
	GDCLASS(MotorReceiver, godot::RefCounted)
	friend class PlaybackProperties<MotorReceiver>;

public:
	MotorReceiver();

	void set_most_bodies(int64_t p_count);
	int64_t get_most_bodies() const;

	godot::String accept(const godot::PackedByteArray &p_packet, double p_now);
	godot::PackedByteArray take_ack(double p_now);
	bool is_ready() const;
	void advance(double p_now);

	godot::Transform3D get_transform(int64_t p_id) const;
	bool has_body(int64_t p_id) const;
	godot::PackedInt32Array get_bodies() const;
	double get_media_time() const;
	double get_known_time() const;
	void clear();
	godot::Dictionary get_statistics() const;

protected:
	static void _bind_methods();

private:
	void limits_changed();

	std::unique_ptr<net::Receiver> _receiver;
	int64_t _max_bodies = 65536;
	// Kept between calls, so that a steady stream allocates only what it returns.
	std::vector<uint8_t> _answer;
	std::vector<net::BodyEvent> _events;
};

} // namespace ga_godot
