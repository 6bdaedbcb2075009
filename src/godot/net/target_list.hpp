#pragma once

#include "godot/net/target.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace ga_godot {

/// Targets, which are found by the instance ids of their nodes.
///
/// Callbacks may add and remove targets while others iterate over them. A removed target therefore stays in memory until sweep(),
/// marked as removed: code that has called into the engine checks `is_removed` before it continues with a target.
class TargetList {
public:
	/// Visits the targets that existed at begin() and are not removed.
	class Iterator {
	public:
		Iterator(const TargetList &list, size_t index, size_t end) :
				_list(list), _index(index), _end(end) {
			skip_removed();
		}
		Target &operator*() const { return *_list._targets[_index]; }
		Iterator &operator++() {
			_index++;
			skip_removed();
			return *this;
		}
		/// True until the end; `_` is end().
		bool operator!=(const Iterator & /*_*/) const { return _index < _end; }

	private:
		void skip_removed() {
			while (_index < _end && _list._targets[_index]->is_removed) {
				_index++;
			}
		}

		const TargetList &_list;
		size_t _index;
		size_t _end;
	};

	void add(const Target &target) {
		_index[target.node] = _targets.size();
		_targets.push_back(std::make_unique<Target>(target));
	}
	void remove(Target &target) {
		target.is_removed = true;
		_index.erase(target.node);
		_is_swept = false;
	}
	/// Deletes the removed targets. No reference to one may be in use.
	void sweep() {
		if (_is_swept) {
			return;
		}
		_is_swept = true;
		for (size_t i = _targets.size(); i-- > 0;) {
			if (_targets[i]->is_removed) {
				if (i + 1 < _targets.size()) {
					_targets[i] = std::move(_targets.back());
					_index[_targets[i]->node] = i;
				}
				_targets.pop_back();
			}
		}
	}
	[[nodiscard]] bool has(uint64_t node) const { return _index.count(node) != 0; }
	[[nodiscard]] Target *find(uint64_t node) {
		const auto found = _index.find(node);
		return found != _index.end() ? _targets[found->second].get() : nullptr;
	}

	[[nodiscard]] Iterator begin() const { return { *this, 0, _targets.size() }; }
	[[nodiscard]] Iterator end() const { return { *this, 0, 0 }; }
	/// Those of a condition, the latest first.
	template <class Condition>
	[[nodiscard]] std::vector<Target *> select(const Condition &condition) const {
		std::vector<Target *> found;
		for (size_t i = _targets.size(); i-- > 0;) {
			if (!_targets[i]->is_removed && condition(*_targets[i])) {
				found.push_back(_targets[i].get());
			}
		}
		return found;
	}

private:
	std::vector<std::unique_ptr<Target>> _targets;
	std::unordered_map<uint64_t, size_t> _index; // into _targets; without removed ones
	bool _is_swept = true; // no target is marked as removed
};

} // namespace ga_godot
