#pragma once

#include "net/session/session_statistics.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/string.hpp>

namespace ga_godot {

[[nodiscard]] godot::Dictionary to_dictionary(const net::SessionStatistics &statistics);

/// The custom monitors of a node in the editor's debugger: "ga_godot/NAME/bytes_per_second" and so on. A monitor calls
/// _get_monitor(key) of the node.
class StatisticsMonitors {
public:
	void add(godot::Node *node);
	void remove();

private:
	godot::String _prefix;
};

} // namespace ga_godot
