#include "godot/drawing/stroke_batch.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace ga_godot {

using playground::drawing::Box;
using playground::drawing::Form;

// By world and form.
static std::map<std::pair<int64_t, Form>, std::unique_ptr<StrokeBatch>> batches;

StrokeBatch::StrokeBatch(Form p_form, const godot::RID &p_mesh, const godot::RID &p_scenario) :
		_form(p_form), _scenario(p_scenario), _drawn(p_mesh, p_scenario) {
}

StrokeBatch &StrokeBatch::of(Form p_form, const godot::RID &p_mesh, const godot::RID &p_scenario) {
	std::unique_ptr<StrokeBatch> &batch = batches[{ p_scenario.get_id(), p_form }];
	if (!batch) {
		batch = std::make_unique<StrokeBatch>(p_form, p_mesh, p_scenario);
	}
	return *batch;
}

size_t StrokeBatch::add(const InstanceLook &p_look) {
	const size_t owner = _slots.add();
	_looks.push_back(p_look);
	if (_looks.size() > _room) {
		make_room();
	} else {
		_drawn.write(_looks.size() - 1, p_look);
		include(p_look.bounds);
	}
	_drawn.draw_first(_looks.size());
	return owner;
}

void StrokeBatch::change(size_t p_owner, const InstanceLook &p_look) {
	const size_t slot = _slots.slot_of(p_owner);
	_drawn.write_changes(slot, _looks[slot], p_look);
	_looks[slot] = p_look;
	include(p_look.bounds);
}

void StrokeBatch::remove(size_t p_owner) {
	const size_t slot = _slots.remove(p_owner);
	_looks[slot] = _looks.back();
	_looks.pop_back();
	if (_looks.empty()) {
		batches.erase({ _scenario.get_id(), _form });
		return;
	}
	if (slot < _looks.size()) {
		_drawn.write(slot, _looks[slot]);
	}
	_drawn.draw_first(_looks.size());
}

// Twice as much as before, so that many objects do not write all others each time.
void StrokeBatch::make_room() {
	_room = std::max<size_t>(4, 2 * _room);
	_drawn.allocate(_room);
	Box bounds = _looks[0].bounds;
	for (size_t i = 0; i < _looks.size(); i++) {
		_drawn.write(i, _looks[i]);
		bounds = playground::drawing::around_both(bounds, _looks[i].bounds);
	}
	_bounds = bounds;
	_drawn.set_bounds(_bounds);
}

// It only grows: too large a box costs less than to keep it tight.
void StrokeBatch::include(const Box &p_bounds) {
	if (!playground::drawing::contains(_bounds, p_bounds)) {
		_bounds = playground::drawing::around_both(_bounds, p_bounds);
		_drawn.set_bounds(_bounds);
	}
}

} // namespace ga_godot
