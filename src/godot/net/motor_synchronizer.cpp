#include "godot/net/motor_synchronizer.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/variant/callable.hpp>

#include <chrono>
#include <cmath>

// The node's life: what happens when it enters and leaves the tree, in each physics tick and in each frame.

namespace ga_godot {

using godot::Callable;
using godot::Engine;

// Behind what moves the targets in a tick, before what looks at them in a frame.
static constexpr int32_t AFTER_OTHERS = 1000;
static constexpr int32_t BEFORE_OTHERS = -1000;

MotorSynchronizer::MotorSynchronizer() {
	set_physics_process_priority(AFTER_OTHERS);
	set_process_priority(BEFORE_OTHERS);
}

double MotorSynchronizer::clock() {
	return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void MotorSynchronizer::_notification(int p_what) {
	switch (p_what) {
		case NOTIFICATION_ENTER_TREE:
			add_to_group(GROUP);
			set_process_internal(true);
			if (!is_part_of_edited_scene()) {
				start();
			}
			break;
		case NOTIFICATION_EXIT_TREE:
			remove_from_group(GROUP);
			if (_running) {
				stop();
			}
			break;
		case NOTIFICATION_INTERNAL_PHYSICS_PROCESS:
			physics_tick();
			break;
		case NOTIFICATION_INTERNAL_PROCESS:
			if (_running) {
				frame();
			} else {
				watch_warnings();
			}
			break;
	}
}

void MotorSynchronizer::start() {
	_running = true;
	_now = clock();
	_targets_stale = true;
	_rejected = 0;
	_late = 0;
	set_physics_process_internal(true);
	get_tree()->connect("node_renamed", Callable(this, "_on_node_renamed"));
	add_monitors();
}

void MotorSynchronizer::stop() {
	say_goodbye();
	leave_connection();
	if (_api.is_valid()) {
		_api->disconnect("peer_packet", Callable(this, "_on_peer_packet"));
		_api.unref();
	}
	while (!_targets.empty()) {
		end_target(_targets.size() - 1);
	}
	_refused.clear();
	get_tree()->disconnect("node_renamed", Callable(this, "_on_node_renamed"));
	remove_monitors();
	set_physics_process_internal(false);
	_running = false;
}

void MotorSynchronizer::physics_tick() {
	_now = clock();
	update_connection();
	if (_names_stale) {
		rename_targets();
	}
	refresh_targets();
	if (_connected.empty()) {
		return;
	}
	const double tick = 1.0 / double(Engine::get_singleton()->get_physics_ticks_per_second());
	if (tick != _settings.tick) {
		// Whole ticks of the new length, not before the time that was.
		_tick = int64_t(std::ceil(media_time() / tick));
		_settings.tick = tick;
		settings_changed();
	}
	_tick++;
	sample_targets();
	if (_streams_stale) {
		update_streams();
	}
	flush();
}

void MotorSynchronizer::frame() {
	_now = clock();
	if (_api.is_null()) {
		return;
	}
	update_connection();
	if (!_connected.empty()) {
		show_streams();
		send_hellos();
		report_rejections();
	}
}

void MotorSynchronizer::settings_changed() {
	if (_sender) {
		_sender->set_settings(_settings);
	}
}

void MotorSynchronizer::limits_changed() {
	for (auto &[id, peer] : _peers) {
		if (peer.stream) {
			limit(*peer.stream);
		}
	}
}

} // namespace ga_godot
