// The codec behind MotorCodec: any bytes to decode, any poses to encode.

#include "motion.hpp"

#include "net/pose_codec.hpp"

namespace {

using fuzz::require;

void decode_any(const fuzz::Bytes &bytes) {
	std::vector<net::BodyPose> bodies;
	const net::CodecResult result = net::decode(bytes.data(), bytes.size(), bodies);
	require(result || bodies.empty(), "a rejected packet has bodies");
	require(result || net::describe(result.error().fault)[0] != '\0', "an error has no description");
	for (const net::BodyPose &body : bodies) {
		fuzz::require_finite(cga::pose_cast<double>(body.pose));
	}
}

void encode_any(fuzz::Input &input) {
	net::Tolerance tolerance;
	if (input.flag()) {
		tolerance = { float(input.number()), float(input.number()) };
	}
	std::vector<net::BodyPose> bodies(input.byte() % 16);
	for (net::BodyPose &body : bodies) {
		body.id = uint32_t(input.flag() ? input.byte() : input.bits(4));
		body.pose = cga::pose_cast<float>(input.byte() < 240 ? fuzz::pose_from(input) : fuzz::any_pose_from(input));
	}
	fuzz::Bytes packet;
	const net::CodecResult encoded = net::encode(bodies.data(), bodies.size(), tolerance, packet);
	require(encoded.has_value() != packet.empty(), "a packet is empty, or there is one after an error");
	std::vector<net::BodyPose> decoded;
	if (!encoded) {
		return;
	}
	require(net::decode(packet.data(), packet.size(), decoded).has_value(), "an encoded packet is rejected");
	require(decoded.size() == bodies.size(), "bodies are missing");
	for (size_t i = 0; i < bodies.size(); ++i) {
		const cga::Pose<double> before = cga::pose_cast<double>(bodies[i].pose);
		const cga::Pose<double> after = cga::pose_cast<double>(decoded[i].pose);
		// Rounding to single precision, of the position and of the grid.
		const double rounding = 4e-7 * (glm::length(before.translation) + double(tolerance.position));
		require(decoded[i].id == bodies[i].id, "an id differs");
		require(glm::length(before.translation - after.translation) <= double(tolerance.position) * 1.0001 + rounding, "a position deviates by more than the tolerance");
		const cga::Quaternion<double> between = glm::conjugate(glm::normalize(before.rotation)) * after.rotation;
		const double degrees = 2.0 * std::atan2(glm::length(cga::Vector3<double>(between.x, between.y, between.z)), std::fabs(between.w)) * 57.29577951308232;
		require(degrees <= double(tolerance.rotation) * 1.0001 + 2e-5, "a rotation deviates by more than the tolerance");
	}
}

} // namespace

void fuzz::run(Input input) {
	if (input.flag()) {
		encode_any(input);
	} else {
		decode_any(input.rest());
	}
}
