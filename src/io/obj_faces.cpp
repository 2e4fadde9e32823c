#define TINYOBJLOADER_IMPLEMENTATION
#include "io/obj_faces.h"

#include <tiny_obj_loader.h>

#include <istream>
#include <streambuf>
#include <vector>

namespace pectin {
namespace {

// A stream of `f` statements, one line each, made as they are asked for.
//
// tinyobjloader's callbacks come with raw indices and polygons of any size, where its LoadObj
// drops small polygons, counts the corners of large ones modulo 256, and keeps everything in
// memory; but they come without line numbers. As each line is made when the one before has been
// read, whoever makes them knows which line that was.
class FaceLines : public std::streambuf {
  public:
    explicit FaceLines(const std::function<bool(std::string&)>& next) : next_(next) {}

  protected:
    int_type underflow() override {
        if (!next_(arguments_)) return traits_type::eof();
        line_.assign("f ").append(arguments_).push_back('\n');
        setg(line_.data(), line_.data(), line_.data() + line_.size());
        return traits_type::to_int_type(*gptr());
    }

  private:
    const std::function<bool(std::string&)>& next_;
    std::string arguments_;
    std::string line_;
};

struct FaceReceiver {
    const std::function<void(std::span<const ObjCorner>)>& face;
    std::vector<ObjCorner> corners;

    static void receive(void* receiver, tinyobj::index_t* indices, int count) {
        auto& [face, corners] = *static_cast<FaceReceiver*>(receiver);
        corners.clear();
        for (const tinyobj::index_t& i : std::span(indices, static_cast<std::size_t>(count))) {
            corners.push_back({i.vertex_index, i.texcoord_index, i.normal_index});
        }
        face(corners);
    }
};

}  // namespace

void read_faces(const std::function<bool(std::string& arguments)>& next,
                const std::function<void(std::span<const ObjCorner>)>& face) {
    FaceLines lines(next);
    std::istream stream(&lines);
    stream.exceptions(std::ios::badbit);  // rethrows what `next` throws
    FaceReceiver receiver{face, {}};
    tinyobj::callback_t callbacks;
    callbacks.index_cb = &FaceReceiver::receive;
    tinyobj::LoadObjWithCallback(stream, callbacks, &receiver);
}

}  // namespace pectin
