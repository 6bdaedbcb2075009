#pragma once

#include "net/session/session_statistics.hpp"

#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/string.hpp>

namespace ga_godot {

[[nodiscard]] godot::Dictionary to_dictionary(const net::SessionStatistics &statistics);

/// The custom monitors of a node in the editor's debugger: "ga_godot/NAME/bytes_per_second" and so on.
class StatisticsMonitors {
public:
	/// `read` returns the value of a key of `to_dictionary`.
	void add(const godot::String &node_name, const godot::Callable &read);
	void remove();

private:
	godot::String _prefix;
};

} // namespace ga_godot
