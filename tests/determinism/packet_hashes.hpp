#pragma once

#include "net/endpoint/receiver.hpp"
#include "net/endpoint/sender.hpp"
#include "net/pose_codec.hpp"

#include <cstdint>
#include <cstring>
#include <vector>

// Hashes of all packets that fixed motion leads to. They are the same on all machines, with all compilers and options. The motion
// is made without functions of the C library, which differ.

namespace determinism {

/// FNV-1a.
class Hash {
public:
	void add(const uint8_t *bytes, size_t size) {
		for (size_t i = 0; i < size; ++i) {
			_value = (_value ^ bytes[i]) * 0x100000001b3u;
		}
	}
	[[nodiscard]] uint64_t value() const { return _value; }

private:
	uint64_t _value = 0xcbf29ce484222325u;
};

/// Pseudorandom numbers from -1 to 1.
class Noise {
public:
	explicit Noise(uint64_t seed) :
			_state(seed * 0x9e3779b97f4a7c15u + 1) {}

	double next() {
		_state ^= _state << 13;
		_state ^= _state >> 7;
		_state ^= _state << 17;
		return double(int64_t(_state >> 11)) / double(int64_t(1) << 52) - 1.0;
	}
	cga::Vector3<double> next_vector() {
		const double x = next();
		const double y = next();
		return { x, y, next() };
	}

private:
	uint64_t _state;
};

/// A body whose speed and spin change at random, and at times jump.
class Walk {
public:
	explicit Walk(uint64_t seed) :
			_noise(seed), _roughness(double(seed % 4) * 0.3) {}

	const cga::Pose<double> &step() {
		if (_noise.next() > 0.98) {
			_speed = _noise.next_vector() * 0.05;
			_spin = _noise.next_vector() * 0.1;
			_growth = _noise.next() > 0.5 ? 1.0 + 0.01 * _noise.next() : 1.0;
			_rests = _noise.next() > 0.6;
		}
		if (!_rests) {
			_speed = _speed * 0.99 + _noise.next_vector() * (0.002 * _roughness);
			_spin = _spin * 0.99 + _noise.next_vector() * (0.01 * _roughness);
			_pose.translation += _speed;
			_pose.rotation = glm::normalize(_pose.rotation * net::exp_rotation(_spin));
			_pose.scale = std::min(std::max(_pose.scale * _growth, 0.1), 10.0);
		}
		return _pose;
	}
	[[nodiscard]] const cga::Pose<double> &pose() const { return _pose; }

private:
	Noise _noise;
	double _roughness;
	cga::Pose<double> _pose;
	cga::Vector3<double> _speed{ 0.0 };
	cga::Vector3<double> _spin{ 0.0 };
	double _growth = 1.0;
	bool _rests = false;
};

/// Windows of all coarsenesses of 40 bodies of several priorities, and a snapshot after each.
inline uint64_t coarse_hash() {
	net::StreamEncoder encoder(0.005f, 1.0f, cga::Mode::SEPARATE);
	std::vector<Walk> bodies;
	for (uint32_t i = 0; i < 40; ++i) {
		bodies.emplace_back(i + 1);
		(void)encoder.add_body(i, 0.0, bodies.back().pose());
		(void)encoder.set_priority(i, int(i % 4));
	}
	encoder.start_at(0.0);
	std::vector<uint8_t> bytes;
	constexpr int TICKS = 5;
	for (int window = 0; window < 120; ++window) {
		for (int tick = 1; tick <= TICKS; ++tick) {
			for (uint32_t i = 0; i < bodies.size(); ++i) {
				(void)encoder.observe(i, window * TICKS + tick, bodies[i].step());
			}
		}
		encoder.set_coarseness(window / 3 % (net::BodyState::MAX_COARSENESS + 1));
		encoder.encode_window(window * TICKS, TICKS, bytes);
		encoder.encode_snapshot(bytes);
	}
	Hash hash;
	hash.add(bytes.data(), bytes.size());
	return hash.value();
}

/// 20 s of a sender of 40 bodies and two receivers, who lose every tenth packet; bodies teleport, are added and removed.
inline uint64_t sender_hash(cga::Mode mode, bool planar, double tolerance, double tick) {
	net::StreamSettings settings;
	settings.mode = mode;
	settings.tick = tick;
	settings.position_tolerance = tolerance;
	net::Sender sender(settings);
	net::Receiver receivers[2];
	std::vector<Walk> bodies;
	Noise chance(7);
	Hash hash;
	std::vector<uint8_t> ack;
	for (uint32_t i = 0; i < 40; ++i) {
		bodies.emplace_back(i + 1);
		(void)sender.add_body(i, bodies.back().pose(), planar);
	}
	sender.add_receiver(0, 0.0);
	for (int number = 0; number < int(20.0 / tick); ++number) {
		const double now = number * tick;
		if (number == 100) {
			sender.add_receiver(1, now);
		}
		for (uint32_t i = 0; i < bodies.size(); ++i) {
			const double event = chance.next();
			if (event > 0.999) {
				(void)sender.remove_body(i, event > 0.9995);
			} else if (event < -0.995) {
				(void)sender.add_body(i, bodies[i].pose(), planar, now);
			} else if (event > 0.997) {
				(void)sender.teleport(i);
			}
			// Some poses are observed late.
			(void)sender.observe(i, now - (event > 0.9 ? 0.3 * tick : 0.0), bodies[i].step());
		}
		sender.flush(now);
		for (const net::OutgoingPacket &packet : sender.packets()) {
			hash.add(sender.bytes() + packet.begin, packet.size);
			if (chance.next() < 0.8) {
				(void)receivers[packet.receiver].accept(sender.bytes() + packet.begin, packet.size, now);
			}
		}
		for (uint32_t id = 0; id < 2; ++id) {
			receivers[id].advance(now);
			receivers[id].take_ack(ack, now);
			hash.add(ack.data(), ack.size());
			if (!ack.empty() && chance.next() < 0.8) {
				(void)sender.accept(id, ack.data(), ack.size(), now);
			}
		}
	}
	return hash.value();
}

/// Packets of MotorCodec.
inline uint64_t codec_hash() {
	Hash hash;
	std::vector<Walk> bodies;
	bodies.reserve(200);
	for (uint32_t i = 0; i < 200; ++i) {
		bodies.emplace_back(i + 1);
	}
	std::vector<net::BodyPose> poses(bodies.size());
	std::vector<uint8_t> packet;
	for (int number = 0; number < 300; ++number) {
		for (size_t i = 0; i < bodies.size(); ++i) {
			poses[i] = { uint32_t(i), cga::pose_cast<float>(bodies[i].step()) };
		}
		net::Tolerance tolerance;
		tolerance.position = 0.0005f * float(1 + number % 7);
		tolerance.rotation = 0.01f * float(1 + number % 11);
		(void)net::encode(poses.data(), poses.size(), tolerance, packet);
		hash.add(packet.data(), packet.size());
	}
	return hash.value();
}

/// The bits of the functions that replace those of the C library.
inline uint64_t function_hash() {
	Hash hash;
	Noise noise(3);
	const auto add = [&hash](const double *values, size_t count) {
		for (size_t i = 0; i < count; ++i) {
			uint8_t bytes[sizeof(double)];
			std::memcpy(bytes, values + i, sizeof(bytes));
			hash.add(bytes, sizeof(bytes));
		}
	};
	for (int i = 0; i < 20000; ++i) {
		const cga::Quaternion<double> rotation = net::exp_rotation(noise.next_vector() * 3.0);
		const cga::Vector3<double> vector = net::log_rotation(rotation);
		double jacobian[9];
		net::right_jacobian(noise.next_vector() * 3.0, jacobian);
		const double scale = net::portable_exp2(noise.next() * 16.0);
		const double numbers[] = { vector.x, vector.y, vector.z, scale, net::portable_log2(scale * (1.0 + 0.1 * noise.next())) };
		add(numbers, 5);
		add(jacobian, 9);
	}
	return hash.value();
}

struct Result {
	const char *name;
	uint64_t expected;
	uint64_t actual;
};

/// All hashes. If the wire format or the encoder's choices change on purpose, replace the expected ones: tests/determinism/run.py
/// prints the actual.
inline std::vector<Result> results() {
	using cga::Mode;
	return {
		{ "separate", 0xba7ff542e0641e74, sender_hash(Mode::SEPARATE, false, 0.005, 1.0 / 60.0) },
		{ "separate, fine", 0xb9a0f4ebff5ea7f5, sender_hash(Mode::SEPARATE, false, 0.0002, 1.0 / 120.0) },
		{ "separate, planar", 0xe2f48d70e567c251, sender_hash(Mode::SEPARATE, true, 0.005, 1.0 / 60.0) },
		{ "screw", 0x2d3e53ab624a80ca, sender_hash(Mode::SCREW, false, 0.005, 1.0 / 60.0) },
		{ "linear", 0x6b079bd5865d88d7, sender_hash(Mode::LINEAR, false, 0.005, 1.0 / 30.0) },
		{ "coarse", 0x81f759a84940322f, coarse_hash() },
		{ "codec", 0x9a9356e110b3609d, codec_hash() },
		{ "functions", 0x3b73c8864ba73070, function_hash() },
	};
}

} // namespace determinism
