#include "input.hpp"

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's entry point
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size) {
	fuzz::run(fuzz::Input(bytes, size));
	return 0;
}
