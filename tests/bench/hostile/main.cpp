// What a hostile owner of one body costs a server: 10,000 packets per second of several kinds, beside an honest owner of 200 bodies.
// Prints a row for each kind: the server's CPU time for each frame without and with it, the growth in percent of a frame at 60 Hz, the
// longest frame, the memory, and how far the honest owner's motion lags in the worst frame.

#include "../../harness/allocation_counter.hpp"
#include "../../net/hostile_stream.hpp"
#include "../cpu_clock.hpp"

#include "net/session/session.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace {

using Bytes = std::vector<uint8_t>;
using net_test::HostileStream;

constexpr net::PeerId SERVER = 1;
constexpr net::PeerId HONEST = 2;
constexpr net::PeerId HOSTILE = 3;
constexpr double FRAME_TIME = 1.0 / 60.0;
constexpr int FRAMES = 600;
constexpr size_t PACKETS_PER_FRAME = 167;
constexpr uint32_t HONEST_BODIES = 200;

struct Result {
	double mean = 0.0; // seconds of a frame
	double longest = 0.0;
	size_t memory = 0; // bytes
	double lag = 0.0; // seconds
	uint64_t refusals = 0;
};

/// Returns the packets of the hostile owner's stream for a frame. `is_new`: the server has requested another stream.
using Attack = std::function<void(bool is_new, std::vector<Bytes> &packets)>;

Result run(const Attack &attack) {
	net::Session server{ net::StreamSettings() };
	net::Session honest{ net::StreamSettings() };
	double now = 100.0;
	server.connect(SERVER);
	honest.connect(HONEST);
	(void)server.set_peers({ HONEST, HOSTILE }, now);
	(void)honest.set_peers({ SERVER }, now);
	for (uint32_t body = 0; body < HONEST_BODIES; ++body) {
		server.set_owner(1000000 + body, HONEST);
		honest.set_owner(1000000 + body, HONEST);
	}
	server.set_owner(1, HOSTILE);
	Result result;
	uint8_t link = 0;
	bool is_new = false;
	const size_t before = harness::live_bytes();
	std::vector<Bytes> to_server;
	std::vector<Bytes> packets;
	for (int frame = 0; frame < FRAMES; ++frame) {
		now += FRAME_TIME;
		honest.begin_tick(now, FRAME_TIME);
		for (uint32_t body = 0; body < HONEST_BODIES && honest.is_sending(); ++body) {
			(void)honest.observe(1000000 + body, { { std::sin(2.0 * now + body), double(body), std::cos(1.7 * now) }, { 1.0, 0.0, 0.0, 0.0 }, 1.0 });
		}
		honest.end_tick();
		honest.advance(now);
		to_server.clear();
		honest.outbox().drain([&](const net::Outbox::Packet &packet, const uint8_t *bytes) { to_server.emplace_back(bytes, bytes + packet.size); });
		packets.clear();
		if (attack && link != 0) {
			attack(is_new, packets);
			is_new = false;
			for (Bytes &packet : packets) {
				Bytes whole(net::ENVELOPE_BYTES);
				net::write_envelope({ net::PacketKind::MOTION, link, net::ENVELOPE_VERSION }, whole.data());
				whole.insert(whole.end(), packet.begin(), packet.end());
				packet.swap(whole);
			}
		}
		const double begin = bench::cpu_seconds();
		for (const Bytes &packet : to_server) {
			server.accept(HONEST, packet.data(), packet.size(), now);
		}
		for (const Bytes &packet : packets) {
			server.accept(HOSTILE, packet.data(), packet.size(), now);
		}
		server.begin_tick(now, FRAME_TIME);
		server.end_tick();
		server.advance(now);
		const double seconds = bench::cpu_seconds() - begin;
		server.report_rejections([&](net::PeerId, const net::Rejections::Report &report) { result.refusals += report.error == net::PacketError::TOO_MUCH_WORK || report.error == net::PacketError::TOO_MANY_BODIES ? 1 : 0; });
		server.outbox().drain([&](const net::Outbox::Packet &packet, const uint8_t *bytes) {
			if (packet.peer == HONEST) {
				honest.accept(SERVER, bytes, packet.size, now);
			} else if (const auto envelope = net::read_envelope(bytes, packet.size); envelope && envelope->kind == net::PacketKind::OPEN && envelope->link != link) {
				link = envelope->link;
				is_new = true;
			}
		});
		result.mean += seconds / FRAMES;
		result.longest = std::max(result.longest, seconds);
		result.memory = std::max(result.memory, harness::live_bytes() - before);
		if (frame > 120) {
			result.lag = std::max(result.lag, server.stream(HONEST) != nullptr ? honest.media_time(HONEST) - server.media_time(HONEST) : 1e9);
		}
	}
	return result;
}

void fill(std::vector<Bytes> &packets, const std::vector<Bytes> &source, size_t &next) {
	while (packets.size() < PACKETS_PER_FRAME) {
		packets.push_back(source[next++ % source.size()]);
	}
}

Attack fresh_snapshots(uint32_t count) {
	std::vector<Bytes> source;
	HostileStream stream(count);
	for (int i = 0; i < 8; ++i) {
		for (Bytes &packet : stream.snapshot()) {
			source.push_back(std::move(packet));
		}
		stream.replace_bodies(count);
		stream.tick += 1.0;
	}
	return [source, next = size_t(0)](bool, std::vector<Bytes> &packets) mutable { fill(packets, source, next); };
}

/// A snapshot for each new stream, then windows.
Attack windows(uint32_t count, int per_packet, bool moves) {
	HostileStream stream(count);
	const std::vector<Bytes> snapshot = stream.snapshot();
	std::vector<Bytes> source;
	for (int i = 0; i < (moves ? 60 : per_packet * 20); ++i) {
		if (moves) {
			stream.observe(1, false);
		}
		stream.add_window(1, source);
	}
	return [=, sent = size_t(0), next = size_t(0)](bool is_new, std::vector<Bytes> &packets) mutable {
		sent = is_new ? 0 : sent;
		next = is_new ? 0 : next;
		for (; sent < snapshot.size() && packets.size() < PACKETS_PER_FRAME; ++sent) {
			packets.push_back(snapshot[sent]);
		}
		fill(packets, source, next);
	};
}

Attack restarted_snapshots() {
	return [number = uint8_t(0)](bool, std::vector<Bytes> &packets) mutable {
		const uint8_t bytes[10] = {};
		for (size_t i = 0; i < PACKETS_PER_FRAME; ++i) {
			packets.emplace_back();
			for (int k = 0; k < 57; ++k) {
				net::put_fragment(packets.back(), { ++number, 0, 8, 9, bytes, sizeof(bytes) });
			}
		}
	};
}

Attack small_chunks() {
	return [number = uint32_t(0)](bool, std::vector<Bytes> &packets) mutable {
		for (size_t i = 0; i < PACKETS_PER_FRAME; ++i) {
			packets.emplace_back();
			for (int k = 0; k < 210; ++k) {
				net::ChunkItem chunk;
				chunk.number = decltype(chunk.number)(number++ * 7);
				chunk.first = chunk.last = chunk.is_wide = true;
				net::put_chunk(packets.back(), chunk, false);
			}
		}
	};
}

void print(const char *name, const Result &without, const Result &with) {
	std::printf("%-44s %8.3f ms -> %8.3f ms  %+6.1f %% of a frame, longest %7.2f ms, memory %6.1f MB, lag %4.0f ms, %llu refusals\n", name, 1e3 * without.mean, 1e3 * with.mean, 100.0 * (with.mean - without.mean) / FRAME_TIME, 1e3 * with.longest, double(with.memory) / 1e6, 1e3 * with.lag, static_cast<unsigned long long>(with.refusals));
	std::fflush(stdout);
}

} // namespace

int main() {
	const Result without = run(nullptr);
	print("no hostile peer", without, without);
	print("snapshots of 4,128 new bodies", without, run(fresh_snapshots(4128)));
	print("snapshots of 65,536 new bodies", without, run(fresh_snapshots(65536)));
	print("127 empty windows a packet, 4,128 bodies", without, run(windows(4128, 127, false)));
	print("127 empty windows a packet, 65,536 bodies", without, run(windows(65536, 127, false)));
	print("windows of 4,128 moving bodies", without, run(windows(4128, 1, true)));
	print("windows of 65,536 moving bodies", without, run(windows(65536, 1, true)));
	print("a snapshot begun with each fragment", without, run(restarted_snapshots()));
	print("chunks of no bytes", without, run(small_chunks()));
	return 0;
}
