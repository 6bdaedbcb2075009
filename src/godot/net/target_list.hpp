#pragma once

#include "godot/net/target.hpp"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace ga_godot {

/// Targets, which are found by the instance ids of their nodes.
class TargetList {
public:
	void add(const Target &target) {
		_index[target.node] = _targets.size();
		_targets.push_back(target);
	}
	/// Removes a target. The last one takes its place.
	void remove(size_t index) {
		_index.erase(_targets[index].node);
		if (index + 1 < _targets.size()) {
			_targets[index] = _targets.back();
			_index[_targets[index].node] = index;
		}
		_targets.pop_back();
	}
	[[nodiscard]] bool has(uint64_t node) const { return _index.count(node) != 0; }
	[[nodiscard]] Target *find(uint64_t node) {
		const auto found = _index.find(node);
		return found != _index.end() ? &_targets[found->second] : nullptr;
	}
	[[nodiscard]] size_t index_of(uint64_t node) const { return _index.at(node); }

	[[nodiscard]] size_t size() const { return _targets.size(); }
	[[nodiscard]] Target &operator[](size_t index) { return _targets[index]; }
	[[nodiscard]] auto begin() { return _targets.begin(); }
	[[nodiscard]] auto end() { return _targets.end(); }
	[[nodiscard]] auto begin() const { return _targets.begin(); }
	[[nodiscard]] auto end() const { return _targets.end(); }

private:
	std::vector<Target> _targets;
	std::unordered_map<uint64_t, size_t> _index; // into _targets
};

} // namespace ga_godot
