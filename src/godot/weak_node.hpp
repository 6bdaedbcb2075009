#pragma once

#include <godot_cpp/godot.hpp>

#include <cstdint>

namespace ga_godot {

/// A node that may be freed at any time. It stores the C++ object, because looking that up by the instance id costs as much as
/// moving the node.
template <class T>
class WeakNode {
public:
	WeakNode() = default;
	explicit WeakNode(T *node) :
			_id(node != nullptr ? node->get_instance_id() : 0), _node(node) {}

	/// The instance id; 0 for none.
	[[nodiscard]] uint64_t id() const { return _id; }
	/// Null if there is no node, or it was freed. Valid until the next call into the engine.
	[[nodiscard]] T *get() const { return _id != 0 && godot::gdextension_interface::object_get_instance_from_id(_id) != nullptr ? _node : nullptr; }

	/// The node, if it is certain that it was not freed.
	[[nodiscard]] T *known() const { return _node; }

private:
	uint64_t _id = 0;
	T *_node = nullptr;
};

} // namespace ga_godot
