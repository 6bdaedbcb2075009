#include "godot/net/motor_synchronizer.hpp"

#include "godot/net/setup_warnings.hpp"
#include "godot/net/spatial_node.hpp"

#include <godot_cpp/core/object.hpp>

#include <utility>

namespace ga_godot {

using godot::Dictionary;
using godot::MultiplayerAPI;
using godot::Node;
using godot::PackedByteArray;
using godot::PackedStringArray;
using godot::Ref;
using godot::SceneMultiplayer;
using godot::TypedArray;
using godot::vformat;

// Runs after the scripts that move targets in a tick, and before those that read them in a frame.
static constexpr int32_t AFTER_OTHERS = 1000;
static constexpr int32_t BEFORE_OTHERS = -1000;
static constexpr int64_t FRAMES_BETWEEN_CHECKS = 60;

MotorSynchronizer::MotorSynchronizer() {
	set_physics_process_priority(AFTER_OTHERS);
	set_process_priority(BEFORE_OTHERS);
}

void MotorSynchronizer::_notification(int what) {
	if (what == NOTIFICATION_PREDELETE) {
		Replicator::free_guard().before_free(*this);
		return;
	}
	const FreeGuard::Scope scope(Replicator::free_guard());
	switch (what) {
		case NOTIFICATION_ENTER_TREE:
			add_to_group(SYNCHRONIZER_GROUP);
			set_process_internal(true);
			if (!is_part_of_edited_scene()) {
				start();
			}
			break;
		case NOTIFICATION_EXIT_TREE:
			remove_from_group(SYNCHRONIZER_GROUP);
			if (_is_running) {
				stop();
			}
			break;
		case NOTIFICATION_INTERNAL_PHYSICS_PROCESS:
			if (is_in_main_thread()) {
				update_replicator();
				if (_replicator != nullptr) {
					_replicator->tick();
				}
			}
			break;
		case NOTIFICATION_INTERNAL_PROCESS:
			if (!_is_running) {
				watch_warnings();
				break;
			}
			if (is_in_main_thread()) {
				update_replicator();
				if (_replicator != nullptr) {
					_replicator->frame();
				}
			}
			break;
		default:
			break;
	}
}

void MotorSynchronizer::start() {
	_is_running = true;
	_selection.invalidate();
	set_physics_process_internal(true);
}

void MotorSynchronizer::stop() {
	leave_replicator();
	set_physics_process_internal(false);
	_is_running = false;
}

/// Reports once that another thread processes the node. Nothing is replicated then.
bool MotorSynchronizer::is_in_main_thread() {
	if (is_main_thread()) {
		return true;
	}
	if (!_is_thread_reported) {
		_is_thread_reported = true;
		ERR_PRINT(vformat("MotorSynchronizer %s: nothing is replicated. %s", get_path(), thread_fault(*this)));
	}
	return false;
}

/// Joins the replicator of the node's MultiplayerAPI, which a game may replace at any time.
void MotorSynchronizer::update_replicator() {
	const Ref<MultiplayerAPI> multiplayer = get_multiplayer();
	const Ref<SceneMultiplayer> api = multiplayer;
	if (_replicator != nullptr ? api == _replicator->api() : api.is_null() && _is_api_reported) {
		return;
	}
	leave_replicator();
	if (!is_inside_tree()) {
		return; // A callback has removed the node.
	}
	if (api.is_null()) {
		if (multiplayer.is_valid() && !_is_api_reported) {
			_is_api_reported = true;
			ERR_PRINT(vformat("MotorSynchronizer %s: the MultiplayerAPI is a %s. Only Godot's own SceneMultiplayer is supported; nothing is replicated.", get_path(), multiplayer->get_class()));
		}
		return;
	}
	_selection.invalidate();
	_selection.forget();
	_replicator = Replicator::of(api);
	_replicator->add(this);
}

void MotorSynchronizer::leave_replicator() {
	if (const std::shared_ptr<Replicator> replicator = std::exchange(_replicator, nullptr)) {
		replicator->remove(this);
	}
}

void MotorSynchronizer::settings_changed() {
	if (_replicator != nullptr) {
		_replicator->update_settings();
	}
}

void MotorSynchronizer::add_target(Node *node) {
	ERR_FAIL_NULL_MSG(node, "MotorSynchronizer.add_target: the node is null.");
	ERR_FAIL_COND_MSG(!is_spatial(node), vformat("MotorSynchronizer.add_target: %s is a %s, but must be a Node3D or a Node2D.", node->get_name(), node->get_class()));
	_selection.add(node->get_instance_id());
	if (_replicator != nullptr) {
		_replicator->refresh(this);
	}
}

void MotorSynchronizer::remove_target(Node *node) {
	ERR_FAIL_NULL_MSG(node, "MotorSynchronizer.remove_target: the node is null.");
	_selection.remove(node->get_instance_id());
	if (_replicator != nullptr) {
		_replicator->refresh(this);
	}
}

TypedArray<Node> MotorSynchronizer::get_active_targets() const {
	return _replicator != nullptr ? _replicator->targets_of(this) : TypedArray<Node>();
}

Target *MotorSynchronizer::find_own_target(Node *node, const char *method) {
	ERR_FAIL_NULL_V_MSG(node, nullptr, vformat("MotorSynchronizer.%s: the node is null.", method));
	Target *target = _replicator != nullptr ? _replicator->find_target(node) : nullptr;
	ERR_FAIL_NULL_V_MSG(target, nullptr, vformat("MotorSynchronizer.%s: %s is not a target of %s.", method, node->get_name(), get_name()));
	const int32_t authority = node->get_multiplayer_authority();
	const net::Session &session = _replicator->session();
	ERR_FAIL_COND_V_MSG(session.is_connected() && authority != session.self(), nullptr, vformat("MotorSynchronizer.%s: only the authority of %s, peer %d, can %s it.", method, node->get_name(), authority, godot::String(method).get_slice("_", 0)));
	return target;
}

void MotorSynchronizer::teleport(Node *node) {
	if (const Target *target = find_own_target(node, "teleport")) {
		_replicator->session().teleport(target->body);
	}
}

void MotorSynchronizer::free_target(Node *node) {
	if (Target *target = find_own_target(node, "free_target")) {
		_replicator->free_target(*target);
	}
}

void MotorSynchronizer::_on_peer_packet(int64_t peer, const PackedByteArray &packet) {
	if (_replicator != nullptr) {
		_replicator->packet_received(int32_t(peer), packet);
	}
}

void MotorSynchronizer::_on_peer_disconnected(int64_t peer) {
	if (_replicator != nullptr) {
		_replicator->peer_left(int32_t(peer));
	}
}

void MotorSynchronizer::_on_physics_frame() {
	if (_replicator != nullptr) {
		_replicator->before_scripts();
	}
}

void MotorSynchronizer::_on_target_exiting(int64_t id) {
	if (_replicator != nullptr) {
		_replicator->target_exiting(uint64_t(id));
	}
}

void MotorSynchronizer::_on_node_renamed(Node *node) {
	if (_replicator != nullptr && node != nullptr) {
		_replicator->node_renamed(node);
	}
}

double MotorSynchronizer::get_media_time(int64_t peer) const {
	return _replicator != nullptr ? _replicator->session().media_time(int32_t(peer)) : 0.0;
}

Dictionary MotorSynchronizer::get_statistics() {
	const double now = clock_seconds();
	Dictionary result = to_dictionary(_replicator != nullptr ? _replicator->session().total_statistics(now) : net::SessionStatistics());
	Dictionary peers;
	if (_replicator != nullptr) {
		for (const int32_t peer : _replicator->session().peers()) {
			peers[peer] = to_dictionary(_replicator->session().statistics(peer, now));
		}
	}
	result["peers"] = peers;
	return result;
}

godot::Variant MotorSynchronizer::_get_monitor(const godot::StringName &key) {
	return get_statistics()[key];
}

PackedStringArray MotorSynchronizer::get_setup_warnings() const {
	const FreeGuard::Scope scope(Replicator::free_guard());
	PackedStringArray warnings = is_inside_tree() ? find_setup_faults(*this, _selection) : PackedStringArray();
	const PackedStringArray found = _replicator != nullptr ? _replicator->warnings() : PackedStringArray();
	for (int64_t i = 0; i < found.size(); i++) {
		if (!warnings.has(found[i])) {
			warnings.push_back(found[i]);
		}
	}
	return warnings;
}

PackedStringArray MotorSynchronizer::_get_configuration_warnings() const {
	return get_setup_warnings();
}

/// Updates the warnings in the editor, which does not report changes of groups and other nodes.
void MotorSynchronizer::watch_warnings() {
	if (--_frames_to_check > 0) {
		return;
	}
	_frames_to_check = FRAMES_BETWEEN_CHECKS;
	const PackedStringArray warnings = get_setup_warnings();
	if (!(warnings == _shown_warnings)) {
		_shown_warnings = warnings;
		update_configuration_warnings();
	}
}

} // namespace ga_godot
