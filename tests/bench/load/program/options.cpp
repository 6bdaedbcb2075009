#include "options.hpp"

#include <array>
#include <charconv>
#include <string_view>

namespace bench {

namespace {

// A number in [min, max] of the unit that the user gives; `factor` converts to that of LoadChanges.
struct NumberOption {
	std::string_view name;
	std::optional<double> LoadChanges::*value;
	double min;
	double max;
	double factor;
};

constexpr double MILLI = 1e-3;
constexpr double PERCENT = 1e-2;
constexpr double KILO = 1e3;

constexpr std::array<NumberOption, 18> NUMBERS = { {
		{ "--bodies", &LoadChanges::bodies, 1.0, 65536.0, 1.0 },
		{ "--moving", &LoadChanges::moving_share, 0.0, 100.0, PERCENT },
		{ "--receivers", &LoadChanges::receivers, 1.0, 1000.0, 1.0 },
		{ "--rtt", &LoadChanges::round_trip, 0.0, 60e3, MILLI },
		{ "--jitter", &LoadChanges::jitter, 0.0, 60e3, MILLI },
		{ "--loss", &LoadChanges::loss, 0.0, 100.0, PERCENT },
		{ "--ack-loss", &LoadChanges::ack_loss, 0.0, 100.0, PERCENT },
		{ "--burst", &LoadChanges::burst, 0.0, 1e6, 1.0 },
		{ "--rate", &LoadChanges::bytes_per_second, 0.0, 1e9, KILO },
		{ "--queue-ms", &LoadChanges::queue, 0.0, 60e3, MILLI },
		{ "--police", &LoadChanges::polices, 0.0, 1.0, 1.0 },
		{ "--seconds", &LoadChanges::seconds, 1.0, 1e6, 1.0 },
		{ "--warm-up", &LoadChanges::warm_up, 0.0, 1e6, 1.0 },
		{ "--tolerance-mm", &LoadChanges::tolerance, 0.01, 1e4, MILLI },
		{ "--latency-ms", &LoadChanges::max_latency, 10.0, 1e4, MILLI },
		{ "--send-rate", &LoadChanges::send_rate, 1.0, 1000.0, 1.0 },
		{ "--cpu-limit", &LoadChanges::cpu_limit, 0.1, 1e6, 1.0 },
		{ "--seed", &LoadChanges::seed, 0.0, 9e15, 1.0 },
} };

bool parse_number(std::string_view name, std::string_view text, LoadChanges &changes) {
	for (const NumberOption &option : NUMBERS) {
		double value = 0.0;
		const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), value);
		if (option.name == name && result.ec == std::errc() && result.ptr == text.data() + text.size() && value >= option.min && value <= option.max) {
			changes.*option.value = value * option.factor;
			return true;
		}
	}
	return false;
}

} // namespace

std::string parse_options(int count, const char *const *arguments, LoadOptions &options) {
	for (int i = 1; i < count; ++i) {
		const std::string_view argument = arguments[i];
		const size_t equals = argument.find('=');
		const std::string_view name = argument.substr(0, equals);
		const std::string_view value = equals == std::string_view::npos ? std::string_view() : argument.substr(equals + 1);
		if (argument == "--quick") {
			options.is_quick = true;
		} else if (name == "--case" && !value.empty()) {
			options.cases.emplace_back(value);
		} else if (parse_number(name, value, options.changes)) {
			options.has_changes = true;
		} else {
			return "'" + std::string(argument) + "' is not an option of this program, or its value is out of range";
		}
	}
	return {};
}

} // namespace bench
