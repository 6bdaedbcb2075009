#include "net/session/relay.hpp"

namespace net {

/// Channels are reused as late as possible, so that late packets of a stream are not mistaken for those of another.
uint32_t Relay::free_channel() {
	do {
		_last_channel = _last_channel % (Section::CHANNEL_LIMIT - 1) + 1;
	} while (_channels.count(_last_channel) != 0);
	return _last_channel;
}

void Relay::add_stream(PeerId owner, Receiver &source, double now) {
	source.record(StreamSettings().max_packet_size);
	const uint32_t channel = free_channel();
	_channels[channel] = owner;
	Stream &stream = _streams.emplace(owner, Stream{ channel, &source, ForwardedStream(source), GRACE, {}, {}, 0, 0.0 }).first->second;
	for (const auto &entry : _clients) {
		if (entry.first != owner) {
			stream.forwarded.add_receiver(uint32_t(entry.first), now);
		}
	}
}

std::optional<uint32_t> Relay::remove_stream(PeerId owner) {
	const auto found = _streams.find(owner);
	if (found == _streams.end()) {
		return std::nullopt;
	}
	const uint32_t channel = found->second.channel;
	const bool is_known = found->second.source->is_ready();
	_channels.erase(channel);
	_streams.erase(found);
	return is_known ? std::optional(channel) : std::nullopt;
}

void Relay::add_client(PeerId client, double now) {
	remove_client(client);
	_clients.try_emplace(client);
	for (auto &[owner, stream] : _streams) {
		if (owner != client) {
			stream.forwarded.add_receiver(uint32_t(client), now);
		}
	}
}

void Relay::remove_client(PeerId client) {
	_clients.erase(client);
	for (auto &entry : _streams) {
		entry.second.forwarded.remove_receiver(uint32_t(client));
		entry.second.known_by.erase(client);
	}
}

void Relay::note_arrival(PeerId owner, double now) {
	const auto found = _streams.find(owner);
	if (found == _streams.end() || found->second.chunks == found->second.source->recorded()->next()) {
		return;
	}
	Stream &stream = found->second;
	const double length = (stream.source->known_time() - stream.known_time) / double(stream.source->recorded()->next() - stream.chunks);
	stream.aligner.add_arrival(_schedule.lead(now), length, now);
	stream.chunks = stream.source->recorded()->next();
	stream.known_time = stream.source->known_time();
}

std::optional<AlignItem> Relay::take_alignment(PeerId owner, double now) {
	const auto found = _streams.find(owner);
	if (found == _streams.end()) {
		return std::nullopt;
	}
	return found->second.aligner.take_request(_schedule.period(), _schedule.tick(), now);
}

void Relay::add_own_packet(PeerId client, const uint8_t *bytes, size_t size) {
	Client &to = _clients[client];
	to.sections.push_back({ Section::SERVER_CHANNEL, 0, to.bytes.size(), size });
	to.bytes.insert(to.bytes.end(), bytes, bytes + size);
}

void Relay::resend_all(PeerId client) {
	for (auto &entry : _streams) {
		entry.second.forwarded.resend_all(uint32_t(client));
	}
}

void Relay::update(double now, size_t max_size) {
	for (auto &entry : _streams) {
		entry.second.source->record(max_size);
		entry.second.forwarded.update(now, max_size);
	}
}

void Relay::collect(PeerId id, Client &client, double now, size_t max_size) {
	for (auto &[owner, stream] : _streams) {
		if (stream.aligner.is_aligned() && _schedule.holds(stream.aligner.max_lead(), now)) {
			continue;
		}
		const Section section{ stream.channel, stream.known_by.count(id) != 0 ? 0 : owner };
		stream.forwarded.send(uint32_t(id), now, max_size, client.bytes, [&](size_t begin, size_t size) { client.sections.push_back({ section.channel, section.owner, begin, size }); });
	}
}

PacketResult Relay::accept_section(PeerId client, const Section &section, const uint8_t *bytes, double now) {
	if (const PacketResult result = read_packet(bytes + section.begin, section.size, _content); !result) {
		return result;
	}
	const auto channel = _channels.find(section.channel);
	if (channel == _channels.end() || !has_client(client)) {
		return {}; // the stream has ended
	}
	Stream &stream = _streams.at(channel->second);
	stream.known_by.insert(client);
	stream.forwarded.accept(uint32_t(client), _content, now);
	return {};
}

} // namespace net
