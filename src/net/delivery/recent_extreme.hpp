#pragma once

#include <algorithm>

namespace net {

/// The maximum or minimum of recent values, over the current time span and the previous one.
class RecentExtreme {
public:
	/// `sign` 1 for the maximum, -1 for the minimum; `span` in seconds.
	RecentExtreme(double sign, double span) :
			_sign(sign), _span(span) {}

	void add(double value, double now) {
		if (_empty) {
			_current = _previous = value;
			_begin = now;
			_empty = false;
			return;
		}
		if (now - _begin > _span) {
			_previous = _current;
			_current = value;
			_begin = now;
		}
		_current = _sign * std::max(_sign * _current, _sign * value);
	}
	void clear() { *this = RecentExtreme(_sign, _span); }
	[[nodiscard]] double value() const { return _sign * std::max(_sign * _current, _sign * _previous); }
	[[nodiscard]] bool is_empty() const { return _empty; }

private:
	double _sign;
	double _span;
	double _current = 0.0;
	double _previous = 0.0;
	double _begin = 0.0;
	bool _empty = true;
};

} // namespace net
