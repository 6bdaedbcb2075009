#pragma once

#include "net/session/session.hpp"

#include <cstdint>
#include <optional>

namespace net {

/// Where the motion of a body comes from.
struct BodySource {
	PeerId owner = 0;
	uint32_t body = 0;
	uint64_t min_life = 0; ///< lives before it belong to an earlier node of the same name
};

/// What to show of one body, across changes of its owner and its name: the old source until its end, then the new one from
/// its first motion on.
class BodyView {
public:
	enum class Phase {
		UNKNOWN, ///< no pose is known
		UNBORN, ///< playback has not reached the first pose, which is shown
		PREVIOUS, ///< the new source shows nothing yet; the old one does, or did until its end
		HELD, ///< the source has ended, or the old stream has closed before the new source begins: in the first frame, the last pose
		CURRENT,
		ENDED, ///< playback has reached the end of the body, which its owner has freed: in the first frame, the last pose
	};

	struct Frame {
		Phase phase = Phase::UNKNOWN;
		std::optional<cga::Pose<double>> pose; ///< in PREVIOUS and HELD, in the space of the old source
		std::optional<cga::Pose<double>> previous_pose; ///< of the old source in the frame in which CURRENT begins
		bool begins = false; ///< the first frame of CURRENT
	};

	/// Follows another source. The current one becomes the old one, if it has shown anything.
	void follow(const BodySource &source, double now);
	/// The node has shown the body by other means: its first pose is not shown ahead of time.
	void mark_shown() { _has_shown = true; }
	/// What to show at the session's media time.
	Frame frame(const Session &session, double now);

	[[nodiscard]] bool has_shown() const { return _has_shown; }
	/// Local time of the last `follow`.
	[[nodiscard]] double followed_at() const { return _followed_at; }
	/// True while an old source is shown until the new one begins.
	[[nodiscard]] bool has_previous() const { return _previous.has_value(); }
	/// The life that was shown last; 0 if none.
	[[nodiscard]] uint64_t life() const { return _life; }

private:
	[[nodiscard]] std::optional<cga::Pose<double>> previous_pose(const Session &session) const;

	BodySource _source;
	uint64_t _life = 0; // shown of _source
	bool _is_current = false; // _source has been shown
	bool _is_held = false; // _source has ended, and its last pose was shown
	std::optional<BodySource> _previous;
	std::optional<cga::Pose<double>> _last_pose; // shown of _previous, or of _source
	uint64_t _previous_life = 0;
	bool _has_shown = false;
	double _followed_at = 0.0;
};

} // namespace net
