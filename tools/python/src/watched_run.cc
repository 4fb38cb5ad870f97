// SPDX-License-Identifier: BSD-3-Clause
#include "watched_run.hh"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "surfmesh/core/error.hh"

namespace surfmesh::python {
namespace {

namespace py = pybind11;

/// How often signals are looked after.
constexpr std::chrono::milliseconds kSignalInterval{50};

struct News {
  std::string stage;
  std::size_t done = 0;
  std::size_t total = 0;
  std::size_t elements = 0;
};

/// Collects the news of a run on other threads.
class Collector : public Observer {
 public:
  void progress(std::string_view stage, std::size_t done, std::size_t total) override {
    add([&] { last_ = {std::string(stage), done, total, last_.elements}; });
  }

  void at_work(std::size_t elements, int /*pass*/) override {
    add([&] { last_.elements = elements; });
  }

  bool is_cancelled() override { return is_cancelled_; }

  void cancel() { is_cancelled_ = true; }

  void finish() {
    const std::lock_guard lock(mutex_);
    is_finished_ = true;
    changed_.notify_all();
  }

  /// Wait for news for a while. Returns those that came, and whether the run is over.
  std::pair<std::vector<News>, bool> wait() {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, kSignalInterval, [&] { return is_finished_ || !news_.empty(); });
    return {std::exchange(news_, {}), is_finished_};
  }

 private:
  template <class Change>
  void add(Change change) {
    const std::lock_guard lock(mutex_);
    change();
    if (!news_.empty() && news_.back().stage == last_.stage) {
      news_.back() = last_;
    } else {
      news_.push_back(last_);
    }
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<News> news_;
  News last_;
  bool is_finished_ = false;
  std::atomic<bool> is_cancelled_ = false;
};

/// Whether it is False, or NumPy's bool of that value: what comparing arrays gives.
bool is_false(const py::object& answer) {
  if (answer.is_none()) return false;
  const bool is_bool = py::isinstance<py::bool_>(answer) ||
                       py::isinstance(answer, py::module_::import("numpy").attr("bool_"));
  return is_bool && !answer.cast<bool>();
}

/// Tell the function of news. Returns false if it wants the run to end.
bool tell(const py::object& progress, const News& news) {
  return !is_false(progress(news.stage, news.done, news.total, news.elements));
}

/// Look after the run until it is over; the GIL is held.
void watch(const py::object& progress, Collector& collector) {
  const bool is_told = !progress.is_none();
  for (bool is_finished = false; !is_finished;) {
    std::vector<News> all;
    {
      const py::gil_scoped_release release;
      std::tie(all, is_finished) = collector.wait();
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    for (const News& news : all) {
      if (is_told && !collector.is_cancelled() && !tell(progress, news)) collector.cancel();
    }
  }
}

}  // namespace

void run_watched(const py::object& progress, const std::function<void(Observer&)>& body) {
  Collector collector;
  std::exception_ptr failure;
  std::thread thread([&] {
    try {
      body(collector);
    } catch (...) {
      failure = std::current_exception();
    }
    collector.finish();
  });
  std::exception_ptr raised;
  try {
    watch(progress, collector);
  } catch (...) {
    raised = std::current_exception();
    collector.cancel();
  }
  {
    const py::gil_scoped_release release;
    thread.join();
  }
  if (raised) std::rethrow_exception(raised);
  if (failure) std::rethrow_exception(failure);
  // The last news come when the run has ended.
  if (collector.is_cancelled()) throw Error(ErrorCode::Cancelled, "the run was cancelled");
}

}  // namespace surfmesh::python
