#include "net/delivery/state_parts.hpp"

namespace net {

void StateParts::start(const StatePartItem &part) {
	_open = true;
	_number = part.state;
	_next_chunk = part.next_chunk;
	_parts.assign(part.parts, Part());
	_missing = part.parts;
}

bool StateParts::add(const StatePartItem &part) {
	Part &place = _parts[part.part];
	if (place.arrived) {
		return false;
	}
	place.arrived = true;
	place.bytes.assign(part.bytes, part.bytes + part.size);
	--_missing;
	return true;
}

void StateParts::close(std::vector<uint8_t> &bytes) {
	_open = false;
	bytes.clear();
	for (const Part &part : _parts) {
		bytes.insert(bytes.end(), part.bytes.begin(), part.bytes.end());
	}
}

StateAckItem StateParts::ack(bool is_done) const {
	StateAckItem ack;
	ack.state = _number;
	while (ack.next < _parts.size() && (is_done || _parts[ack.next].arrived)) {
		++ack.next;
	}
	for (size_t bit = 0; bit < 32 && ack.next + 1 + bit < _parts.size(); ++bit) {
		ack.later |= _parts[ack.next + 1 + bit].arrived ? uint32_t(1) << bit : 0;
	}
	return ack;
}

} // namespace net
