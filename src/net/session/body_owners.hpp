#pragma once

#include "net/endpoint/receiver.hpp"
#include "net/session/outbox.hpp"
#include "net/session/relayed_streams.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace net {

/// The owners of the bodies that exist at this peer.
class BodyOwners {
public:
	[[nodiscard]] std::optional<PeerId> find(uint32_t body) const {
		const auto found = _owners.find(body);
		return found != _owners.end() ? std::optional(found->second.peer) : std::nullopt;
	}
	/// Its priority is then 0.
	void set(uint32_t body, PeerId owner) {
		remove(body);
		_owners[body].peer = owner;
		++_counts[owner];
	}
	void remove(uint32_t body) {
		const auto found = _owners.find(body);
		if (found != _owners.end()) {
			--_counts[found->second.peer];
			_owners.erase(found);
		}
	}
	void clear() {
		_owners.clear();
		_counts.clear();
	}
	/// See Sender::set_priority. The body must exist.
	void set_priority(uint32_t body, int priority) { _owners.at(body).priority = priority; }
	[[nodiscard]] int priority(uint32_t body) const {
		const auto found = _owners.find(body);
		return found != _owners.end() ? found->second.priority : 0;
	}
	/// Number of bodies of an owner.
	[[nodiscard]] size_t count(PeerId owner) const {
		const auto found = _counts.find(owner);
		return found != _counts.end() ? found->second : 0;
	}

	/// Number of bodies that a peer's stream may have without being unusual: the server may send whatever clients do not know yet.
	[[nodiscard]] size_t expected(PeerId sender) const { return sender == RelayedStreams::SERVER ? RelayedStreams::MAX_STREAM_BODIES : count(sender); }

	[[nodiscard]] bool exists(uint32_t body) const { return _owners.count(body) != 0; }
	/// True if the body belongs to another peer. False if the body does not exist here.
	[[nodiscard]] bool is_unauthorized(PeerId sender, uint32_t body) const { return find(body).value_or(sender) != sender; }
	/// Takes the events of a stream and returns the number of new bodies that its sender does not own. They are not shown. This is
	/// not an error: when a body changes its owner, peers are notified at different times.
	[[nodiscard]] size_t count_unauthorized(PeerId sender, Receiver &stream) {
		stream.take_events(_events);
		return size_t(std::count_if(_events.begin(), _events.end(), [&](const BodyEvent &event) { return event.kind == BodyEvent::ADDED && is_unauthorized(sender, event.id); }));
	}

private:
	struct Owner {
		PeerId peer = 0;
		int priority = 0;
	};

	std::unordered_map<uint32_t, Owner> _owners; // by body
	std::unordered_map<PeerId, size_t> _counts; // by owner
	std::vector<BodyEvent> _events;
};

} // namespace net
