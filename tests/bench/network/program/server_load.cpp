#include "server_load.hpp"

#include "../random_bits.hpp"
#include "../simulated_link.hpp"
#include "cpu_clock.hpp"

#include "net/receiver.hpp"
#include "net/sender.hpp"

#include <cmath>
#include <deque>
#include <vector>

namespace bench {

namespace {

constexpr double WARM = 2.0;
constexpr double NOISE = 0.0005; // metres, each way

// Where a body is: three swings of different frequency and a steady turn about an axis of its own.
class Lissajous {
public:
	explicit Lissajous(RandomBits &random) {
		for (int axis = 0; axis < 3; ++axis) {
			centre_[axis] = random.between(-50.0, 50.0);
			size_[axis] = random.between(0.5, 3.0);
			frequency_[axis] = random.between(0.6, 2.5);
			phase_[axis] = random.between(0.0, 6.28);
			axis_[axis] = random.between(-1.0, 1.0);
		}
		axis_ = glm::normalize(axis_ + glm::dvec3(0.0, 1e-3, 0.0));
		turn_ = random.between(0.5, 3.0);
	}

	[[nodiscard]] cga::Pose<double> at(double time, RandomBits &random) const {
		cga::Pose<double> pose;
		for (int axis = 0; axis < 3; ++axis) {
			pose.translation[axis] = centre_[axis] + size_[axis] * std::sin(frequency_[axis] * time + phase_[axis]) + random.between(-NOISE, NOISE);
		}
		pose.rotation = glm::angleAxis(turn_ * time, axis_);
		return pose;
	}

private:
	glm::dvec3 centre_{}, size_{}, frequency_{}, phase_{}, axis_{};
	double turn_ = 0.0;
};

struct Client {
	Client(const LinkSettings &link, std::uint64_t seed) :
			there(link, seed), back(link, ~seed) {}

	net::Receiver receiver;
	SimulatedLink there;
	SimulatedLink back;
};

class ServerRun {
public:
	ServerRun(const ServerLoadSettings &load, const net::StreamSettings &stream, std::uint64_t seed) :
			load_(load), random_(seed), sender_(stream) {
		for (std::size_t i = 0; i < load.bodies; ++i) {
			paths_.emplace_back(random_);
			poses_.push_back(paths_.back().at(0.0, random_));
			sender_.add_body(std::uint32_t(i), poses_.back());
		}
		for (std::size_t i = 0; i < load.receivers; ++i) {
			clients_.emplace_back(load.link, seed + 1 + i);
			sender_.add_receiver(std::uint32_t(i), 0.0);
		}
		answers_.resize(load.receivers);
	}

	void step(double time, bool counts) {
		for (std::size_t i = 0; i < paths_.size(); ++i) {
			poses_[i] = paths_[i].at(time, random_);
		}
		for (std::size_t i = 0; i < clients_.size(); ++i) {
			answers_[i].clear();
			while (clients_[i].back.receive(time, datagram_)) {
				answers_[i].push_back(datagram_);
			}
		}
		const double begin = cpu_seconds();
		serve(time);
		if (counts) {
			seconds_ += cpu_seconds() - begin;
			packets_ += sender_.packets().size();
		}
		for (const net::OutgoingPacket &packet : sender_.packets()) {
			bytes_ += counts ? packet.size : 0;
			clients_[packet.receiver].there.send(time, sender_.bytes() + packet.begin, packet.size);
		}
		for (Client &client : clients_) {
			receive(client, time);
		}
	}

	[[nodiscard]] ServerLoad result() {
		cga::Pose<double> pose;
		for (const Client &client : clients_) {
			for (std::size_t i = 0; i < load_.bodies && problem_.empty(); ++i) {
				problem_ = client.receiver.pose(std::uint32_t(i), pose) ? "" : "a receiver does not show all bodies";
			}
		}
		return { seconds_ / load_.seconds, double(bytes_) / load_.seconds, double(packets_) / load_.seconds, problem_ };
	}

private:
	// What is timed.
	void serve(double time) {
		for (std::size_t i = 0; i < answers_.size(); ++i) {
			for (const SimulatedLink::Bytes &answer : answers_[i]) {
				note(sender_.accept(std::uint32_t(i), answer.data(), answer.size(), time));
			}
		}
		for (std::size_t i = 0; i < poses_.size(); ++i) {
			if (!sender_.observe(std::uint32_t(i), time, poses_[i])) {
				note("a pose was refused");
			}
		}
		sender_.flush(time);
	}

	void receive(Client &client, double time) {
		while (client.there.receive(time, datagram_)) {
			note(client.receiver.accept(datagram_.data(), datagram_.size(), time));
		}
		client.receiver.advance(time);
		if (client.receiver.take_answer(datagram_, time)) {
			client.back.send(time, datagram_.data(), datagram_.size());
		}
	}

	void note(const char *error) {
		if (error != nullptr && problem_.empty()) {
			problem_ = error;
		}
	}

	ServerLoadSettings load_;
	RandomBits random_;
	net::Sender sender_;
	std::vector<Lissajous> paths_;
	std::vector<cga::Pose<double>> poses_;
	std::deque<Client> clients_;
	std::vector<std::vector<SimulatedLink::Bytes>> answers_; // that have arrived, by receiver
	SimulatedLink::Bytes datagram_;
	double seconds_ = 0.0;
	std::uint64_t bytes_ = 0;
	std::uint64_t packets_ = 0;
	std::string problem_;
};

} // namespace

ServerLoad measure_server_load(const ServerLoadSettings &load, const net::StreamSettings &stream, std::uint64_t seed) {
	ServerRun run(load, stream, seed);
	const std::uint64_t warm = std::uint64_t(WARM * load.observe_rate);
	const std::uint64_t steps = warm + std::uint64_t(load.seconds * load.observe_rate);
	for (std::uint64_t step = 0; step < steps; ++step) {
		run.step(double(step) / load.observe_rate, step >= warm);
	}
	return run.result();
}

} // namespace bench
