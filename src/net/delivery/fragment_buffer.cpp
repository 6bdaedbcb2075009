#include "net/delivery/fragment_buffer.hpp"

namespace net {

void FragmentBuffer::start(const FragmentItem &fragment) {
	_open = true;
	_number = fragment.snapshot;
	_next_chunk = fragment.next_chunk;
	_fragments.assign(fragment.count, Fragment());
	_missing = fragment.count;
}

bool FragmentBuffer::add(const FragmentItem &fragment) {
	Fragment &slot = _fragments[fragment.index];
	if (slot.arrived) {
		return false;
	}
	slot.arrived = true;
	slot.bytes.assign(fragment.bytes, fragment.bytes + fragment.size);
	--_missing;
	return true;
}

void FragmentBuffer::finish(std::vector<uint8_t> &bytes) {
	_open = false;
	bytes.clear();
	for (const Fragment &fragment : _fragments) {
		bytes.insert(bytes.end(), fragment.bytes.begin(), fragment.bytes.end());
	}
}

SnapshotAckItem FragmentBuffer::ack(bool is_done) const {
	SnapshotAckItem ack;
	ack.snapshot = _number;
	while (ack.next < _fragments.size() && (is_done || _fragments[ack.next].arrived)) {
		++ack.next;
	}
	for (size_t bit = 0; bit < 32 && ack.next + 1 + bit < _fragments.size(); ++bit) {
		ack.later |= _fragments[ack.next + 1 + bit].arrived ? uint32_t(1) << bit : 0;
	}
	return ack;
}

} // namespace net
