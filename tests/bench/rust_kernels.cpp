// The linear blend compared with Rust's glam, one pair at a time, and ultraviolet, 8 pairs at a time (rust_peers/). These are
// compiled for this machine's processor, unlike GLM and Eigen.

#if defined(HAS_RUST_PEERS)

#include "kernel_input.hpp"

#include "cga/motor/interpolate.hpp"

#include <cmath>

extern "C" {
void *glam_pairs(const void *poses, size_t count);
void glam_free(void *pairs);
void glam_slerp(const void *pairs, float weight, float *rows);
void glam_nlerp(const void *pairs, float weight, float *rows);
void *ultraviolet_pairs(const void *poses, size_t count);
void ultraviolet_free(void *pairs);
void ultraviolet_nlerp(const void *pairs, float weight, float *rows);
}

namespace kernels_bench {

namespace {

struct RustPose {
	float position[3];
	float rotation[4]; // x, y, z, w
	float scale;
};

RustPose rust_pose(const Posef &pose) {
	return { { pose.translation.x, pose.translation.y, pose.translation.z }, { pose.rotation.x, pose.rotation.y, pose.rotation.z, pose.rotation.w }, pose.scale };
}

struct Library {
	void *(*make)(const void *, size_t);
	void (*free)(void *);
	void (*blend)(const void *, float, float *);
	cga::Mode same_rotation_as;
	size_t bytes_read;
};

// Whether the library computes the same bases as this one.
bool agrees(const Library &library, const std::vector<PosePair> &pairs, const void *made, float *rows) {
	library.blend(made, 0.3f, rows);
	for (size_t i = 0; i < pairs.size(); ++i) {
		float expected[cga::ROW_FLOATS];
		cga::pose_to_row(cga::interpolate(pairs[i].from, pairs[i].to, 0.3f, library.same_rotation_as), expected);
		for (size_t entry = 0; entry < cga::ROW_FLOATS; ++entry) {
			if (entry % 4 != 3 && !(std::abs(rows[i * cga::ROW_FLOATS + entry] - expected[entry]) < 1e-3f)) {
				return false;
			}
		}
	}
	return true;
}

void rust(benchmark::State &state, Library library) {
	const size_t count = size_t(state.range(0));
	const std::vector<PosePair> pairs = random_pairs(count);
	std::vector<RustPose> poses;
	for (const PosePair &pair : pairs) {
		poses.push_back(rust_pose(pair.from));
		poses.push_back(rust_pose(pair.to));
	}
	void *made = library.make(poses.data(), count);
	std::vector<float> rows(cga::block_count(count) * cga::PoseBlock::LANES * cga::ROW_FLOATS);
	if (!agrees(library, pairs, made, rows.data())) {
		state.SkipWithError("its rows differ from those of this library");
	}
	float weight = 0.0f;
	measure(state, count, library.bytes_read + sizeof(float) * cga::ROW_FLOATS, [&] {
		weight = weight < 0.9f ? weight + 0.07f : 0.03f;
		library.blend(made, weight, rows.data());
	});
	library.free(made);
}

const bool REGISTERED = [] {
	// glam's pose is 48 bytes with its padding, a pose of ultraviolet's 8 floats.
	const Library slerp = { glam_pairs, glam_free, glam_slerp, cga::Mode::SEPARATE, 96 };
	const Library nlerp = { glam_pairs, glam_free, glam_nlerp, cga::Mode::LINEAR, 96 };
	const Library wide = { ultraviolet_pairs, ultraviolet_free, ultraviolet_nlerp, cga::Mode::LINEAR, 64 };
	add("interpolate_linear", "glam_slerp", rust, slerp);
	add("interpolate_linear", "glam_nlerp", rust, nlerp);
	add("interpolate_linear", "ultraviolet_nlerp", rust, wide);
	return true;
}();

} // namespace

} // namespace kernels_bench

#endif
