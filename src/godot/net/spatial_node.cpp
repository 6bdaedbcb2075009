#include "godot/net/spatial_node.hpp"

#include "godot/weak_node.hpp"

#include <godot_cpp/classes/node2d.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cmath>

namespace ga_godot {

using godot::Basis;
using godot::Node;
using godot::Node2D;
using godot::Node3D;
using godot::NodePath;
using godot::Object;
using godot::ObjectDB;
using godot::Transform3D;
using godot::Vector2;
using godot::Vector3;

static const Node3D *as_3d(const Node *node) {
	return Object::cast_to<Node3D>(node);
}

static const Node2D *as_2d(const Node *node) {
	return Object::cast_to<Node2D>(node);
}

static Transform3D planar(const Vector2 &position, double rotation, const Vector2 &scale) {
	const double c = std::cos(rotation);
	const double s = std::sin(rotation);
	Transform3D transform;
	transform.basis = Basis(Vector3(float(c * scale.x), float(s * scale.x), 0), Vector3(float(-s * scale.y), float(c * scale.y), 0), Vector3(0, 0, std::sqrt(std::fabs(scale.x * scale.y))));
	transform.origin = Vector3(position.x, position.y, 0);
	return transform;
}

bool is_node_2d(const Node *node) {
	return as_2d(node) != nullptr;
}

bool is_spatial(const Node *node) {
	return as_3d(node) != nullptr || as_2d(node) != nullptr;
}

Node *find_known_spatial(uint64_t id) {
	return static_cast<Node *>(ObjectDB::get_instance(id));
}

Node *find_spatial(uint64_t id) {
	Node *node = Object::cast_to<Node>(ObjectDB::get_instance(id));
	return is_spatial(node) ? node : nullptr;
}

Node *find_spatial(const Node &from, const NodePath &path) {
	Node *node = path.is_empty() ? nullptr : from.get_node_or_null(path);
	return is_spatial(node) ? node : nullptr;
}

Transform3D local_transform(const Node *node, bool is_2d) {
	if (!is_2d) {
		return static_cast<const Node3D *>(node)->get_transform();
	}
	const Node2D *node_2d = static_cast<const Node2D *>(node);
	return planar(node_2d->get_position(), node_2d->get_rotation(), node_2d->get_scale());
}

Transform3D local_transform(const Node *node) {
	return is_spatial(node) ? local_transform(node, is_node_2d(node)) : Transform3D();
}

void set_local_transform(Node *node, const Transform3D &transform) {
	if (Node3D *node_3d = Object::cast_to<Node3D>(node)) {
		if (node_3d->get_transform() != transform) {
			node_3d->set_transform(transform);
		}
		return;
	}
	if (Node2D *node_2d = Object::cast_to<Node2D>(node)) {
		const WeakNode<Node2D> weak(node_2d);
		const Vector3 x = transform.basis.get_column(0);
		const Vector2 position(transform.origin.x, transform.origin.y);
		const float rotation = float(std::atan2(x.y, x.x));
		const float scale = std::sqrt(x.x * x.x + x.y * x.y);
		if (node_2d->get_position() != position) {
			node_2d->set_position(position);
		}
		if (weak.get() != nullptr && float(node_2d->get_rotation()) != rotation) {
			node_2d->set_rotation(rotation);
		}
		if (weak.get() != nullptr && node_2d->get_scale() != Vector2(scale, scale)) {
			node_2d->set_scale(Vector2(scale, scale));
		}
	}
}

Transform3D global_transform(const Node *node) {
	if (const Node3D *node_3d = as_3d(node)) {
		return node_3d->get_global_transform();
	}
	const Node2D *node_2d = as_2d(node);
	return node_2d != nullptr ? planar(node_2d->get_global_position(), node_2d->get_global_rotation(), node_2d->get_global_scale()) : Transform3D();
}

bool is_shown(const Node *node) {
	const Node3D *node_3d = as_3d(node);
	const Node2D *node_2d = as_2d(node);
	return node_3d != nullptr ? node_3d->is_visible() : node_2d != nullptr && node_2d->is_visible();
}

void set_shown(Node *node, bool shown) {
	if (Node3D *node_3d = Object::cast_to<Node3D>(node)) {
		node_3d->set_visible(shown);
	} else if (Node2D *node_2d = Object::cast_to<Node2D>(node)) {
		node_2d->set_visible(shown);
	}
}

bool is_moved_by_physics(const Node *node) {
	if (node->is_class("RigidBody3D") || node->is_class("RigidBody2D")) {
		return !bool(node->get("freeze"));
	}
	return (node->is_class("AnimatableBody3D") || node->is_class("AnimatableBody2D")) && bool(node->get("sync_to_physics"));
}

} // namespace ga_godot
