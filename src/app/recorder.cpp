#include "app/recorder.h"

#include <sys/stat.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "command/json.h"
#include "io/file_error.h"

namespace pectin {

namespace {

// Throws FileError unless the file holds a record. A mistyped path must not destroy a model.
void check_is_record(const std::string& path) {
    std::ifstream file(path);
    std::string line;
    if (file && std::getline(file, line) && line.starts_with("{\"pectin\"")) return;
    throw FileError(path, "already exists and is no record; record to a new file");
}

// Opens the file for writing. Throws FileError unless it is an ordinary file.
FileDescriptor open_ordinary_file(const std::string& path, struct stat& status) {
    // O_NONBLOCK: opening a pipe that nobody reads would wait.
    FileDescriptor file(path.c_str(), O_WRONLY | O_CREAT | O_NONBLOCK, 0666);
    const bool is_pipe = !file.is_open() && errno == ENXIO;
    if (!is_pipe && (!file.is_open() || ::fstat(file.get(), &status) != 0)) {
        throw FileError(path, std::string("cannot be written: ") + std::strerror(errno) +
                                  "; record to a file in a folder where you may write");
    }
    if (is_pipe || !S_ISREG(status.st_mode)) {
        throw FileError(path, "is a device or a pipe; record to an ordinary file");
    }
    return file;
}

// Opens the file at the path, or the first free one beside it, and changes the path to its name.
FileDescriptor begin_file(std::string& path) {
    const std::filesystem::path wanted = path;
    for (int number = 2;; ++number) {
        struct stat status {};
        FileDescriptor file = open_ordinary_file(path, status);
        if (status.st_size == 0) return file;
        check_is_record(path);
        path = wanted.parent_path() / (wanted.stem().string() + "-" + std::to_string(number) +
                                       wanted.extension().string());
    }
}

}  // namespace

Recorder::Recorder(const std::string& path) : path_(path), file_(begin_file(path_)) {
    write_line(kScriptHeader);
}

Recorder::Recorder(std::string path, FileDescriptor file)
    : path_(std::move(path)), file_(std::move(file)) {
    write_line(kScriptHeader);
}

void Recorder::record(const Command& command) {
    if (has_ended_) return;
    // The record counts as ended until the line is written. If an exception leaves this function,
    // no later command may follow the missing one.
    has_ended_ = true;
    const std::string line = format_command(command);
    const auto parsed = parse_command(line);
    const auto* same = std::get_if<Command>(&parsed);
    if (same && *same == command) {
        write_line(line);
        has_ended_ = false;
        return;
    }
    has_ended_ = std::holds_alternative<command::Open>(command);
    const auto* error = std::get_if<CommandError>(&parsed);
    throw FileError(
        path_,
        std::string("cannot hold this ") + name(command) + " command, because " +
            (error && error->command == name(command) ? error->what : "its path is not UTF-8") +
            "; " + (has_ended_ ? "the record ends here" : "a replay will leave it out"));
}

void Recorder::write_comment(const std::string& text) {
    if (!has_ended_) write_line("# " + text);
}

void Recorder::write_line(const std::string& line) {
    const std::string bytes = line + '\n';
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t written = ::write(file_.get(), bytes.data() + done, bytes.size() - done);
        if (written > 0) done += static_cast<std::size_t>(written);
        if (written >= 0 || errno == EINTR) continue;
        const int error = errno;
        has_ended_ = true;
        // An incomplete line would make the whole script unreadable.
        if (::ftruncate(file_.get(), size_) != 0) errno = 0;
        throw FileError(path_, std::string("cannot be written any more: ") + std::strerror(error) +
                                   "; the record ends here");
    }
    size_ += static_cast<off_t>(bytes.size());
}

}  // namespace pectin
