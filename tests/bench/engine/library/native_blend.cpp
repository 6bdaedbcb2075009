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

// For scale 1, as in the benchmark's scene.
static cga::Pose<float> pose_of(const Transform3D &transform) {
	glm::mat3 basis;
	for (int row = 0; row < 3; row++) {
		for (int column = 0; column < 3; column++) {
			basis[column][row] = transform.basis.rows[row][column];
		}
	}
	return { { transform.origin.x, transform.origin.y, transform.origin.z }, glm::normalize(glm::quat_cast(basis)), 1.0f };
}

static Transform3D transform_of(const cga::Pose<float> &pose) {
	const glm::mat3 basis = glm::mat3_cast(pose.rotation);
	Transform3D transform;
	for (int row = 0; row < 3; row++) {
		transform.basis.rows[row] = godot::Vector3(basis[0][row], basis[1][row], basis[2][row]) * pose.scale;
		transform.origin[row] = pose.translation[row];
	}
	return transform;
}

void NativeBlend::setup(const TypedArray<Node3D> &nodes, const TypedArray<Transform3D> &from, const TypedArray<Transform3D> &to) {
	ERR_FAIL_COND_MSG(nodes.size() != from.size() || nodes.size() != to.size(), "NativeBlend.setup: pass as many poses as nodes.");
	for (int64_t i = 0; i < nodes.size(); i++) {
		_nodes.push_back(godot::Object::cast_to<Node3D>(nodes[i].get_validated_object()));
		_transforms.push_back(from[i]);
		_from.push_back(pose_of(from[i]));
		_to.push_back(pose_of(to[i]));
		_ends.emplace_back(_from.back(), _to.back());
	}
}

template <class Blend>
void NativeBlend::move_all(Blend blend) {
	for (size_t i = 0; i < _nodes.size(); i++) {
		_nodes[i]->set_transform(transform_of(blend(i)));
	}
}

void NativeBlend::blend_paper_pooled(double weight) {
	move_all([&](size_t i) { return paper::interpolate(_ends[i], float(weight), _pool); });
}

void NativeBlend::blend_paper_allocating(double weight) {
	move_all([&](size_t i) { return paper::interpolate(_ends[i], float(weight), _allocating); });
}

void NativeBlend::blend_glm_slerp(double weight) {
	const float t = float(weight);
	move_all([&](size_t i) {
		return cga::Pose<float>{ glm::mix(_from[i].translation, _to[i].translation, t), glm::slerp(_from[i].rotation, _to[i].rotation, t), glm::mix(_from[i].scale, _to[i].scale, t) };
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
