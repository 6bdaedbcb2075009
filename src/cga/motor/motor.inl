#pragma once

namespace cga {

template <class T>
Motor<T> Motor<T>::translator(const Vector3<T> &offset) noexcept {
	Motor motor;
	motor.v = pure(offset * T(-0.5));
	return motor;
}

template <class T>
Motor<T> Motor<T>::rotor(const Quaternion<T> &rotation) noexcept {
	return { rotation, rotation };
}

// a = cosh(g/2) - sinh(g/2) = 1 / sqrt(s)
// b = cosh(g/2) + sinh(g/2) = sqrt(s)
template <class T>
Motor<T> Motor<T>::dilator(T scale) noexcept {
	const T root = std::sqrt(scale);
	Motor motor;
	motor.a.w = T(1) / root;
	motor.b.w = root;
	return motor;
}

// a = q / sqrt(s)
// b = q sqrt(s)
// v = -(1/2) t a
template <class T>
Motor<T> Motor<T>::from_pose(const Pose<T> &pose) noexcept {
	const T root = std::sqrt(pose.scale);
	const Quaternion<T> a = pose.rotation / root;
	return { a, pose.rotation * root, pure(pose.translation * T(-0.5)) * a };
}

// q = a / |a|
// s = |b| / |a|
// t = -2 v conj(a) / |a|^2, blade by blade, with n2 = |A|^2:
//   t1 = -2 (V_1 A_0 + V_2 A_12 + V_3 A_13 + V_123 A_23) / n2
//   t2 = -2 (V_2 A_0 - V_1 A_12 + V_3 A_23 - V_123 A_13) / n2
//   t3 = -2 (V_3 A_0 - V_1 A_13 - V_2 A_23 + V_123 A_12) / n2
// The scalar part of v conj(a), zero in a motor, is dropped: this turns the blend of two motors into a pose.
template <class T>
std::optional<Pose<T>> Motor<T>::to_pose() const noexcept {
	const T length = std::sqrt(glm::dot(a, a));
	const T scaled_length = std::sqrt(glm::dot(b, b));
	if (length == T(0) || scaled_length == T(0)) {
		return std::nullopt;
	}
	const Quaternion<T> rotation = a / length;
	const Vector3<T> translation = vector_part((v / length) * glm::conjugate(rotation)) * T(-2);
	return Pose<T>{ translation, rotation, scaled_length / length };
}

// Grades 2 and 3 change sign: m_45, m_12, m_14 do, m_1245 and m_1234 do not, which swaps A and B.
template <class T>
Motor<T> Motor<T>::reverse() const noexcept {
	return { glm::conjugate(b), glm::conjugate(a), glm::conjugate(v) };
}

// M M~ = (a conj(b), b conj(a), v conj(b) + b conj(v)) in this form: a . b and, for a motor, nothing else.
template <class T>
T Motor<T>::norm_squared() const noexcept {
	return glm::dot(a, b);
}

template <class T>
std::optional<Motor<T>> Motor<T>::inverse() const noexcept {
	const T weight = norm_squared();
	if (weight == T(0)) {
		return std::nullopt;
	}
	const Motor reversed = reverse();
	return Motor{ reversed.a / weight, reversed.b / weight, reversed.v / weight };
}

// An even X has X X~ = h + k of grades 0 and 4; with n = sqrt(h^2 - k^2),
//   X' = (n + h - k) X / (n sqrt(2 (n + h))), from the left.
// Here a conj(b) = h + u, with u the vector part, v conj(b) + b conj(v) = 2 v . b, and n = |a| |b|:
//   n + h - k = (n + b conj(a), n + a conj(b), -2 v . b)
template <class T>
std::optional<Motor<T>> Motor<T>::normalized() const noexcept {
	const T n = std::sqrt(glm::dot(a, a)) * std::sqrt(glm::dot(b, b));
	const T divisor = n * std::sqrt(T(2) * (n + norm_squared()));
	if (!(divisor > T(0))) {
		return std::nullopt;
	}
	Motor left;
	left.a = b * glm::conjugate(a);
	left.a.w += n;
	left.b = a * glm::conjugate(b);
	left.b.w += n;
	left.v = { T(-2) * glm::dot(v, b), T(0), T(0), T(0) };
	const Motor motor = compose(left, *this);
	return Motor{ motor.a / divisor, motor.b / divisor, motor.v / divisor };
}

// t + s q x q* = (b x - 2 v) conj(a) / |a|^2
template <class T>
Vector3<T> Motor<T>::transform_point(const Vector3<T> &point) const noexcept {
	const Quaternion<T> image = b * pure(point) - v * T(2);
	return vector_part(image * glm::conjugate(a)) / glm::dot(a, a);
}

// M1 M2 = (a1 a2, b1 b2, b1 v2 + v1 a2): 64 multiplications instead of 1,024.
template <class T>
Motor<T> compose(const Motor<T> &first, const Motor<T> &second) noexcept {
	return { first.a * second.a, first.b * second.b, first.b * second.v + first.v * second.a };
}

} // namespace cga
