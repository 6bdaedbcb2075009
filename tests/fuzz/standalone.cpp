// A main() for fuzz targets built without libFuzzer, with a subset of its options: runs the files of a corpus, then random
// edits of them and random bytes, without guidance by coverage.
//
//   TARGET [-runs=N] [-max_total_time=SECONDS] [-seed=N] [-max_len=BYTES] [-timeout=SECONDS]
//     [-artifact_prefix=PATH] [FILE|FOLDER]...
//
// With neither a folder nor a limit it only runs the files. A finding is written to PATHfinding and ends the program.

#include "input.hpp"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's entry point
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

namespace {

using fuzz::Bytes;

struct Options {
	long long runs = -1; // -1: no limit
	long long seconds = 0; // 0: no limit
	size_t max_length = 4096;
	unsigned timeout = 1200; // seconds for one input
	unsigned seed = 20240601;
	bool has_folder = false;
	std::vector<Bytes> corpus;
};

Bytes current; // the input that runs
std::string artifact_prefix;

Bytes read_file(const std::filesystem::path &path) {
	std::ifstream file(path, std::ios::binary);
	return Bytes(std::istreambuf_iterator<char>(file), {});
}

bool read_option(const std::string &argument, const char *name, long long &value) {
	const std::string start = std::string("-") + name + "=";
	if (argument.compare(0, start.size(), start) != 0) {
		return false;
	}
	value = std::atoll(argument.c_str() + start.size());
	return true;
}

void read_corpus(const std::filesystem::path &path, Options &options) {
	if (!std::filesystem::is_directory(path)) {
		options.corpus.push_back(read_file(path));
		return;
	}
	options.has_folder = true;
	std::vector<std::filesystem::path> files;
	for (const auto &entry : std::filesystem::directory_iterator(path)) {
		files.push_back(entry.path());
	}
	std::sort(files.begin(), files.end()); // so that the seed determines the inputs
	for (const auto &file : files) {
		options.corpus.push_back(read_file(file));
	}
}

Options read_options(int count, char **arguments) {
	Options options;
	long long value = 0;
	for (int i = 1; i < count; ++i) {
		const std::string argument = arguments[i];
		if (argument.empty() || argument[0] != '-') {
			read_corpus(argument, options);
		} else if (read_option(argument, "seed", value)) {
			options.seed = unsigned(value);
		} else if (read_option(argument, "max_len", value)) {
			options.max_length = size_t(value);
		} else if (read_option(argument, "timeout", value)) {
			options.timeout = unsigned(value);
		} else if (argument.compare(0, 17, "-artifact_prefix=") == 0) {
			artifact_prefix = argument.substr(17);
		} else if (!read_option(argument, "runs", options.runs)) {
			(void)read_option(argument, "max_total_time", options.seconds); // libFuzzer's other options have no effect
		}
	}
	return options;
}

void end_with_finding(int signal) {
	std::ofstream(artifact_prefix + "finding", std::ios::binary).write(reinterpret_cast<const char *>(current.data()), std::streamsize(current.size()));
	std::fprintf(stderr, "%s; the input is in the file %sfinding\n", signal == SIGALRM ? "timeout" : "failed", artifact_prefix.c_str());
	_exit(1);
}

void run(const Options &options) {
	alarm(options.timeout);
	LLVMFuzzerTestOneInput(current.data(), current.size());
	alarm(0);
}

void mutate(Bytes &bytes, const std::vector<Bytes> &corpus, std::mt19937 &random) {
	for (size_t left = 1 + random() % 6; left > 0; --left) {
		uint8_t choices[32];
		std::generate(std::begin(choices), std::end(choices), [&] { return uint8_t(random()); });
		fuzz::Input input(choices, sizeof(choices));
		if (random() % 8 == 0 && !corpus.empty()) {
			const Bytes &other = corpus[random() % corpus.size()];
			bytes.resize(bytes.empty() ? 0 : random() % bytes.size());
			bytes.insert(bytes.end(), other.begin() + ptrdiff_t(other.empty() ? 0 : random() % other.size()), other.end());
		} else {
			fuzz::edit(bytes, input);
		}
	}
}

} // namespace

int main(int count, char **arguments) {
	const Options options = read_options(count, arguments);
	std::signal(SIGABRT, end_with_finding);
	std::signal(SIGALRM, end_with_finding);
	std::mt19937 random(options.seed);
	const auto start = std::chrono::steady_clock::now();
	const auto seconds = [&] { return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::steady_clock::now() - start).count(); };
	long long runs = 0;
	for (const Bytes &file : options.corpus) {
		current = file;
		run(options);
		++runs;
	}
	const bool only_files = !options.has_folder && options.runs < 0 && options.seconds == 0;
	while (!only_files && (options.runs < 0 || runs < options.runs) && (options.seconds == 0 || seconds() < options.seconds)) {
		if (options.corpus.empty() || random() % 4 == 0) {
			current.resize(random() % std::min<size_t>(options.max_length, 512));
			std::generate(current.begin(), current.end(), [&] { return uint8_t(random()); });
		} else {
			current = options.corpus[random() % options.corpus.size()];
			mutate(current, options.corpus, random);
		}
		current.resize(std::min(current.size(), options.max_length));
		run(options);
		++runs;
	}
	std::fprintf(stderr, "Done %lld runs in %lld second(s)\n", runs, (long long)seconds());
	return 0;
}
