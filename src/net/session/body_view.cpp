#include "net/session/body_view.hpp"

namespace net {

namespace {

/// If no new life of a body has begun after this many seconds, its new node shows the old life: only the node was replaced.
constexpr double MAX_WAIT = 0.75;

} // namespace

void BodyView::follow(const BodySource &source, double now) {
	if (_is_current) {
		_previous = _source;
		_previous_life = _life;
	}
	_source = source;
	_life = 0;
	_is_current = _is_held = false;
	_followed_at = now;
}

/// The pose of the old source, or its last one if it has ended.
std::optional<cga::Pose<double>> BodyView::previous_pose(const Session &session) const {
	const Receiver *stream = _previous ? session.stream(_previous->owner) : nullptr;
	if (stream == nullptr) {
		return std::nullopt;
	}
	const std::optional<ShownBody> shown = stream->shown(_previous->body);
	return shown && shown->life == _previous_life ? std::optional(shown->pose) : stream->last_pose(_previous->body, _previous_life);
}

BodyView::Frame BodyView::frame(const Session &session, double now) {
	Frame frame;
	const uint64_t min_life = now - _followed_at < MAX_WAIT ? _source.min_life : 0;
	const Receiver *stream = session.stream(_source.owner);
	const std::optional<ShownBody> shown = stream != nullptr ? stream->shown(_source.body) : std::nullopt;
	// At the beginning of a stream, bodies are at their first poses. The old source comes to its end first.
	const bool is_early = shown && shown->is_early && _previous && !_is_current;
	if (shown && shown->life >= min_life && !is_early) {
		frame.phase = Phase::CURRENT;
		frame.pose = shown->pose;
		frame.begins = !_is_current;
		if (frame.begins) {
			frame.previous_pose = previous_pose(session);
		}
		_previous.reset();
		_last_pose = shown->pose;
		_life = shown->life;
		_is_current = _has_shown = true;
		_is_held = false;
		return frame;
	}
	if (_is_current) {
		const bool is_freed = stream != nullptr && stream->end(_source.body, _life) == BodyEnd::FREED;
		frame.phase = is_freed ? Phase::ENDED : Phase::HELD;
		// The game may move the node from then on.
		frame.pose = stream != nullptr && !_is_held ? stream->last_pose(_source.body, _life) : std::nullopt;
		_is_held = true;
		return frame;
	}
	if (_previous) {
		frame.pose = previous_pose(session);
		frame.phase = frame.pose ? Phase::PREVIOUS : Phase::HELD;
		frame.pose = _last_pose = frame.pose ? frame.pose : _last_pose;
		return frame;
	}
	if (!_has_shown && stream != nullptr) {
		const std::optional<ShownBody> first = stream->first_known(_source.body, min_life);
		frame.pose = first ? std::optional(first->pose) : std::nullopt;
		frame.phase = first ? Phase::UNBORN : Phase::UNKNOWN;
	}
	return frame;
}

} // namespace net
