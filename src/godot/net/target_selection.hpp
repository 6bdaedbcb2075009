#pragma once

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <cstdint>
#include <vector>

namespace ga_godot {

/// Selects the nodes that a MotorSynchronizer replicates: by path, by group, and by add_target and remove_target.
class TargetSelection {
public:
	void set_paths(const godot::TypedArray<godot::NodePath> &paths);
	[[nodiscard]] const godot::TypedArray<godot::NodePath> &paths() const { return _paths; }
	void set_group(const godot::StringName &group);
	[[nodiscard]] const godot::StringName &group() const { return _group; }
	/// Instance ids of the nodes that add() has selected, freed ones included.
	[[nodiscard]] const std::vector<uint64_t> &added() const { return _added; }
	void add(uint64_t node);
	void remove(uint64_t node);

	[[nodiscard]] bool is_empty() const;
	/// True if the paths, the group or add() select the node.
	[[nodiscard]] bool selects(const godot::Node &synchronizer, const godot::Node *node) const;

	/// Makes the next `is_refresh_due` return true.
	void invalidate() { _is_stale = true; }
	/// True if the selected nodes may have changed. Call it once a tick.
	[[nodiscard]] bool is_refresh_due(const godot::Node &synchronizer);
	/// Instance ids of the selected nodes that are in the tree below `root`, each once.
	[[nodiscard]] std::vector<uint64_t> find(const godot::Node &synchronizer, const godot::String &root);

	/// The number of calls of `find`.
	[[nodiscard]] uint64_t revision() const { return _revision; }
	/// True if `ids` is not what was remembered last.
	[[nodiscard]] bool has_changed(const std::vector<uint64_t> &ids) const { return !_has_found || ids != _found; }
	void remember(const std::vector<uint64_t> &ids) {
		_found = ids;
		_has_found = true;
	}
	void forget() { _has_found = false; }

private:
	godot::TypedArray<godot::NodePath> _paths;
	godot::StringName _group;
	std::vector<uint64_t> _added;
	std::vector<uint64_t> _excluded;
	std::vector<godot::NodePath> _unresolved;
	std::vector<uint64_t> _found;
	bool _has_found = false;
	uint64_t _revision = 0;
	int64_t _group_count = 0;
	int64_t _refresh_in = 0; // ticks
	bool _is_stale = true;
};

} // namespace ga_godot
