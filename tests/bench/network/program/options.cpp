#include "options.hpp"

#include <array>
#include <charconv>
#include <string_view>
#include <utility>

namespace bench {

namespace {

constexpr std::array<std::pair<std::string_view, cga::Mode>, 3> MODES = { {
		{ "linear", cga::Mode::LINEAR },
		{ "screw", cga::Mode::SCREW },
		{ "separate", cga::Mode::SEPARATE },
} };

bool parse_mode(std::string_view text, cga::Mode &mode) {
	for (const auto &[name, value] : MODES) {
		if (name == text) {
			mode = value;
			return true;
		}
	}
	return false;
}

// A number in [min, max].
struct NumberOption {
	std::string_view name;
	double *value;
	double min;
	double max;
};

bool parse_number(std::string_view text, const NumberOption &option) {
	double value = 0.0;
	const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), value);
	if (result.ec != std::errc() || result.ptr != text.data() + text.size() || !(value >= option.min && value <= option.max)) {
		return false;
	}
	*option.value = value;
	return true;
}

} // namespace

std::string parse_options(int count, const char *const *arguments, Options &options) {
	double seed = double(options.seed);
	double runs = double(options.runs);
	const std::array<NumberOption, 11> numbers = { {
			{ "loss", &options.link.loss, 0.0, 1.0 },
			{ "burst", &options.link.burst, 0.0, 1e6 },
			{ "duplication", &options.link.duplication, 0.0, 1.0 },
			{ "delay", &options.link.delay, 0.0, 60.0 },
			{ "jitter", &options.link.jitter, 0.0, 60.0 },
			{ "bytes-per-second", &options.link.bytes_per_second, 0.0, 1e12 },
			{ "tolerance", &options.tolerance, 1e-5, 10.0 },
			{ "max-latency", &options.max_latency, 0.01, 10.0 },
			{ "send-rate", &options.send_rate, 1.0, 1000.0 },
			{ "seed", &seed, 0.0, 9e15 },
			{ "runs", &runs, 1.0, 1000.0 },
	} };
	for (int i = 1; i < count; ++i) {
		const std::string_view argument = arguments[i];
		const size_t equals = argument.find('=');
		const std::string_view name = argument.substr(0, equals);
		const std::string_view value = equals == std::string_view::npos ? std::string_view() : argument.substr(equals + 1);
		bool is_valid = name.substr(0, 2) == "--";
		if (is_valid && name == "--trace") {
			options.trace = value;
			is_valid = !value.empty();
		} else if (is_valid && name == "--baselines") {
			options.baselines = value == "yes";
			is_valid = value == "yes" || value == "no";
		} else if (is_valid && name == "--mode") {
			is_valid = parse_mode(value, options.mode);
		} else if (is_valid) {
			is_valid = false;
			for (const NumberOption &number : numbers) {
				is_valid = is_valid || (number.name == name.substr(2) && parse_number(value, number));
			}
		}
		if (!is_valid) {
			return "'" + std::string(argument) + "' is not an option of this program, or its value is out of range";
		}
	}
	options.seed = uint64_t(seed);
	options.runs = uint64_t(runs);
	return {};
}

} // namespace bench
