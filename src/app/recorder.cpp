#include "app/recorder.h"

#include <cstring>
#include <fstream>

#include "command/json.h"
#include "io/file_error.h"

namespace pectin {

namespace {

// A slip of the hand must not turn a model into a record.
const std::string& checked(const std::string& path) {
    std::ifstream file(path);
    std::string line;
    if (file && std::getline(file, line) && !line.starts_with("{\"pectin\"")) {
        throw FileError(path, "is there already and is no record; record to a new file");
    }
    return path;
}

}  // namespace

Recorder::Recorder(const std::string& path)
    : path_(checked(path)), file_(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666) {
    if (!file_.is_open()) {
        throw FileError(path_, std::string("cannot be written: ") + std::strerror(errno) +
                                   "; record to a file in a folder of yours");
    }
    write_line("{\"pectin\": 1}");
}

void Recorder::record(const Command& command) {
    const std::string line = format_command(command);
    const auto parsed = parse_command(line);
    const auto* same = std::get_if<Command>(&parsed);
    if (!same || !(*same == command)) {
        throw FileError(path_, std::string("cannot hold this ") + name(command) +
                                   ", whose path is not UTF-8; its replay will do without");
    }
    write_line(line);
}

void Recorder::write_line(const std::string& line) {
    std::string bytes = line + '\n';
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t written = ::write(file_.get(), bytes.data() + done, bytes.size() - done);
        if (written < 0 && errno != EINTR) {
            throw FileError(path_, std::string("cannot be written on: ") + std::strerror(errno));
        }
        if (written > 0) done += static_cast<std::size_t>(written);
    }
}

}  // namespace pectin
