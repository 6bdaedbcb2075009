#include "paper_method.hpp"

#include "cga/motor/motor_multivector.hpp"

#include <cmath>

namespace bench::paper {

namespace {

// Indices of blades.
enum : size_t {
	E1 = 1,
	E2 = 2,
	E3 = 3,
	E4 = 4,
	E5 = 5,
	E12 = 6,
	E13 = 7,
	E23 = 10,
	E45 = 15,
	E123 = 16,
	E1234 = 26,
	E1235 = 27,
};

Element unit_motor(const cga::Pose<float> &pose) {
	cga::Pose<double> rigid = cga::pose_cast<double>(pose);
	rigid.scale = 1.0;
	const cga::Multivector motor = cga::to_multivector(cga::Motor<double>::from_pose(rigid));
	Element element;
	for (size_t index = 0; index < size_t(cga::BLADE_COUNT); ++index) {
		element[index] = float(motor[int(index)]);
	}
	return element;
}

Element basis_blade(size_t index) {
	Element element;
	element[index] = 1.0f;
	return element;
}

const Element PSEUDOSCALAR = basis_blade(E123); // of Euclidean space

Element origin() {
	Element element;
	element[E4] = -0.5f;
	element[E5] = 0.5f;
	return element;
}

const Element ORIGIN = origin();

bool is_blended(size_t index) {
	return index <= E3 || (index >= E12 && index < E45) || index == E1234 || index == E1235;
}

template <class Store>
void normalize(const Element &element, Element &result, Store &store) {
	const Held<Store> conjugated(store);
	conjugate(element, *conjugated);
	const Held<Store> square(store);
	geometric_product(element, *conjugated, *square);
	scale(element, 1.0f / std::sqrt(std::abs((*square)[0])), result);
}

template <class Store>
cga::Quaternion<float> quaternion_of(const Element &rotor, Store &store) {
	const Held<Store> dual(store);
	geometric_product(PSEUDOSCALAR, rotor, *dual);
	return cga::Quaternion<float>(rotor[0], (*dual)[E1], (*dual)[E2], (*dual)[E3]);
}

template <class Store>
cga::Vector3<float> translation_of(const Element &translator, Store &store) {
	const Held<Store> unit(store);
	normalize(translator, *unit, store);
	const Held<Store> minus_origin(store);
	scale(ORIGIN, -1.0f, *minus_origin);
	const Held<Store> half(store);
	inner_product(*unit, *minus_origin, *half);
	const Held<Store> whole(store);
	scale(*half, -2.0f, *whole);
	return { (*whole)[E1], (*whole)[E2], (*whole)[E3] };
}

} // namespace

Ends::Ends(const cga::Pose<float> &first, const cga::Pose<float> &second) :
		from(unit_motor(first)), from_scale(first.scale), to_scale(second.scale) {
	cga::Pose<float> near = second;
	if (glm::dot(first.rotation, second.rotation) < 0.0f) {
		near.rotation = -near.rotation;
	}
	to = unit_motor(near);
}

template <class Store>
cga::Pose<float> interpolate(const Ends &ends, float weight, Store &store) {
	const Held<Store> motor(store);
	for (size_t index = 0; index < size_t(cga::BLADE_COUNT); ++index) {
		(*motor)[index] = is_blended(index) ? ends.from[index] * (1.0f - weight) + ends.to[index] * weight : 0.0f;
	}

	const Held<Store> rotor(store);
	for (const size_t index : { size_t(0), size_t(E1), size_t(E2), size_t(E3), size_t(E12), size_t(E13), size_t(E23), size_t(E123) }) {
		(*rotor)[index] = (*motor)[index];
	}
	cga::Pose<float> pose;
	pose.rotation = glm::normalize(quaternion_of(*rotor, store));

	const Held<Store> reversed(store);
	conjugate(*rotor, *reversed);
	const Held<Store> translator(store);
	geometric_product(*motor, *reversed, *translator);
	const Held<Store> unit(store);
	normalize(*translator, *unit, store);
	pose.translation = translation_of(*unit, store);
	pose.scale = ends.to_scale * weight + ends.from_scale * (1.0f - weight);
	return pose;
}

template cga::Pose<float> interpolate(const Ends &, float, Pool &);
template cga::Pose<float> interpolate(const Ends &, float, Allocating &);

} // namespace bench::paper
