#include "formats/deflate.h"

#include <libdeflate.h>

#include <memory>

namespace filigree {
namespace {

constexpr int level = 1;
constexpr std::size_t most_times_smaller = 1100;  // what deflate can pack at best is 1 : 1032

struct LibdeflateDeleter {
    void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
    void operator()(libdeflate_decompressor* decompressor) const { libdeflate_free_decompressor(decompressor); }
};

}  // namespace

std::string deflated(std::string_view bytes) {
    const std::unique_ptr<libdeflate_compressor, LibdeflateDeleter> compressor(libdeflate_alloc_compressor(level));
    std::string stream(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()), '\0');
    stream.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), stream.data(), stream.size()));
    return stream;
}

std::optional<std::string> inflated(std::string_view stream, std::size_t size) {
    if (size / most_times_smaller > stream.size()) return {};
    const std::unique_ptr<libdeflate_decompressor, LibdeflateDeleter> decompressor(libdeflate_alloc_decompressor());
    std::string bytes(size, '\0');
    const libdeflate_result result = libdeflate_zlib_decompress(decompressor.get(), stream.data(), stream.size(),
                                                                bytes.data(), bytes.size(), nullptr);
    if (result != LIBDEFLATE_SUCCESS) return {};
    return bytes;
}

}  // namespace filigree
