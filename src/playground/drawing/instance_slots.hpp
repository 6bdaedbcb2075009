#pragma once

#include <cstddef>
#include <vector>

// Assigns slots of a dense array to owners. When an owner is removed, the last slot moves into the freed one, so that the
// first size() slots are always in use.

namespace playground::drawing {

class InstanceSlots {
public:
	[[nodiscard]] size_t size() const { return _owners.size(); }
	[[nodiscard]] size_t slot_of(size_t owner) const { return _slots[owner]; }

	// Returns a new owner, whose slot is the last one. IDs of removed owners are reused.
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

	// Returns the freed slot. Unless it equals the new size(), the caller must move the data of slot size() there.
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
