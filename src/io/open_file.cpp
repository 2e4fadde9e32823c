#include "io/open_file.h"

#include <sys/stat.h>

#include <cerrno>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "io/file_error.h"

namespace pectin {
namespace {

[[noreturn]] void fail_to_read(const std::string& path, int error) {
    switch (error) {
        case ENOENT:
            throw FileError(path, "no such file");
        case ENOTDIR:
            throw FileError(path, "no such file; part of its path is not a folder");
        case EACCES:
            throw FileError(path, "no permission to read it");
        case EISDIR:
            throw FileError(path, "is a folder, not a file");
        default:
            throw FileError(path, "cannot be read: " + std::generic_category().message(error));
    }
}

void refuse_irregular_file(const std::string& path, mode_t mode) {
    if (S_ISREG(mode)) return;
    if (S_ISDIR(mode)) fail_to_read(path, EISDIR);
    if (S_ISFIFO(mode)) {
        throw FileError(path, "is a pipe, not a file; write what comes out of it to a file first");
    }
    throw FileError(path, S_ISSOCK(mode) ? "is a socket, not a file" : "is a device, not a file");
}

}  // namespace

// Answers one question at a time. `ask` is set before the thread starts; `mutex` guards the rest.
struct TimedFileQuery::Worker {
    enum class State { idle, asked, answered, over };

    std::function<FileAnswer(const std::string&)> ask;
    std::mutex mutex;
    std::condition_variable has_changed;
    State state = State::idle;
    std::string path;
    FileAnswer answer;
    std::exception_ptr failure;

    void run();
};

void TimedFileQuery::Worker::run() {
    std::unique_lock lock(mutex);
    while (true) {
        has_changed.wait(lock, [this] { return state == State::asked || state == State::over; });
        if (state == State::over) return;
        const std::string question = std::move(path);
        lock.unlock();
        FileAnswer found;
        std::exception_ptr what_failed;
        try {
            found = ask(question);
        } catch (...) {
            what_failed = std::current_exception();
        }
        lock.lock();
        if (state == State::over) return;
        answer = std::move(found);
        failure = what_failed;
        state = State::answered;
        has_changed.notify_all();
    }
}

TimedFileQuery::~TimedFileQuery() {
    if (!worker_) return;
    const std::lock_guard lock(worker_->mutex);
    worker_->state = Worker::State::over;
    worker_->has_changed.notify_all();
}

// Returns whether there is a thread to ask.
bool TimedFileQuery::start() {
    if (worker_) return true;
    const auto worker = std::make_shared<Worker>();
    worker->ask = options_.ask;
    try {
        std::thread([worker] { worker->run(); }).detach();
    } catch (const std::system_error&) {
        return false;
    }
    worker_ = worker;
    return true;
}

FileAnswer TimedFileQuery::ask(const std::string& path, const Progress& progress) {
    const auto no_answer = [&path] {
        return FileError(path,
                         "does not answer; is the drive or the server that it is on still there?");
    };
    if (is_waiting_) throw no_answer();
    if (!start()) return options_.ask(path);
    constexpr std::chrono::milliseconds kBetweenChecks{20};
    const auto end = std::chrono::steady_clock::now() + options_.timeout;
    const auto is_answered = [this] { return worker_->state == Worker::State::answered; };
    std::unique_lock lock(worker_->mutex);
    worker_->path = path;
    worker_->state = Worker::State::asked;
    worker_->has_changed.notify_all();
    is_waiting_ = true;
    while (!worker_->has_changed.wait_for(lock, kBetweenChecks, is_answered)) {
        lock.unlock();
        progress.advance(0.0);
        if (std::chrono::steady_clock::now() >= end) throw no_answer();
        lock.lock();
    }
    is_waiting_ = false;
    worker_->state = Worker::State::idle;
    if (worker_->failure) std::rethrow_exception(std::exchange(worker_->failure, nullptr));
    return std::move(worker_->answer);
}

FileAnswer query_file(const std::string& path, const Progress& progress,
                      const QueryOptions& options) {
    return TimedFileQuery(options).ask(path, progress);
}

FileAnswer ask_system(const std::string& path) {
    FileAnswer answer;
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {.error = errno};
    answer.mode = status.st_mode;
    if (!S_ISREG(status.st_mode)) return answer;
    answer.file.descriptor = FileDescriptor(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY);
    // The path may name something else by now.
    if (!answer.file.descriptor.is_open() || ::fstat(answer.file.descriptor.get(), &status) != 0) {
        return {.error = errno};
    }
    answer.mode = status.st_mode;
    answer.file.bytes = static_cast<std::size_t>(status.st_size);
    return answer;
}

OpenFile opened(const std::string& path, FileAnswer answer) {
    if (answer.error != 0) fail_to_read(path, answer.error);
    refuse_irregular_file(path, answer.mode);
    return std::move(answer.file);
}

OpenFile open_file(const std::string& path, const Progress& progress, const QueryOptions& options) {
    return opened(path, query_file(path, progress, options));
}

std::size_t read_bytes(const OpenFile& file, const std::string& path, char* bytes,
                       std::size_t most) {
    std::size_t size = 0;
    while (size < most) {
        const ssize_t got = ::read(file.descriptor.get(), bytes + size, most - size);
        if (got == 0) break;
        if (got < 0 && errno != EINTR) fail_to_read(path, errno);
        if (got > 0) size += static_cast<std::size_t>(got);
    }
    return size;
}

}  // namespace pectin
