#include "load_run.hpp"

#include "../cpu_clock.hpp"
#include "load_client.hpp"

#include "net/endpoint/sender.hpp"

#include <algorithm>
#include <deque>
#include <limits>

namespace bench {

namespace {

constexpr double MINUTE = 60.0;
constexpr double MIN_MINUTES = 0.5;
constexpr double NANO = 1e9;

// The peaks of memory in the two halves of the measured time. A cycle of use and release has equal peaks.
struct MemoryPeaks {
	double first = 0.0;
	double second = 0.0;

	// Bytes per minute, for halves that are this long; not a number if they are too short to tell growth from the filling of buffers.
	[[nodiscard]] double growth(double minutes) const {
		return minutes < MIN_MINUTES ? std::numeric_limits<double>::quiet_NaN() : (second - first) / minutes;
	}
};

class LoadRun {
public:
	explicit LoadRun(const LoadScenario &scenario) :
			_scenario(scenario), _scene(scenario.bodies, scenario.moving_share, scenario.seed), _sender(scenario.stream) {
		_sender_meter.begin();
		for (size_t i = 0; i < _scene.size(); ++i) {
			note(_sender.add_body(uint32_t(i), _scene.pose(i, 0.0)));
		}
		_sender_meter.end();
		for (const ReceiverGroup &group : scenario.groups) {
			for (size_t i = 0; i < group.count; ++i) {
				_clients.emplace_back(scenario, group, scenario.seed + 1 + _clients.size());
			}
		}
		_has_joined.resize(_clients.size());
		_acks.resize(_clients.size());
		_early_repeats.resize(_clients.size());
		_receiver_peaks.resize(_clients.size());
	}

	LoadResult run() {
		const double tick = _scenario.stream.tick;
		const size_t ticks = size_t(_scenario.seconds / tick);
		const size_t measured = size_t(_scenario.warm_up / tick);
		const double cpu_begin = cpu_seconds();
		size_t number = 0;
		for (; number <= ticks && !_result.is_cut; ++number) {
			const double time = double(number) * tick;
			if (number == measured) {
				begin_measurement();
			} else if (number == (measured + ticks) / 2) {
				take_peaks(&MemoryPeaks::first);
			}
			serve(time);
			for (size_t i = 0; i < _clients.size(); ++i) {
				if (_has_joined[i]) {
					_clients[i].show_frame(time + 0.5 * tick, _scene, 0.0);
				}
			}
			_result.is_cut = cpu_seconds() - cpu_begin > _scenario.cpu_limit;
		}
		take_peaks(&MemoryPeaks::second);
		_result.seconds = std::max(double(number) * tick - _scenario.warm_up, 0.0);
		return finish();
	}

private:
	void note(bool success) { _result.rejected += success ? 0 : 1; }

	void begin_measurement() {
		_sender_meter.reset_time();
		take_peaks(&MemoryPeaks::first);
		for (size_t i = 0; i < _clients.size(); ++i) {
			_early_repeats[i] = _sender.statistics(uint32_t(i)).chunks_repeated;
		}
		_result.tick_ns_max = 0.0;
	}

	void take_peaks(double MemoryPeaks::*half) {
		_sender_peaks.*half = _sender_meter.take_peak();
		for (size_t i = 0; i < _clients.size(); ++i) {
			_receiver_peaks[i].*half = _clients[i].meter().take_peak();
		}
	}

	// One tick of the sender.
	void serve(double time) {
		for (size_t i = 0; i < _clients.size(); ++i) {
			_acks[i].clear();
			while (std::optional<harness::Delivery> delivery = _clients[i].take_ack(time)) {
				_acks[i].push_back(std::move(delivery->bytes));
			}
		}
		_poses.clear();
		for (size_t i = 0; i < _scene.moving_count(); ++i) {
			_poses.push_back(_scene.pose(i, time));
		}
		const double before = _sender_meter.seconds();
		_sender_meter.begin();
		tick_sender(time);
		_sender_meter.end();
		_result.tick_ns_max = std::max(_result.tick_ns_max, (_sender_meter.seconds() - before) * NANO);
		for (const net::OutgoingPacket &packet : _sender.packets()) {
			_clients[packet.receiver].send(time, _sender.bytes() + packet.begin, packet.size);
		}
		for (size_t i = 0; i < _clients.size(); ++i) {
			if (_has_joined[i]) {
				_clients[i].end_tick(time);
			}
		}
	}

	void tick_sender(double time) {
		for (size_t i = 0; i < _clients.size(); ++i) {
			if (!_has_joined[i] && time >= _clients[i].join_time()) {
				_has_joined[i] = true;
				_sender.add_receiver(uint32_t(i), time);
			}
			for (const std::vector<uint8_t> &ack : _acks[i]) {
				note(bool(_sender.accept(uint32_t(i), ack.data(), ack.size(), time)));
			}
		}
		for (size_t i = 0; i < _scene.size(); ++i) {
			note(_scene.is_moving(i) ? _sender.observe(uint32_t(i), time, _poses[i]) : _sender.observe(uint32_t(i), time));
		}
		_sender.flush(time);
	}

	LoadResult finish() {
		const double ticks = _result.seconds / _scenario.stream.tick;
		const double minutes = 0.5 * _result.seconds / MINUTE; // between the two peaks
		_result.name = _scenario.name;
		_result.core_share = _sender_meter.seconds() / _result.seconds;
		_result.tick_ns = _sender_meter.seconds() / ticks * NANO;
		_result.memory = std::max(_sender_peaks.first, _sender_peaks.second);
		_result.memory_growth = _sender_peaks.growth(minutes);
		size_t first = 0;
		for (const ReceiverGroup &group : _scenario.groups) {
			_result.groups.push_back(finish_group(group, first, minutes));
			first += group.count;
		}
		return std::move(_result);
	}

	GroupResult finish_group(const ReceiverGroup &group, size_t first, double minutes) {
		GroupResult result;
		result.name = group.name;
		result.receivers = group.count;
		Histogram moving;
		Histogram resting;
		Histogram delays;
		double unseen = 0.0;
		for (size_t i = first; i < first + group.count; ++i) {
			LoadClient &client = _clients[i];
			const double share = 1.0 / double(group.count);
			const double seconds = double(client.ticks().count()) * _scenario.stream.tick;
			result.bytes_per_second += share * double(client.ticks().total()) / seconds;
			result.packets_per_second += share * double(client.packets()) / seconds;
			result.ack_bytes_per_second += share * double(client.ack_bytes()) / seconds;
			result.burst = std::max(result.burst, client.ticks().burst(1.0));
			result.burst_p999 = std::max(result.burst_p999, client.ticks().burst(0.999));
			result.early_burst = std::max(result.early_burst, double(client.early_ticks().max()));
			result.frozen_share = std::max(result.frozen_share, client.playback().frozen_share());
			result.longest_stall = std::max(result.longest_stall, client.playback().longest_stall());
			result.ready_after = std::max(result.ready_after, client.ready_after());
			result.snapshots += share * double(client.snapshots());
			result.retransmissions += share * double(_sender.statistics(uint32_t(i)).chunks_repeated - _early_repeats[i]);
			result.dropped += share * double(client.dropped());
			result.core_share += share * client.meter().seconds() / seconds;
			result.memory += share * std::max(_receiver_peaks[i].first, _receiver_peaks[i].second);
			result.memory_growth += share * _receiver_peaks[i].growth(minutes);
			result.rejected += client.rejected();
			unseen += double(client.unseen());
			moving.add(client.moving_errors());
			resting.add(client.resting_errors());
			delays.add(client.delays());
		}
		result.frame_ns = result.core_share * _scenario.stream.tick * NANO;
		result.error_p50 = moving.percentile(0.5);
		result.error_p99 = moving.percentile(0.99);
		result.error_max = moving.max();
		result.resting_error_max = resting.max();
		result.unseen_share = unseen / std::max(unseen + double(moving.count() + resting.count()), 1.0);
		result.delay_median = delays.percentile(0.5);
		result.delay_max = delays.max();
		return result;
	}

	const LoadScenario &_scenario;
	LoadScene _scene;
	net::Sender _sender;
	Meter _sender_meter;
	std::deque<LoadClient> _clients;
	std::vector<bool> _has_joined;
	std::vector<std::vector<std::vector<uint8_t>>> _acks; // that have arrived, by receiver
	std::vector<cga::Pose<double>> _poses;
	std::vector<uint64_t> _early_repeats; // retransmissions before the measured time, by receiver
	MemoryPeaks _sender_peaks;
	std::vector<MemoryPeaks> _receiver_peaks;
	LoadResult _result;
};

} // namespace

LoadResult run_load(const LoadScenario &scenario) {
	return LoadRun(scenario).run();
}

} // namespace bench
