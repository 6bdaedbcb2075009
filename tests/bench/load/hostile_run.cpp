#include "hostile_run.hpp"

#include "../cpu_clock.hpp"
#include "session_end.hpp"

#include <algorithm>
#include <deque>
#include <map>

namespace bench {

namespace {

constexpr net::PeerId SERVER = 1;
constexpr double DELAY = 0.025; // seconds, each way
constexpr double WARM_UP = 3.0; // seconds
constexpr size_t CLIENT_BODIES = 20;
constexpr double AMPLIFICATION_SECONDS = 10.0;
const double TICK = net::StreamSettings().tick;

class HostileRun {
public:
	explicit HostileRun(const HostileScenario &scenario) :
			_scenario(scenario), _scene(scenario.bodies + scenario.clients * CLIENT_BODIES + 1, 1.0, scenario.seed), _peer(scenario.attack, scenario.seed) {
		size_t next = 0;
		const auto add = [&](size_t count) {
			const net::PeerId id = net::PeerId(_peers.size() + 1);
			_peers.push_back(id);
			_owned.push_back({ id, next, next + count });
			next += count;
		};
		add(scenario.bodies);
		for (size_t i = 0; i < scenario.clients; ++i) {
			add(CLIENT_BODIES);
		}
		add(1);
		for (size_t i = 0; i <= scenario.clients; ++i) {
			_ends.emplace_back(_peers[i], net::StreamSettings());
			_ends.back().connect(_peers, _owned);
		}
	}

	[[nodiscard]] net::PeerId hostile() const { return _peers.back(); }
	[[nodiscard]] SessionEnd &server() { return _ends.front(); }
	[[nodiscard]] HostilePeer &peer() { return _peer; }
	[[nodiscard]] uint64_t hostile_bytes() const { return _bytes.count(hostile()) != 0 ? _bytes.at(hostile()) : 0; }
	[[nodiscard]] double now() const { return _now; }
	void inject(std::vector<uint8_t> packet) { server().deliver(hostile(), std::move(packet)); }

	void step() {
		++_steps;
		_now = double(_steps) * TICK;
		for (auto &[ends, link] : _links) {
			while (const std::optional<harness::Delivery> packet = link.receive(_now)) {
				_ends[size_t(ends.second) - 1].deliver(ends.first, packet->bytes);
			}
		}
		for (SessionEnd &end : _ends) {
			end.step(_now, _scene);
			send(end);
		}
	}

	void measure() {
		for (SessionEnd &client : _ends) {
			if (client.id() != SERVER) {
				client.measure(_scene, _owned[0], _now, server().media_begin());
				server().measure(_scene, _owned[size_t(client.id()) - 1], _now, client.media_begin());
			}
		}
	}

	void begin_phase() {
		_bytes.clear();
		for (SessionEnd &end : _ends) {
			end.reset_measures();
		}
	}

	HostilePhase finish_phase(double seconds) {
		HostilePhase phase;
		phase.frame = server().meter().seconds() / (seconds / TICK);
		phase.frame_max = server().frames().max();
		phase.memory = server().meter().take_peak();
		Histogram errors = server().errors();
		Histogram delays = server().delays();
		for (SessionEnd &client : _ends) {
			if (client.id() == SERVER) {
				continue;
			}
			errors.add(client.errors());
			delays.add(client.delays());
			phase.longest_stall = std::max({ phase.longest_stall, client.playback(SERVER).longest_stall(), server().playback(client.id()).longest_stall() });
			phase.client_bytes_per_second += double(_bytes[client.id()]) / seconds / double(_scenario.clients);
		}
		phase.error_p99 = errors.percentile(0.99);
		phase.delay_median = delays.percentile(0.5);
		phase.hostile_bytes_per_second = double(hostile_bytes()) / seconds;
		return phase;
	}

private:
	void send(SessionEnd &from) {
		from.session().outbox().drain([&](const net::Outbox::Packet &packet, const uint8_t *bytes) {
			_bytes[packet.peer] += from.id() == SERVER ? packet.size : 0;
			if (packet.peer != hostile()) {
				const auto link = _links.try_emplace({ from.id(), packet.peer }, harness::LinkSettings{ DELAY }, 1);
				link.first->second.send(_now, bytes, packet.size);
			} else if (from.id() == SERVER) {
				_peer.hear(bytes, packet.size);
			}
		});
	}

	HostileScenario _scenario;
	LoadScene _scene;
	HostilePeer _peer;
	std::vector<net::PeerId> _peers;
	std::vector<OwnedBodies> _owned; // by peer
	std::deque<SessionEnd> _ends; // the server and the honest clients
	std::map<std::pair<net::PeerId, net::PeerId>, harness::SimulatedLink> _links; // from, to
	std::map<net::PeerId, uint64_t> _bytes; // from the server to each peer in this phase
	uint64_t _steps = 0;
	double _now = 0.0;
};

} // namespace

HostileResult run_hostile(const HostileScenario &scenario) {
	HostileResult result;
	HostileRun run(scenario);
	run.inject(run.peer().open());
	while (run.now() < WARM_UP) {
		run.step();
	}
	run.begin_phase();
	// Making the packets takes the same part of the processor's caches in both phases.
	HostilePeer unheard(scenario.attack, scenario.seed);
	double due = 0.0;
	for (double end = run.now() + scenario.seconds; run.now() < end;) {
		std::vector<std::vector<uint8_t>> unsent;
		for (due += scenario.packets_per_second * TICK; due >= 1.0; due -= 1.0) {
			unsent.push_back(unheard.next());
		}
		run.step();
		run.measure();
	}
	result.before = run.finish_phase(scenario.seconds);
	run.begin_phase();
	const uint64_t rejected = run.server().rejected(run.hostile(), run.now());
	const double begin = run.now();
	const double cpu_begin = cpu_seconds();
	due = 0.0;
	while (run.now() < begin + scenario.seconds && !result.is_cut) {
		for (due += scenario.packets_per_second * TICK; due >= 1.0; due -= 1.0) {
			std::vector<uint8_t> packet = run.peer().next();
			++result.packets;
			result.bytes += packet.size();
			run.inject(std::move(packet));
		}
		run.step();
		run.measure();
		result.is_cut = cpu_seconds() - cpu_begin > scenario.cpu_limit || run.server().meter().live() > scenario.memory_limit;
	}
	result.seconds = run.now() - begin;
	result.during = run.finish_phase(result.seconds);
	result.rejected = run.server().rejected(run.hostile(), run.now()) - rejected;
	return result;
}

Amplification measure_amplification(size_t bodies, size_t requests, double interval) {
	HostileScenario scenario;
	scenario.attack = Attack::OPENS;
	scenario.bodies = bodies;
	scenario.clients = 0;
	HostileRun run(scenario);
	Amplification result;
	for (size_t sent = 0; run.now() < AMPLIFICATION_SECONDS; run.step()) {
		for (; sent < requests && double(sent) * interval <= run.now(); ++sent) {
			std::vector<uint8_t> packet = run.peer().next();
			result.bytes_in += packet.size();
			run.inject(std::move(packet));
		}
		result.bytes_out = run.hostile_bytes();
		result.ratio = std::max(result.ratio, double(result.bytes_out) / double(result.bytes_in));
	}
	return result;
}

} // namespace bench
