#include "net/endpoint/forwarded_stream.hpp"

#include <algorithm>
#include <memory>

namespace net {

void ForwardedStream::add_receiver(uint32_t receiver, double time) {
	_receivers.insert_or_assign(receiver, Delivery(time));
}

void ForwardedStream::set_held(bool held, double time) {
	if (_is_held && !held) {
		restart(time);
	}
	_is_held = held;
}

void ForwardedStream::restart(double time) {
	for (auto &entry : _receivers) {
		entry.second.restart(time);
	}
}

void ForwardedStream::resend_all(uint32_t receiver) {
	const auto found = _receivers.find(receiver);
	if (found != _receivers.end()) {
		found->second.restart();
	}
}

void ForwardedStream::update(double time, size_t max_size) {
	if (_source.snapshot_count() != _source_snapshots) {
		_source_snapshots = _source.snapshot_count();
		restart(time);
	}
	if (!_source.is_ready() || _is_held) {
		return;
	}
	uint32_t oldest_needed = 0xffffffff;
	for (const auto &entry : _receivers) {
		oldest_needed = entry.second.is_silent(time) ? oldest_needed : std::min(oldest_needed, entry.second.first_missing());
	}
	_source.record(max_size, oldest_needed);
	// As in Sender::send_all.
	const double max_wait = 2.0 * _source.settings().max_latency - _source.max_window();
	std::shared_ptr<Snapshot> snapshot; // the same one for all
	for (auto &entry : _receivers) {
		Delivery &delivery = entry.second;
		delivery.set_max_wait(max_wait);
		delivery.set_snapshot_size(Snapshot::estimate(_source.stream_size()));
		if (!delivery.needs_snapshot() || delivery.is_silent(time)) {
			continue;
		}
		if (snapshot == nullptr) {
			snapshot = std::make_shared<Snapshot>();
			snapshot->number = ++_snapshot_number;
			snapshot->next_chunk = _source.recorded()->next();
			snapshot->fragment_size = Snapshot::fragment_size_for(max_size);
			_source.encode_snapshot(snapshot->bytes);
		}
		delivery.start_snapshot(snapshot);
	}
}

void ForwardedStream::accept(uint32_t receiver, PacketContent &acks, double time) {
	const auto found = _receivers.find(receiver);
	if (found == _receivers.end()) {
		return;
	}
	Delivery &delivery = found->second;
	// A receiver that has everything requests a snapshot if the owner is silent. A snapshot would tell it nothing.
	acks.requests_snapshot = acks.requests_snapshot && !delivery.is_complete(*_source.recorded());
	delivery.accept(acks, *_source.recorded(), time);
}

} // namespace net
