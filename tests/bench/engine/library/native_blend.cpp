#include "native_blend.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace bench {

using godot::Node3D;
using godot::Transform3D;
using godot::TypedArray;

// Scale 1, as in the benchmark's scene.
static cga::Pose<float> pose_of(const Transform3D &p_transform) {
	glm::mat3 basis;
	for (int row = 0; row < 3; row++) {
		for (int column = 0; column < 3; column++) {
			basis[column][row] = p_transform.basis.rows[row][column];
		}
	}
	return { { p_transform.origin.x, p_transform.origin.y, p_transform.origin.z }, glm::normalize(glm::quat_cast(basis)), 1.0f };
}

static Transform3D transform_of(const cga::Pose<float> &p_pose) {
	const glm::mat3 basis = glm::mat3_cast(p_pose.rotation);
	Transform3D transform;
	for (int row = 0; row < 3; row++) {
		transform.basis.rows[row] = godot::Vector3(basis[0][row], basis[1][row], basis[2][row]) * p_pose.scale;
		transform.origin[row] = p_pose.translation[row];
	}
	return transform;
}

void NativeBlend::setup(const TypedArray<Node3D> &p_nodes, const TypedArray<Transform3D> &p_from, const TypedArray<Transform3D> &p_to) {
	ERR_FAIL_COND_MSG(p_nodes.size() != p_from.size() || p_nodes.size() != p_to.size(), "NativeBlend.setup: give as many poses as nodes.");
	for (int64_t i = 0; i < p_nodes.size(); i++) {
		_nodes.push_back(godot::Object::cast_to<Node3D>(p_nodes[i].get_validated_object()));
		_transforms.push_back(p_from[i]);
		_from.push_back(pose_of(p_from[i]));
		_to.push_back(pose_of(p_to[i]));
		_ends.emplace_back(_from.back(), _to.back());
	}
}

template <class Blend>
void NativeBlend::move_all(Blend p_blend) {
	for (size_t i = 0; i < _nodes.size(); i++) {
		_nodes[i]->set_transform(transform_of(p_blend(i)));
	}
}

void NativeBlend::blend_paper_pooled(double p_weight) {
	move_all([&](size_t i) { return paper::interpolate(_ends[i], float(p_weight), _pool); });
}

void NativeBlend::blend_paper_allocating(double p_weight) {
	move_all([&](size_t i) { return paper::interpolate(_ends[i], float(p_weight), _allocating); });
}

void NativeBlend::blend_glm_slerp(double p_weight) {
	const float weight = float(p_weight);
	move_all([&](size_t i) {
		return cga::Pose<float>{ glm::mix(_from[i].translation, _to[i].translation, weight), glm::slerp(_from[i].rotation, _to[i].rotation, weight), glm::mix(_from[i].scale, _to[i].scale, weight) };
	});
}

void NativeBlend::set_only(double) {
	for (size_t i = 0; i < _nodes.size(); i++) {
		_nodes[i]->set_transform(_transforms[i]);
	}
}

void NativeBlend::_bind_methods() {
	using godot::ClassDB;
	using godot::D_METHOD;

	ClassDB::bind_method(D_METHOD("setup", "nodes", "from", "to"), &NativeBlend::setup);
	ClassDB::bind_method(D_METHOD("blend_paper_pooled", "weight"), &NativeBlend::blend_paper_pooled);
	ClassDB::bind_method(D_METHOD("blend_paper_allocating", "weight"), &NativeBlend::blend_paper_allocating);
	ClassDB::bind_method(D_METHOD("blend_glm_slerp", "weight"), &NativeBlend::blend_glm_slerp);
	ClassDB::bind_method(D_METHOD("set_only", "weight"), &NativeBlend::set_only);
}

} // namespace bench
