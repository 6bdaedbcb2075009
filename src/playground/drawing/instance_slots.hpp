#pragma once

#include <cstddef>
#include <vector>

// Which slot of a dense row is whose, while owners come and go: the last one moves into a slot that becomes free. So a
// row of instances is drawn by its length alone, and nothing is drawn that is not there.

namespace playground::drawing {

class InstanceSlots {
public:
	[[nodiscard]] size_t size() const { return _owners.size(); }
	[[nodiscard]] size_t slot_of(size_t owner) const { return _slots[owner]; }

	// A new owner, whose slot is the last. Numbers of removed owners are given again.
	size_t add() {
		size_t owner = _slots.size();
		if (_removed.empty()) {
			_slots.push_back(0);
		} else {
			owner = _removed.back();
			_removed.pop_back();
		}
		_slots[owner] = _owners.size();
		_owners.push_back(owner);
		return owner;
	}

	// The slot that becomes free. Unless it is the new size(), what was in slot size() belongs there now.
	size_t remove(size_t owner) {
		const size_t slot = _slots[owner];
		_owners[slot] = _owners.back();
		_slots[_owners[slot]] = slot;
		_owners.pop_back();
		_removed.push_back(owner);
		return slot;
	}

private:
	std::vector<size_t> _slots; // by owner
	std::vector<size_t> _owners; // by slot
	std::vector<size_t> _removed;
};

} // namespace playground::drawing
