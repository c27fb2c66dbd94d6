// For tests alone: SHA-256 (FIPS 180-4), since the vectors name long words by it.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace filigree::rewriting {

// As 64 hexadecimal digits.
inline std::string sha256(std::span<const std::uint8_t> bytes) {
    static constexpr std::array<std::uint32_t, 64> constants{
        0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
        0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
        0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
        0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
        0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
        0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
        0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
        0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};
    std::array<std::uint32_t, 8> hash{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    const std::size_t blocks = (bytes.size() + 9 + 63) / 64;
    const auto byte = [&](std::size_t i) -> std::uint32_t {
        if (i < bytes.size()) return bytes[i];
        if (i == bytes.size()) return 0x80;
        const std::size_t from_end = blocks * 64 - 1 - i;
        return from_end < 8 ? static_cast<std::uint8_t>(std::uint64_t{bytes.size()} * 8 >> (8 * from_end)) : 0;
    };
    for (std::size_t block = 0; block < blocks; ++block) {
        std::array<std::uint32_t, 64> w{};
        for (std::size_t i = 0; i < 64; ++i) {
            if (i < 16) {
                for (std::size_t b = 0; b < 4; ++b) w[i] = w[i] << 8 | byte(block * 64 + i * 4 + b);
            } else {
                const std::uint32_t a = w[i - 15], e = w[i - 2];
                w[i] = w[i - 16] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ (a >> 3)) + w[i - 7] +
                       (std::rotr(e, 17) ^ std::rotr(e, 19) ^ (e >> 10));
            }
        }
        std::array<std::uint32_t, 8> v = hash;
        for (std::size_t i = 0; i < 64; ++i) {
            const std::uint32_t a = v[0], e = v[4];
            const std::uint32_t t = v[7] + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) +
                                    ((e & v[5]) ^ (~e & v[6])) + constants[i] + w[i];
            const std::uint32_t u =
                (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & v[1]) ^ (a & v[2]) ^ (v[1] & v[2]));
            v = {t + u, v[0], v[1], v[2], v[3] + t, v[4], v[5], v[6]};
        }
        for (std::size_t i = 0; i < 8; ++i) hash[i] += v[i];
    }
    std::string text;
    for (const std::uint32_t part : hash) {
        for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[part >> shift & 15];
    }
    return text;
}

}  // namespace filigree::rewriting
