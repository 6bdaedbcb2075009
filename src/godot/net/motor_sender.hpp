#pragma once

#include "godot/net/stream_properties.hpp"
#include "godot/thread_guard.hpp"
#include "net/endpoint/sender.hpp"

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <cstdint>

namespace ga_godot {

/// The sending half of MotorSynchronizer, for any transport; doc_classes/MotorSender.xml documents it.
class MotorSender : public godot::RefCounted, public StreamProperties<MotorSender>, public OneThread<MotorSender> {
	GDCLASS(MotorSender, godot::RefCounted)
	friend class StreamProperties<MotorSender>;

public:
	void set_ticks_per_second(double hertz);
	double get_ticks_per_second() const { return 1.0 / _settings.tick; }

	bool add_body(int64_t id, const godot::Transform3D &transform);
	bool remove_body(int64_t id);
	bool has_body(int64_t id) const;
	int64_t get_body_count() const { return int64_t(_sender.body_count()); }
	bool observe(int64_t id, double time, const godot::Transform3D &transform);
	bool teleport(int64_t id);
	bool set_priority(int64_t id, int64_t priority);

	void add_receiver(int64_t receiver, double time);
	void remove_receiver(int64_t receiver);
	bool has_receiver(int64_t receiver) const;

	godot::TypedArray<godot::Dictionary> flush(double time);
	godot::String accept(int64_t receiver, const godot::PackedByteArray &packet, double time);
	godot::Dictionary get_statistics(int64_t receiver) const;
	int64_t get_moving_count() const { return int64_t(_sender.moving_count()); }

protected:
	static void _bind_methods();

private:
	void settings_changed() { _sender.set_settings(_settings); }

	net::Sender _sender{ _settings };
};

} // namespace ga_godot
