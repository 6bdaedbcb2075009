#include "net/delivery/state_parts.hpp"

namespace net {

void StateParts::start(const StatePartItem &part) {
	open_ = true;
	number_ = part.state;
	next_chunk_ = part.next_chunk;
	parts_.assign(part.parts, Part());
	missing_ = part.parts;
}

bool StateParts::add(const StatePartItem &part) {
	Part &place = parts_[part.part];
	if (place.arrived) {
		return false;
	}
	place.arrived = true;
	place.bytes.assign(part.bytes, part.bytes + part.size);
	--missing_;
	return true;
}

void StateParts::close(std::vector<std::uint8_t> &bytes) {
	open_ = false;
	bytes.clear();
	for (const Part &part : parts_) {
		bytes.insert(bytes.end(), part.bytes.begin(), part.bytes.end());
	}
}

StateAckItem StateParts::ack(bool is_done) const {
	StateAckItem ack;
	ack.state = number_;
	while (ack.next < parts_.size() && (is_done || parts_[ack.next].arrived)) {
		++ack.next;
	}
	for (std::size_t bit = 0; bit < 32 && ack.next + 1 + bit < parts_.size(); ++bit) {
		ack.later |= parts_[ack.next + 1 + bit].arrived ? std::uint32_t(1) << bit : 0;
	}
	return ack;
}

} // namespace net
