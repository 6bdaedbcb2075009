// The two methods of the GA-Unity paper, with the output of interpolate_linear's other subjects: 12 floats a pose.

#include "../cga/random_poses.hpp"
#include "engine/paper_method.hpp"

#include "cga/batch/pose_block.hpp"

#include <benchmark/benchmark.h>

#include <vector>

namespace {

using namespace bench;

template <class Store>
void paper_method(benchmark::State &state) {
	const size_t count = size_t(state.range(0));
	cga_test::Random random(2026);
	std::vector<paper::Ends> ends;
	for (size_t i = 0; i < count; ++i) {
		const cga::Pose<float> from = cga::pose_cast<float>(random.pose());
		ends.emplace_back(from, cga::pose_cast<float>(random.pose()));
	}
	Store store;
	std::vector<float> rows(count * cga::ROW_FLOATS);
	float weight = 0.0f;
	for (auto _ : state) {
		weight = weight < 0.9f ? weight + 0.07f : 0.03f;
		for (size_t i = 0; i < count; ++i) {
			cga::pose_to_row(paper::interpolate(ends[i], weight, store), &rows[i * cga::ROW_FLOATS]);
		}
		benchmark::ClobberMemory();
	}
}

const bool REGISTERED = [] {
	for (const int count : { 1, 10, 100, 1000, 10000 }) {
		benchmark::RegisterBenchmark("interpolate_linear/paper_pooled", paper_method<paper::Pool>)->Arg(count);
		benchmark::RegisterBenchmark("interpolate_linear/paper_allocating", paper_method<paper::Allocating>)->Arg(count);
	}
	return true;
}();

} // namespace
