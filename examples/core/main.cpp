// GA-Godot's core without Godot: typed elements, a block of motors, and poses sent as bytes.

#include "cga/batch/motor_block.hpp"
#include "cga/typed/motion.hpp"
#include "cga/typed/objects.hpp"
#include "net/endpoint/receiver.hpp"
#include "net/endpoint/sender.hpp"

#include <cmath>
#include <cstdio>
#include <vector>

namespace {

// A rotation by 90 degrees about z, then a translation by 1 m along x.
const cga::Pose<double> POSE = { { 1.0, 0.0, 0.0 }, { std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5) }, 1.0 };

// The type of a product follows from the types of its factors: the meet of two Spheres is a Circle, and so is a moved Circle.
void intersect_spheres() {
	using namespace cga::typed;
	const Circle<> circle = sphere<double>({ 0.0, 0.0, 0.0 }, 1.0).regressive_product(sphere<double>({ 1.0, 0.0, 0.0 }, 1.0));
	const Circle<> moved_circle = moved(circle, cga::Motor<double>::from_pose(POSE));
	const cga::Vector3<double> position = center(moved_circle);
	std::printf("circle: center (%.3f, %.3f, %.3f), radius %.3f\n", position.x, position.y, position.z, std::sqrt(squared_radius(moved_circle)));
}

// Transforms eight points by eight motors in one call, with the fastest instruction set of this machine.
void transform_block() {
	cga::MotorBlock motors;
	std::vector<float> points;
	for (int lane = 0; lane < cga::MotorBlock::LANES; ++lane) {
		motors.set(lane, cga::Motor<float>::from_pose(cga::pose_cast<float>(POSE)));
		points.insert(points.end(), { float(lane), 0.0f, 0.0f });
	}
	cga::transform_points(&motors, points.data(), cga::MotorBlock::LANES, points.data());
	std::printf("point 7: (%.3f, %.3f, %.3f)\n", double(points[21]), double(points[22]), double(points[23]));
}

// A body moves at 1 m/s for 2 s. The receiver gets each packet immediately.
void replicate_body() {
	constexpr uint32_t BODY = 1, PEER = 2;
	const net::StreamSettings settings;
	net::Sender sender(settings);
	net::Receiver receiver;
	sender.add_body(BODY, {});
	sender.add_receiver(PEER, 0.0);
	std::vector<uint8_t> ack;
	for (int tick = 1; tick <= 120; ++tick) {
		const double now = tick * settings.tick;
		sender.observe(BODY, now, { { now, 0.0, 0.0 } });
		sender.flush(now);
		for (const net::OutgoingPacket &packet : sender.packets()) {
			(void)receiver.accept(sender.bytes() + packet.begin, packet.size, now);
		}
		receiver.take_ack(ack, now);
		if (!ack.empty()) {
			(void)sender.accept(PEER, ack.data(), ack.size(), now);
		}
		receiver.advance(now);
	}
	const auto shown = receiver.pose(BODY);
	const double error = shown ? std::abs(sender.media_time(shown->translation.x) - receiver.media_time()) : INFINITY;
	std::printf("body: %s, %s\n", shown ? "shown" : "not shown", error <= settings.position_tolerance ? "within tolerance" : "out of tolerance");
}

} // namespace

int main() {
	intersect_spheres();
	transform_block();
	replicate_body();
	return 0;
}
