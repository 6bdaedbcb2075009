// A sender and a receiver on a link that loses, delays, reorders, duplicates and holds datagrams. Everything that the receiver
// shows is within the tolerance, memory and bytes are bounded, and on a good link the receiver soon has all bodies.

#include "../../harness/simulated_link.hpp"
#include "live_bytes.hpp"
#include "moving_bodies.hpp"

namespace {

using fuzz::Bytes;
using fuzz::Input;
using fuzz::require;
using fuzz::TICK;

constexpr size_t MAX_MEMORY = 8000000;

harness::LinkSettings link_settings(Input &input) {
	harness::LinkSettings settings;
	settings.delay = input.between(0.0, 0.4);
	settings.jitter = input.flag() ? input.between(0.0, 0.2) : 0.0;
	settings.loss = input.flag() ? input.between(0.0, 0.6) : 0.0;
	settings.duplication = input.flag() ? input.between(0.0, 0.5) : 0.0;
	settings.burst = input.flag() ? input.between(1.0, 20.0) : 0.0;
	settings.bytes_per_second = input.flag() ? input.between(2000.0, 50000.0) : 0.0;
	return settings;
}

net::StreamSettings stream_settings(Input &input) {
	net::StreamSettings settings;
	if (input.flag()) {
		settings.position_tolerance = std::pow(10.0, input.between(-4.0, 0.0));
		settings.rotation_tolerance = std::pow(10.0, input.between(-1.5, 1.5));
		settings.max_latency = input.between(0.0, 1.0);
		settings.send_rate = input.between(1.0, 60.0);
		settings.mode = cga::Mode(input.byte() % 3);
		settings.max_packet_size = 256 + input.below(1024);
	}
	return settings.is_valid() ? settings : net::StreamSettings();
}

class Channel {
public:
	explicit Channel(Input &input) :
			_input(input), _settings(stream_settings(input)), _sender(_settings), _receiver(64), _forward(link_settings(input), input.bits(4)), _backward(link_settings(input), input.bits(4)) {
		_sender.add_receiver(1, 0.0);
	}

	void step(int64_t tick) {
		const double now = double(tick) * TICK;
		_bodies.step(_sender, tick, _input);
		_sender.flush(now);
		size_t total = 0;
		for (const net::OutgoingPacket &packet : _sender.packets()) {
			require(packet.size <= _settings.max_packet_size, "a packet is larger than max_packet_size");
			total += packet.size;
			_forward.send(now, _sender.bytes() + packet.begin, packet.size);
		}
		require(total < 200000, "the sender sends 200,000 bytes or more in a tick");
		while (const auto arrived = _forward.receive(now)) {
			require(_receiver.accept(arrived->bytes.data(), arrived->bytes.size(), now).has_value(), "the receiver rejects a packet");
		}
		_receiver.take_ack(_ack, now);
		if (!_ack.empty()) {
			_backward.send(now, _ack.data(), _ack.size());
		}
		while (const auto arrived = _backward.receive(now)) {
			require(_sender.accept(1, arrived->bytes.data(), arrived->bytes.size(), now).has_value(), "the sender rejects an acknowledgement");
		}
		_receiver.advance(now);
		_bodies.check(_receiver, _sender.statistics(1).relaxation);
	}

	/// Replaces both directions' settings.
	void set_links(const harness::LinkSettings &settings) {
		_forward.settings() = settings;
		_backward.settings() = settings;
	}
	[[nodiscard]] bool is_complete() const { return _receiver.is_ready() && _bodies.is_complete(_receiver); }

private:
	Input &_input;
	net::StreamSettings _settings;
	net::Sender _sender;
	net::Receiver _receiver;
	harness::SimulatedLink _forward;
	harness::SimulatedLink _backward;
	fuzz::MovingBodies _bodies;
	Bytes _ack;
};

} // namespace

void fuzz::run(Input input) {
	const size_t before = live_bytes();
	Channel channel(input);
	int64_t tick = 0;
	for (; !input.is_empty() && tick < 600; ++tick) {
		if (input.byte() == 255) {
			channel.set_links(link_settings(input));
		}
		channel.step(tick);
		require(live_bytes() < before + MAX_MEMORY, "sender, receiver and link use 8 MB or more");
	}
	channel.set_links({});
	for (const int64_t end = tick + 240; tick < end && !channel.is_complete(); ++tick) {
		channel.step(tick);
	}
	require(channel.is_complete(), "the receiver lacks a body four seconds after the link became good");
}
