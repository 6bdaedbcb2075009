#pragma once

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <atomic>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace ga_godot {

// Calls of bound methods from a wrong thread are errors, not races: a class derives from OneThread or MainThread, and binds
// guarded<&Class::method>() instead of &Class::method.

/// Differs between threads that run at the same time; never null.
[[nodiscard]] inline const void *current_thread() {
	static thread_local const char TOKEN = 0;
	return &TOKEN;
}

/// Call in the main thread, before is_main_thread().
void remember_main_thread();
[[nodiscard]] bool is_main_thread();
/// The node itself or the parent whose process group runs `node` in a sub-thread; null if the main thread runs it.
[[nodiscard]] const godot::Node *find_sub_thread_group(const godot::Node *node);

/// The reason for which `accept` refuses a packet while another thread is in a call.
inline constexpr char IN_USE[] = "another thread is using this object";

/// The common part of the guards. A Guard's Entry is constructed from the Self that is called; it reports a call that it refuses.
template <class Self, class Guard>
class GuardedCalls {
protected:
	/// A refused call returns FALLBACK if it is given, ERR_BUSY for an Error, or a default value.
	template <auto METHOD, auto FALLBACK = nullptr>
	static auto guarded() {
		return guard<METHOD, FALLBACK>(METHOD);
	}

private:
	template <auto METHOD, auto FALLBACK, class C, class R, class... Args>
	static auto guard(R (C::*)(Args...)) -> R (Self::*)(Args...) {
		return &GuardedCalls::template call<METHOD, FALLBACK, C, R, Args...>;
	}
	template <auto METHOD, auto FALLBACK, class C, class R, class... Args>
	static auto guard(R (C::*)(Args...) const) -> R (Self::*)(Args...) const {
		return &GuardedCalls::template call_const<METHOD, FALLBACK, C, R, Args...>;
	}

	template <auto METHOD, auto FALLBACK, class C, class R, class... Args>
	R call(Args... args) {
		return enter<METHOD, FALLBACK, C, R>(static_cast<Self &>(*this), std::forward<Args>(args)...);
	}
	template <auto METHOD, auto FALLBACK, class C, class R, class... Args>
	R call_const(Args... args) const {
		return enter<METHOD, FALLBACK, const C, R>(static_cast<const Self &>(*this), std::forward<Args>(args)...);
	}

	template <auto METHOD, auto FALLBACK, class C, class R, class S, class... Args>
	static R enter(S &self, Args &&...args) {
		typename Guard::Entry entry(self); // the method may destroy self
		if (likely(entry.is_allowed())) {
			C &target = self;
			const auto method = METHOD; // GCC 12 warns of strict aliasing if it is called as a constant
			return (target.*method)(std::forward<Args>(args)...);
		}
		if constexpr (!std::is_same_v<decltype(FALLBACK), std::nullptr_t>) {
			return R(FALLBACK);
		} else if constexpr (std::is_same_v<R, godot::Error>) {
			return godot::ERR_BUSY;
		} else {
			return R();
		}
	}
};

/// For classes whose objects one thread at a time may use. Calls from callbacks within a call are allowed. To be cheap, the check
/// is no exchange: it may miss calls that begin within the same few nanoseconds.
template <class Self>
class OneThread : public GuardedCalls<Self, OneThread<Self>> {
public:
	class Entry {
	public:
		explicit Entry(const OneThread &object) {
			const void *const user = object._user.load(std::memory_order_relaxed);
			const void *const self = current_thread();
			_is_allowed = user == nullptr || user == self;
			if (user == nullptr) {
				_object = &object;
				object._user.store(self, std::memory_order_relaxed);
				object._entry.store(this, std::memory_order_relaxed);
			}
			if (unlikely(!_is_allowed)) {
				ERR_PRINT(godot::vformat("%s: two threads call methods of one object at the same time. This call did nothing. Use one object for each thread, or a Mutex.", Self::get_class_static()));
			}
		}
		~Entry() {
			if (_object != nullptr) {
				_object->_user.store(nullptr, std::memory_order_relaxed);
			}
		}
		Entry(const Entry &) = delete;
		Entry &operator=(const Entry &) = delete;

		[[nodiscard]] bool is_allowed() const { return _is_allowed; }

	private:
		friend OneThread;

		const OneThread *_object = nullptr; // for the first of nested calls
		bool _is_allowed;
	};

	OneThread() = default;
	/// A callback may release the last reference to the object that is calling.
	~OneThread() {
		if (_user.load(std::memory_order_relaxed) != nullptr) {
			_entry.load(std::memory_order_relaxed)->_object = nullptr;
		}
	}
	OneThread(const OneThread &) = delete;
	OneThread &operator=(const OneThread &) = delete;

private:
	mutable std::atomic<const void *> _user = nullptr; // the thread that is in a call
	mutable std::atomic<Entry *> _entry = nullptr; // the first of that thread's nested calls
};

/// For nodes that only the main thread may use while they are in the tree; with a process group, also the sub-thread that
/// runs the node.
template <class Self, bool HAS_PROCESS_GROUP = false>
class MainThread : public GuardedCalls<Self, MainThread<Self, HAS_PROCESS_GROUP>> {
public:
	class Entry {
	public:
		explicit Entry(const Self &node) :
				_is_allowed(is_main_thread() || !node.is_inside_tree() || (HAS_PROCESS_GROUP && find_sub_thread_group(&node) != nullptr)) {
			if (unlikely(!_is_allowed)) {
				ERR_PRINT(godot::vformat("%s: a thread other than the main thread calls a method of a node in the tree. This call did nothing. Use call_deferred().", Self::get_class_static()));
			}
		}

		[[nodiscard]] bool is_allowed() const { return _is_allowed; }

	private:
		bool _is_allowed;
	};
};

} // namespace ga_godot
