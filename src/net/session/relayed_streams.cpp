#include "net/session/relayed_streams.hpp"

#include <algorithm>
#include <iterator>

namespace net {

void RelayedStreams::set_margin_limits(double min, double max) {
	_min_margin = min;
	_max_margin = max;
	for (auto &entry : _streams) {
		entry.second.receiver.set_margin_limits(min, max);
	}
}

void RelayedStreams::clear() {
	while (!_streams.empty()) {
		remove(_streams.begin()->first);
	}
	_ended.clear();
}

void RelayedStreams::remove(PeerId owner) {
	const auto found = _streams.find(owner);
	_late += found->second.receiver.statistics().late_windows;
	_held_bodies -= found->second.held_bodies;
	_channels.erase(found->second.channel);
	_streams.erase(found);
}

PacketResult RelayedStreams::accept(PeerId self, const uint8_t *bytes, size_t size, double now, Receiver &server) {
	return read_sections(bytes, size, [&](const Section &section) {
		return section.channel == Section::SERVER_CHANNEL ? server.accept(bytes + section.begin, section.size, now) : accept_section(self, section, bytes, now);
	});
}

PacketResult RelayedStreams::accept_section(PeerId self, const Section &section, const uint8_t *bytes, double now) {
	if (section.owner == self || section.owner == SERVER) {
		return PacketError::BAD_SECTION;
	}
	auto channel = _channels.find(section.channel);
	if (section.owner != 0 && (channel == _channels.end() || channel->second != section.owner)) {
		if (const auto ended = _ended.find(section.channel); ended != _ended.end() && now - ended->second < LATE_PACKET_TIME) {
			return {};
		}
		if (const PacketResult result = open(section.owner, section.channel, now); !result) {
			return result;
		}
		channel = _channels.find(section.channel);
	}
	if (channel == _channels.end()) {
		return {}; // late, or overtook the packet that names the owner: the server repeats it
	}
	Stream &stream = _streams.at(channel->second);
	stream.received.add(section.size, now);
	_held_bodies -= stream.held_bodies;
	stream.receiver.set_max_bodies(std::min(MAX_STREAM_BODIES, MAX_BODIES - std::min(_held_bodies, MAX_BODIES)));
	const PacketResult result = stream.receiver.accept(bytes + section.begin, section.size, now);
	stream.held_bodies = stream.receiver.held_bodies();
	_held_bodies += stream.held_bodies;
	return result;
}

PacketResult RelayedStreams::open(PeerId owner, uint32_t channel, double now) {
	if (_channels.count(channel) != 0) {
		end(channel, now);
	}
	if (find(owner) != nullptr) {
		end(find(owner)->channel, now);
	}
	if (_streams.size() >= MAX_STREAMS) {
		return PacketError::TOO_MANY_STREAMS;
	}
	Stream &stream = _streams.try_emplace(owner, _work).first->second;
	stream.channel = channel;
	stream.receiver.set_margin_limits(_min_margin, _max_margin);
	_channels[channel] = owner;
	return {};
}

void RelayedStreams::end(uint32_t channel, double now) {
	for (auto ended = _ended.begin(); ended != _ended.end();) {
		ended = now - ended->second < LATE_PACKET_TIME ? std::next(ended) : _ended.erase(ended);
	}
	if (_ended.size() < MAX_STREAMS) {
		_ended[channel] = now;
	}
	if (const auto found = _channels.find(channel); found != _channels.end()) {
		remove(found->second);
	}
}

void RelayedStreams::collect_acks(double now, Receiver &server) {
	_sections.clear();
	_bytes.clear();
	add_ack(Section::SERVER_CHANNEL, server, now);
	for (auto &entry : _streams) {
		add_ack(entry.second.channel, entry.second.receiver, now);
	}
}

void RelayedStreams::add_ack(uint32_t channel, Receiver &receiver, double now) {
	receiver.take_ack(_ack, now);
	if (!_ack.empty()) {
		_sections.push_back({ channel, 0, _bytes.size(), _ack.size() });
		_bytes.insert(_bytes.end(), _ack.begin(), _ack.end());
	}
}

std::vector<PeerId> RelayedStreams::owners() const {
	std::vector<PeerId> owners;
	owners.reserve(_streams.size());
	for (const auto &entry : _streams) {
		owners.push_back(entry.first);
	}
	return owners;
}

SessionStatistics RelayedStreams::statistics(PeerId owner, double now) {
	SessionStatistics result;
	if (Stream *stream = find(owner)) {
		const StreamStatistics &received = stream->receiver.statistics();
		result.received_bytes = stream->received.bytes_per_second(now);
		result.received_packets = stream->received.packets_per_second(now);
		result.loss = received.loss;
		result.round_trip = received.round_trip;
		result.playback_delay = received.playback_delay;
		result.late = received.late_windows;
		result.unauthorized = stream->unauthorized_bodies;
	}
	return result;
}

SessionStatistics RelayedStreams::total_statistics(double now) {
	SessionStatistics total;
	for (const auto &entry : _streams) {
		total.add(statistics(entry.first, now));
	}
	total.received_bytes = total.received_packets = 0.0;
	total.late += _late;
	return total;
}

} // namespace net
