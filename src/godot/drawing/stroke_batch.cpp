#include "godot/drawing/stroke_batch.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace ga_godot {

using playground::drawing::Box;
using playground::drawing::Form;

// Keyed by scenario and form.
static std::map<std::pair<int64_t, Form>, std::unique_ptr<StrokeBatch>> batches;

StrokeBatch::StrokeBatch(Form form, const godot::RID &mesh, const godot::RID &scenario) :
		_form(form), _scenario(scenario), _multimesh(mesh, scenario) {
}

StrokeBatch &StrokeBatch::of(Form form, const godot::RID &mesh, const godot::RID &scenario) {
	std::unique_ptr<StrokeBatch> &batch = batches[{ scenario.get_id(), form }];
	if (!batch) {
		batch = std::make_unique<StrokeBatch>(form, mesh, scenario);
	}
	return *batch;
}

size_t StrokeBatch::add(const InstanceData &data) {
	const size_t id = _slots.add();
	_instances.push_back(data);
	if (_instances.size() > _capacity) {
		grow();
	} else {
		_multimesh.write(_instances.size() - 1, data);
		include(data.bounds);
	}
	_multimesh.set_visible_count(_instances.size());
	return id;
}

void StrokeBatch::change(size_t id, const InstanceData &data) {
	const size_t slot = _slots.slot_of(id);
	_multimesh.write(slot, data, &_instances[slot]);
	_instances[slot] = data;
	include(data.bounds);
}

void StrokeBatch::remove(size_t id) {
	const size_t slot = _slots.remove(id);
	_instances[slot] = _instances.back();
	_instances.pop_back();
	if (_instances.empty()) {
		batches.erase({ _scenario.get_id(), _form });
		return;
	}
	if (slot < _instances.size()) {
		_multimesh.write(slot, _instances[slot]);
	}
	_multimesh.set_visible_count(_instances.size());
}

// Doubles the capacity, because each reallocation rewrites all instances.
void StrokeBatch::grow() {
	_capacity = std::max<size_t>(4, 2 * _capacity);
	_multimesh.allocate(_capacity);
	_bounds = _instances[0].bounds;
	for (size_t i = 0; i < _instances.size(); i++) {
		_multimesh.write(i, _instances[i]);
		_bounds = playground::drawing::merged(_bounds, _instances[i].bounds);
	}
	_multimesh.set_bounds(_bounds);
}

// The bounds only grow: a box that is too large costs less than keeping it tight.
void StrokeBatch::include(const Box &bounds) {
	if (!playground::drawing::contains(_bounds, bounds)) {
		_bounds = playground::drawing::merged(_bounds, bounds);
		_multimesh.set_bounds(_bounds);
	}
}

} // namespace ga_godot
