#include "load_cases.hpp"

#include <algorithm>

namespace bench {

namespace {

constexpr double CLEAN_ROUND_TRIP = 0.02; // seconds
constexpr double USUAL_ROUND_TRIP = 0.1;
constexpr double LONG_QUEUE = 2.0; // seconds
constexpr double TOLERANCE = 0.005; // meters
constexpr double MAX_LATENCY = 0.2; // seconds
constexpr double QUICK_SECONDS = 4.0; // measured
constexpr double QUICK_WARM_UP = 3.0;
constexpr double SECONDS = 20.0; // measured
constexpr double WARM_UP = 5.0;
// At a tenth of the need, the snapshot alone takes 8 seconds.
constexpr double NARROW_WARM_UP = 15.0;

void set_line(ReceiverGroup &group, double round_trip, double loss) {
	for (LineSettings *line : { &group.down, &group.up }) {
		line->path.delay = 0.5 * round_trip;
		line->path.loss = loss;
	}
}

class CaseList {
public:
	explicit CaseList(bool is_quick) :
			_is_quick(is_quick) {}

	// One group of receivers over one kind of line. The reference is valid until the next call.
	LoadCase &add(const char *name, const char *base, size_t bodies, double round_trip, double loss, double seconds = SECONDS) {
		LoadCase added;
		LoadScenario &scenario = added.scenario;
		added.base = base;
		scenario.name = name;
		scenario.bodies = bodies;
		scenario.warm_up = _is_quick ? QUICK_WARM_UP : WARM_UP;
		scenario.seconds = scenario.warm_up + (_is_quick ? QUICK_SECONDS : seconds);
		scenario.stream = load_settings(TOLERANCE, MAX_LATENCY);
		scenario.groups.emplace_back();
		set_line(scenario.groups.back(), round_trip, loss);
		_cases.push_back(added);
		return _cases.back();
	}

	[[nodiscard]] std::vector<LoadCase> take() { return std::move(_cases); }

private:
	bool _is_quick;
	std::vector<LoadCase> _cases;
};

// Bodies by the thousand over long and lossy lines.
void add_long_lines(CaseList &list) {
	list.add("clean_10k", "", 10000, CLEAN_ROUND_TRIP, 0.0);
	list.add("rtt200_10k", "clean_10k", 10000, 0.2, 0.0);
	list.add("rtt500_10k", "clean_10k", 10000, 0.5, 0.0);
	list.add("loss5_10k", "clean_10k", 10000, USUAL_ROUND_TRIP, 0.05);
	list.add("loss10_5k", "clean_10k", 5000, USUAL_ROUND_TRIP, 0.1);
	list.add("clean_40k", "clean_10k", 40000, CLEAN_ROUND_TRIP, 0.0);
}

// Lines that carry less than the stream needs.
void add_narrow_lines(CaseList &list) {
	const auto narrow = [&list](const char *name, size_t bodies) -> LoadCase & {
		LoadCase &added = list.add(name, bodies == 1000 ? "clean_1k" : "clean_10k", bodies, USUAL_ROUND_TRIP, 0.0);
		added.scenario.seconds += NARROW_WARM_UP - added.scenario.warm_up;
		added.scenario.warm_up = NARROW_WARM_UP;
		return added;
	};
	list.add("clean_1k", "", 1000, CLEAN_ROUND_TRIP, 0.0);
	narrow("half_1k", 1000).rate_shares = { { 0.0, 0.5 } };
	narrow("quarter_1k", 1000).rate_shares = { { 0.0, 0.25 } };
	narrow("tenth_1k", 1000).rate_shares = { { 0.0, 0.1 } };
	LoadCase &buffered = narrow("half_long_queue_1k", 1000);
	buffered.rate_shares = { { 0.0, 0.5 } };
	buffered.scenario.groups[0].down.queue = LONG_QUEUE;
	LoadCase &policed = narrow("half_policed_1k", 1000);
	policed.rate_shares = { { 0.0, 0.5 } };
	policed.scenario.groups[0].down.polices = true;
	LoadCase &varying = narrow("varying_1k", 1000);
	const double third = (varying.scenario.seconds - NARROW_WARM_UP) / 3.0;
	varying.rate_shares = { { 0.0, 2.0 }, { NARROW_WARM_UP + third, 0.5 }, { NARROW_WARM_UP + 2.0 * third, 2.0 } };
	narrow("rate100_10k", 10000).scenario.groups[0].down.rates = { { 0.0, 100e3 } };
}

// Loss in bursts, jitter, and loss of acknowledgements only.
void add_bad_lines(CaseList &list) {
	list.add("bursts5_1k", "clean_1k", 1000, USUAL_ROUND_TRIP, 0.05).scenario.groups[0].down.path.burst = 8.0;
	list.add("jitter100_1k", "clean_1k", 1000, USUAL_ROUND_TRIP, 0.0).scenario.groups[0].down.path.jitter = 0.1;
	list.add("ack_loss30_1k", "clean_1k", 1000, USUAL_ROUND_TRIP, 0.0).scenario.groups[0].up.path.loss = 0.3;
}

// One of 64 receivers has a bad line; another joins.
void add_mixed_receivers(CaseList &list) {
	const auto mixed = [&list](const char *name, double bad_loss) -> LoadCase & {
		LoadCase &added = list.add(name, "clean_64", 1000, USUAL_ROUND_TRIP, 0.0);
		added.scenario.seconds += NARROW_WARM_UP - added.scenario.warm_up;
		added.scenario.warm_up = NARROW_WARM_UP;
		ReceiverGroup bad = added.scenario.groups[0];
		set_line(bad, USUAL_ROUND_TRIP, bad_loss);
		bad.name = "bad";
		added.scenario.groups[0].name = "others";
		added.scenario.groups[0].count = 63;
		added.scenario.groups.push_back(bad);
		added.rated_group = "bad";
		return added;
	};
	list.add("clean_64", "", 1000, USUAL_ROUND_TRIP, 0.0).scenario.groups[0].count = 64;
	mixed("loss20_1_of_64", 0.2);
	mixed("tenth_1_of_64", 0.0).rate_shares = { { 0.0, 0.1 } };
	LoadCase &joining = list.add("join_10k", "clean_10k", 10000, USUAL_ROUND_TRIP, 0.0);
	ReceiverGroup joiner = joining.scenario.groups[0];
	joining.scenario.groups[0].name = "others";
	joiner.name = "joiner";
	joiner.join = joining.scenario.warm_up;
	joining.scenario.groups.push_back(joiner);
}

} // namespace

std::vector<LoadCase> load_cases(bool is_quick) {
	CaseList list(is_quick);
	add_long_lines(list);
	add_narrow_lines(list);
	add_bad_lines(list);
	add_mixed_receivers(list);
	LoadCase &long_run = list.add("ten_minutes_64", "clean_1k", 1000, USUAL_ROUND_TRIP, 0.0, 600.0);
	long_run.scenario.groups[0].count = 64;
	long_run.scenario.cpu_limit = 1200.0;
	return list.take();
}

void apply(const LoadChanges &changes, LoadCase &changed) {
	LoadScenario &scenario = changed.scenario;
	const auto set = [](auto &value, const std::optional<double> &change) {
		if (change) {
			value = std::remove_reference_t<decltype(value)>(*change);
		}
	};
	set(scenario.bodies, changes.bodies);
	set(scenario.moving_share, changes.moving_share);
	set(scenario.groups[0].count, changes.receivers);
	set(scenario.seconds, changes.seconds);
	set(scenario.warm_up, changes.warm_up);
	set(scenario.cpu_limit, changes.cpu_limit);
	set(scenario.seed, changes.seed);
	scenario.stream = load_settings(changes.tolerance.value_or(scenario.stream.position_tolerance), changes.max_latency.value_or(scenario.stream.max_latency));
	set(scenario.stream.send_rate, changes.send_rate);
	for (ReceiverGroup &group : scenario.groups) {
		for (LineSettings *line : { &group.down, &group.up }) {
			set(line->path.delay, changes.round_trip ? std::optional(0.5 * *changes.round_trip) : std::nullopt);
			set(line->path.jitter, changes.jitter);
			set(line->path.loss, changes.loss);
			set(line->path.burst, changes.burst);
		}
		set(group.up.path.loss, changes.ack_loss);
		set(group.down.queue, changes.queue);
		set(group.down.polices, changes.polices);
		if (changes.bytes_per_second) {
			group.down.rates = { { 0.0, *changes.bytes_per_second } };
			changed.rate_shares.clear();
		}
	}
}

void set_rates(LoadCase &changed, double need) {
	for (ReceiverGroup &group : changed.scenario.groups) {
		if (!changed.rate_shares.empty() && (changed.rated_group.empty() || changed.rated_group == group.name)) {
			group.down.rates = changed.rate_shares;
			for (LineRate &rate : group.down.rates) {
				rate.bytes_per_second *= need;
			}
		}
	}
}

} // namespace bench
