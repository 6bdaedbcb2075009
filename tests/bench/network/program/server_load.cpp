#include "server_load.hpp"

#include "../../../harness/simulated_link.hpp"
#include "../../cpu_clock.hpp"

#include "net/endpoint/receiver.hpp"
#include "net/endpoint/sender.hpp"

#include <cmath>
#include <deque>
#include <vector>

namespace bench {

namespace {

constexpr double WARM_UP = 2.0; // seconds
constexpr double NOISE = 0.0005; // amplitude in meters

// The path of a body: a sine along each axis, and a rotation at constant speed.
class Lissajous {
public:
	explicit Lissajous(harness::RandomBits &random) {
		for (int axis = 0; axis < 3; ++axis) {
			_center[axis] = random.between(-50.0, 50.0);
			_amplitude[axis] = random.between(0.5, 3.0);
			_frequency[axis] = random.between(0.6, 2.5);
			_phase[axis] = random.between(0.0, 6.28);
			_axis[axis] = random.between(-1.0, 1.0);
		}
		_axis = glm::normalize(_axis + glm::dvec3(0.0, 1e-3, 0.0));
		_angular_speed = random.between(0.5, 3.0);
	}

	[[nodiscard]] cga::Pose<double> at(double time, harness::RandomBits &random) const {
		cga::Pose<double> pose;
		for (int axis = 0; axis < 3; ++axis) {
			pose.translation[axis] = _center[axis] + _amplitude[axis] * std::sin(_frequency[axis] * time + _phase[axis]) + random.between(-NOISE, NOISE);
		}
		pose.rotation = glm::angleAxis(_angular_speed * time, _axis);
		return pose;
	}

private:
	glm::dvec3 _center{}, _amplitude{}, _frequency{}, _phase{}, _axis{};
	double _angular_speed = 0.0;
};

struct Client {
	Client(const harness::LinkSettings &link, uint64_t seed) :
			down(link, seed), up(link, ~seed) {}

	net::Receiver receiver;
	harness::SimulatedLink down;
	harness::SimulatedLink up;
};

class ServerRun {
public:
	ServerRun(const ServerLoadSettings &load, const net::StreamSettings &stream, uint64_t seed) :
			_load(load), _random(seed), _sender(stream) {
		for (size_t i = 0; i < load.bodies; ++i) {
			_paths.emplace_back(_random);
			_poses.push_back(_paths.back().at(0.0, _random));
			_sender.add_body(uint32_t(i), _poses.back());
		}
		for (size_t i = 0; i < load.receivers; ++i) {
			_clients.emplace_back(load.link, seed + 1 + i);
			_sender.add_receiver(uint32_t(i), 0.0);
		}
		_acks.resize(load.receivers);
	}

	void step(double time, bool is_measured) {
		for (size_t i = 0; i < _paths.size(); ++i) {
			_poses[i] = _paths[i].at(time, _random);
		}
		for (size_t i = 0; i < _clients.size(); ++i) {
			_acks[i].clear();
			while (std::optional<harness::Delivery> delivery = _clients[i].up.receive(time)) {
				_acks[i].push_back(std::move(delivery->bytes));
			}
		}
		const double begin = cpu_seconds();
		serve(time);
		if (is_measured) {
			_seconds += cpu_seconds() - begin;
			_packets += _sender.packets().size();
		}
		for (const net::OutgoingPacket &packet : _sender.packets()) {
			_bytes += is_measured ? packet.size : 0;
			_clients[packet.receiver].down.send(time, _sender.bytes() + packet.begin, packet.size);
		}
		for (Client &client : _clients) {
			receive(client, time);
		}
	}

	[[nodiscard]] ServerLoad result() {
		for (const Client &client : _clients) {
			for (size_t i = 0; i < _load.bodies && _problem.empty(); ++i) {
				_problem = client.receiver.pose(uint32_t(i)) ? "" : "a receiver does not show body " + std::to_string(i);
			}
		}
		return { _seconds / _load.seconds, double(_bytes) / _load.seconds, double(_packets) / _load.seconds, _problem };
	}

private:
	// The measured part.
	void serve(double time) {
		for (size_t i = 0; i < _acks.size(); ++i) {
			for (const std::vector<uint8_t> &ack : _acks[i]) {
				note(_sender.accept(uint32_t(i), ack.data(), ack.size(), time));
			}
		}
		for (size_t i = 0; i < _poses.size(); ++i) {
			if (!_sender.observe(uint32_t(i), time, _poses[i])) {
				note_problem("the sender rejected a pose");
			}
		}
		_sender.flush(time);
	}

	void receive(Client &client, double time) {
		while (const std::optional<harness::Delivery> delivery = client.down.receive(time)) {
			note(client.receiver.accept(delivery->bytes.data(), delivery->bytes.size(), time));
		}
		client.receiver.advance(time);
		client.receiver.take_ack(_ack, time);
		if (!_ack.empty()) {
			client.up.send(time, _ack.data(), _ack.size());
		}
	}

	void note(const net::PacketResult &result) {
		if (!result) {
			note_problem(net::describe(result.error()));
		}
	}

	void note_problem(const char *problem) {
		if (_problem.empty()) {
			_problem = problem;
		}
	}

	ServerLoadSettings _load;
	harness::RandomBits _random;
	net::Sender _sender;
	std::vector<Lissajous> _paths;
	std::vector<cga::Pose<double>> _poses;
	std::deque<Client> _clients;
	std::vector<std::vector<std::vector<uint8_t>>> _acks; // that have arrived, by receiver
	std::vector<uint8_t> _ack;
	double _seconds = 0.0;
	uint64_t _bytes = 0;
	uint64_t _packets = 0;
	std::string _problem;
};

} // namespace

ServerLoad measure_server_load(const ServerLoadSettings &load, const net::StreamSettings &stream, uint64_t seed) {
	ServerRun run(load, stream, seed);
	const uint64_t warm_up = uint64_t(WARM_UP * load.observe_rate);
	const uint64_t steps = warm_up + uint64_t(load.seconds * load.observe_rate);
	for (uint64_t step = 0; step < steps; ++step) {
		run.step(double(step) / load.observe_rate, step >= warm_up);
	}
	return run.result();
}

} // namespace bench
