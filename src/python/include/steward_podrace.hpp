// steward_podrace.hpp - the official turn of CodinGame's pod race (Mad Pod Racing, Coders Strike Back), to the last bit.
//
// One file, C++17, no dependency: copy it to the head of your bot. Positions, speeds, headings, timers, checkpoints
// and turns left are those of Steward's referee, which agrees with the official recordings. Written with Steward's
// licence: see the repository.
//
//     steward::Map map({{12460, 1350}, {10540, 5980}, {3580, 5180}});          // checkpoints; throws if built wrongly
//     steward::State now = map.start();
//     map.set(now, 0, x, y, vx, vy, steward::radians(angle), timer, boostLeft, passed);   // and pods 1, 2, 3
//     steward::State trial = now;                                              // 224 bytes
//     steward::Commands commands;                                              // pods 0 and 1 are player 0's
//     commands.target(0, targetX, targetY, 200);                             // as in a bot's answer
//     commands.turn(1, -18, steward::SHIELD);                                  // by an angle, -18..18 degrees
//     map.play(trial, commands);
//     double worth = 50000.0 * trial.passed[0] - map.toNext(trial, 0);
//
// Speed: with AVX2 (-mavx2, -march=native, or #pragma GCC target("avx2") at the head of the file) one operation steers
// four pods, otherwise two, which every x86-64 can; elsewhere, or with -DSTEWARD_SCALAR, one. All give the same bits.
//
// Bits: no flag may let the compiler change the order or the rounding of operations. The header switches that off for
// itself: g++ with #pragma GCC optimize("Ofast") at the head of the file is fine. The constructor of Map checks, within
// microseconds, that arithmetic is what the rules need, and throws std::runtime_error if it is not (flags like
// -frounding-math are harmless; flushing of tiny numbers by a program linked with -Ofast is refused).
//
// Not simulated: elimination and the end of a race; checkpoints are counted on behind the finish. Bots see headings in
// whole degrees: set a heading from them once, then simulate your own commands to keep its digits. Of others, shield
// timers and boosts are not seen either.
#ifndef STEWARD_PODRACE_HPP
#define STEWARD_PODRACE_HPP

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>
#if defined(__AVX2__) && defined(__GNUC__)
#define STEWARD_AVX2 1
#define STEWARD_SSE2 0
#include <immintrin.h>
#elif defined(__SSE2__) && defined(__GNUC__) && !defined(STEWARD_SCALAR)
#define STEWARD_AVX2 0
#define STEWARD_SSE2 1
#include <emmintrin.h>
#else
#define STEWARD_AVX2 0
#define STEWARD_SSE2 0
#endif

#if FLT_EVAL_METHOD != 0
#error "steward_podrace.hpp: doubles must be computed as doubles; on 32-bit x86 compile with -msse2 -mfpmath=sse"
#endif
#if defined(__clang__) && defined(__FAST_MATH__)
#error "steward_podrace.hpp: clang cannot be told to be exact within a file: compile without -ffast-math and -Ofast"
#endif

#if defined(__clang__) || defined(_MSC_VER)
#pragma float_control(precise, on, push)
#if defined(__clang__)
#pragma clang fp contract(off)
#else
#pragma fp_contract(off)
#endif
#elif defined(__GNUC__)
#pragma GCC push_options
#pragma GCC optimize("no-fast-math,fp-contract=off,no-math-errno")
#endif
#if defined(__GNUC__)
#define STEWARD_ONE_CALL __attribute__((noinline))
#define STEWARD_INLINE __attribute__((always_inline)) inline
#elif defined(_MSC_VER)
#define STEWARD_ONE_CALL __declspec(noinline)
#define STEWARD_INLINE __forceinline
#else
#define STEWARD_ONE_CALL
#define STEWARD_INLINE inline
#endif

namespace steward {

/// Instead of a thrust: no command (the pod drifts), raise the shield, boost.
enum : int { NO_COMMAND = -1, SHIELD = -2, BOOST = -3 };

/// Live: today's server. Contest: the published referee, for which 600 u exactly count everywhere on a path.
enum class Rules { live, contest };

/// Degrees to radians, one rounding; for headings as bots see them. Below 0 (no heading yet): NaN.
inline double radians(double degrees) {
    return degrees < 0 ? std::nan("") : degrees * 0.017453292519943295;
}

namespace podrace {

constexpr double PI = 3.141592653589793, FULL_TURN = 2 * PI, MAXIMUM_TURN = PI / 10;
constexpr double TOUCH = 800, CHECKPOINT = 600, KEEP = 1 - 0.15, PUSH_OUT = 1e-5, WINDOW = 1e-5;
/* The greatest numbers whose roots, as they are rounded, are at most CHECKPOINT, and below it. */
constexpr double AT_CHECKPOINT = 0x1.5f90000000001p+18, WITHIN_CHECKPOINT = 0x1.5f8fffffffffep+18;
constexpr double FAR_OUT = 0x1p30, TINY = 0x1p-100;
constexpr double SHORT = 0x1p24;                       // beside longer segments rounding exceeds the margin of filters
constexpr int PODS = 4, MOST_IMPACTS = 10000 + 1000 * PODS;
constexpr int TIMER = 7, HEAVY = 8, BOOST_LEFT = 16;

inline std::uint64_t bits(double value) {
    std::uint64_t word;
    std::memcpy(&word, &value, 8);
    return word;
}

inline double number(std::uint64_t word) {
    double value;
    std::memcpy(&value, &word, 8);
    return value;
}

/* The number of the lowest bit that is set. */
inline int lowest(int set) {
#if defined(__GNUC__)
    return __builtin_ctz(static_cast<unsigned>(set));
#else
    int number = 0;
    for (; !(set >> number & 1); number++) { }
    return number;
#endif
}

/* ---- Lanes: a number of each pod, the four in one register, in two, or in four. Operations on several registers do
   not wait for each other. ---- */

#if STEWARD_AVX2
constexpr int LANES = 4;                               // of a register
typedef __m256d V;
typedef __m256d M;
STEWARD_INLINE V all(double value) { return _mm256_set1_pd(value); }
STEWARD_INLINE V load(const double* from) { return _mm256_loadu_pd(from); }
STEWARD_INLINE void store(double* to, V value) { _mm256_storeu_pd(to, value); }
STEWARD_INLINE V whole(const std::int32_t* from) {
    return _mm256_cvtepi32_pd(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from)));
}
STEWARD_INLINE M less(V a, V b) { return _mm256_cmp_pd(a, b, _CMP_LT_OQ); }
STEWARD_INLINE M atMost(V a, V b) { return _mm256_cmp_pd(a, b, _CMP_LE_OQ); }
STEWARD_INLINE M equal(V a, V b) { return _mm256_cmp_pd(a, b, _CMP_EQ_OQ); }
STEWARD_INLINE M isNan(V a) { return _mm256_cmp_pd(a, a, _CMP_UNORD_Q); }
STEWARD_INLINE M both(M a, M b) { return _mm256_and_pd(a, b); }
STEWARD_INLINE M either(M a, M b) { return _mm256_or_pd(a, b); }
STEWARD_INLINE M without(M a, M b) { return _mm256_andnot_pd(b, a); }
STEWARD_INLINE V select(M mask, V yes, V no) { return _mm256_blendv_pd(no, yes, mask); }
STEWARD_INLINE V onlyIf(M mask, V value) { return _mm256_and_pd(mask, value); }
STEWARD_INLINE int lanesOf(M mask) { return _mm256_movemask_pd(mask); }
STEWARD_INLINE V size(V a) { return _mm256_andnot_pd(all(-0.0), a); }
/* The sign of the second on the first, which has none. */
STEWARD_INLINE V withSign(V of, V sign) { return _mm256_or_pd(of, _mm256_and_pd(all(-0.0), sign)); }
/* Turns the sign of one by that of another. */
STEWARD_INLINE V oppositeIf(V of, V sign) { return _mm256_xor_pd(of, _mm256_and_pd(all(-0.0), sign)); }
/* The next greater double in size. */
STEWARD_INLINE V next(M mask, V of) { return _mm256_castsi256_pd(_mm256_sub_epi64(_mm256_castpd_si256(of),
    _mm256_castpd_si256(mask))); }
/* Numbers below 2^51 in size, rounded down and toward zero. */
STEWARD_INLINE V roundDown(V a) { return _mm256_floor_pd(a); }
STEWARD_INLINE V cut(V a) { return _mm256_round_pd(a, _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC); }
/* Of pods 1, 2, 3, 0, and 2, 3, 0, 1. */
STEWARD_INLINE V nextPods(V a) { return _mm256_permute4x64_pd(a, 0x39); }
STEWARD_INLINE V oppositePods(V a) { return _mm256_permute4x64_pd(a, 0x4e); }
#else
template <class T> struct Pair { T low, high; };
template <class T> STEWARD_INLINE Pair<T> pair(T low, T high) { return {low, high}; }
#if STEWARD_SSE2
constexpr int LANES = 2;
struct Two { __m128d of; };
typedef Pair<Two> V;
typedef Pair<Two> M;
STEWARD_INLINE Two two(double value) { return {_mm_set1_pd(value)}; }
STEWARD_INLINE Two operator+(Two a, Two b) { return {_mm_add_pd(a.of, b.of)}; }
STEWARD_INLINE Two operator-(Two a, Two b) { return {_mm_sub_pd(a.of, b.of)}; }
STEWARD_INLINE Two operator*(Two a, Two b) { return {_mm_mul_pd(a.of, b.of)}; }
STEWARD_INLINE Two operator/(Two a, Two b) { return {_mm_div_pd(a.of, b.of)}; }
STEWARD_INLINE Two less(Two a, Two b) { return {_mm_cmplt_pd(a.of, b.of)}; }
STEWARD_INLINE Two atMost(Two a, Two b) { return {_mm_cmple_pd(a.of, b.of)}; }
STEWARD_INLINE Two equal(Two a, Two b) { return {_mm_cmpeq_pd(a.of, b.of)}; }
STEWARD_INLINE Two isNan(Two a) { return {_mm_cmpunord_pd(a.of, a.of)}; }
STEWARD_INLINE Two both(Two a, Two b) { return {_mm_and_pd(a.of, b.of)}; }
STEWARD_INLINE Two either(Two a, Two b) { return {_mm_or_pd(a.of, b.of)}; }
STEWARD_INLINE Two without(Two a, Two b) { return {_mm_andnot_pd(b.of, a.of)}; }
STEWARD_INLINE Two select(Two mask, Two yes, Two no) { return either(both(mask, yes), without(no, mask)); }
STEWARD_INLINE Two onlyIf(Two mask, Two value) { return both(mask, value); }
STEWARD_INLINE Two size(Two a) { return without(a, two(-0.0)); }
STEWARD_INLINE Two withSign(Two of, Two sign) { return either(of, both(two(-0.0), sign)); }
STEWARD_INLINE Two oppositeIf(Two of, Two sign) { return {_mm_xor_pd(of.of, both(two(-0.0), sign).of)}; }
STEWARD_INLINE Two next(Two mask, Two of) {
    return {_mm_castsi128_pd(_mm_sub_epi64(_mm_castpd_si128(of.of), _mm_castpd_si128(mask.of)))};
}
/* Adding 1.5 2^52 rounds to the nearest whole number. */
STEWARD_INLINE Two roundDown(Two a) {
    Two near = (a + two(0x1.8p52)) - two(0x1.8p52);
    return near - onlyIf(less(a, near), two(1));
}
STEWARD_INLINE Two cut(Two a) { return withSign(roundDown(size(a)), a); }
STEWARD_INLINE V all(double value) { return {two(value), two(value)}; }
STEWARD_INLINE V load(const double* from) { return {{_mm_loadu_pd(from)}, {_mm_loadu_pd(from + 2)}}; }
STEWARD_INLINE void store(double* to, V value) {
    _mm_storeu_pd(to, value.low.of);
    _mm_storeu_pd(to + 2, value.high.of);
}
STEWARD_INLINE V whole(const std::int32_t* from) {
    return {{_mm_cvtepi32_pd(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(from)))},
        {_mm_cvtepi32_pd(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(from + 2)))}};
}
STEWARD_INLINE int lanesOf(M mask) { return _mm_movemask_pd(mask.low.of) | _mm_movemask_pd(mask.high.of) << 2; }
STEWARD_INLINE V nextPods(V a) {
    return {{_mm_shuffle_pd(a.low.of, a.high.of, 1)}, {_mm_shuffle_pd(a.high.of, a.low.of, 1)}};
}
#else
constexpr int LANES = 1;
typedef Pair<Pair<double>> V;
typedef Pair<Pair<bool>> M;
STEWARD_INLINE bool less(double a, double b) { return a < b; }
STEWARD_INLINE bool atMost(double a, double b) { return a <= b; }
STEWARD_INLINE bool equal(double a, double b) { return a == b; }
STEWARD_INLINE bool isNan(double a) { return a != a; }
STEWARD_INLINE bool both(bool a, bool b) { return a && b; }
STEWARD_INLINE bool either(bool a, bool b) { return a || b; }
STEWARD_INLINE bool without(bool a, bool b) { return a && !b; }
STEWARD_INLINE double select(bool mask, double yes, double no) { return mask ? yes : no; }
STEWARD_INLINE double onlyIf(bool mask, double value) { return mask ? value : 0.0; }
STEWARD_INLINE double size(double a) { return number(bits(a) & ~0ull >> 1); }
STEWARD_INLINE double withSign(double of, double sign) { return number(bits(of) | (bits(sign) & 1ull << 63)); }
STEWARD_INLINE double oppositeIf(double of, double sign) { return number(bits(of) ^ (bits(sign) & 1ull << 63)); }
STEWARD_INLINE double next(bool mask, double of) { return number(bits(of) + (mask ? 1 : 0)); }
STEWARD_INLINE double cut(double a) { return static_cast<double>(static_cast<std::int64_t>(a)); }
STEWARD_INLINE double roundDown(double a) { double toZero = cut(a); return toZero > a ? toZero - 1 : toZero; }
STEWARD_INLINE V all(double value) { return {{value, value}, {value, value}}; }
STEWARD_INLINE V load(const double* from) { return {{from[0], from[1]}, {from[2], from[3]}}; }
STEWARD_INLINE void store(double* to, V value) {
    to[0] = value.low.low;
    to[1] = value.low.high;
    to[2] = value.high.low;
    to[3] = value.high.high;
}
STEWARD_INLINE V whole(const std::int32_t* from) {
    return {{1.0 * from[0], 1.0 * from[1]}, {1.0 * from[2], 1.0 * from[3]}};
}
STEWARD_INLINE int lanesOf(M mask) {
    return (mask.low.low ? 1 : 0) | (mask.low.high ? 2 : 0) | (mask.high.low ? 4 : 0) | (mask.high.high ? 8 : 0);
}
STEWARD_INLINE V nextPods(V a) { return {{a.low.high, a.high.low}, {a.high.high, a.low.low}}; }
#endif
#define STEWARD_OF_ONE(of) template <class T> STEWARD_INLINE auto of(Pair<T> a) { return pair(of(a.low), of(a.high)); }
#define STEWARD_OF_TWO(of) template <class T, class U> STEWARD_INLINE auto of(Pair<T> a, Pair<U> b) { \
    return pair(of(a.low, b.low), of(a.high, b.high)); }
STEWARD_OF_ONE(isNan) STEWARD_OF_ONE(size) STEWARD_OF_ONE(roundDown) STEWARD_OF_ONE(cut)
STEWARD_OF_TWO(less) STEWARD_OF_TWO(atMost) STEWARD_OF_TWO(equal)
STEWARD_OF_TWO(both) STEWARD_OF_TWO(either) STEWARD_OF_TWO(without)
STEWARD_OF_TWO(onlyIf) STEWARD_OF_TWO(withSign) STEWARD_OF_TWO(oppositeIf) STEWARD_OF_TWO(next)
#undef STEWARD_OF_ONE
#undef STEWARD_OF_TWO
template <class T> STEWARD_INLINE Pair<T> operator+(Pair<T> a, Pair<T> b) { return {a.low + b.low, a.high + b.high}; }
template <class T> STEWARD_INLINE Pair<T> operator-(Pair<T> a, Pair<T> b) { return {a.low - b.low, a.high - b.high}; }
template <class T> STEWARD_INLINE Pair<T> operator*(Pair<T> a, Pair<T> b) { return {a.low * b.low, a.high * b.high}; }
template <class T> STEWARD_INLINE Pair<T> operator/(Pair<T> a, Pair<T> b) { return {a.low / b.low, a.high / b.high}; }
template <class T, class U> STEWARD_INLINE Pair<U> select(Pair<T> mask, Pair<U> yes, Pair<U> no) {
    return {select(mask.low, yes.low, no.low), select(mask.high, yes.high, no.high)};
}
STEWARD_INLINE V oppositePods(V a) { return {a.high, a.low}; }
#endif
constexpr int EVERY = (1 << PODS) - 1;                 // as a mask's lanes
STEWARD_INLINE bool any(M mask) { return lanesOf(mask) != 0; }
STEWARD_INLINE bool every(M mask) { return lanesOf(mask) == EVERY; }

/* ---- Sine and cosine by their series in 192 binary digits: for what the quick form leaves in doubt. ---- */

/* A fraction of 192 binary digits, the least word first. */
struct Wide { std::uint64_t w[3]; };

constexpr std::uint64_t high(std::uint64_t a, std::uint64_t b) {
#if defined(__SIZEOF_INT128__)
    __extension__ typedef unsigned __int128 Product;
    return static_cast<std::uint64_t>(static_cast<Product>(a) * b >> 64);
#else
    std::uint64_t al = a & 0xffffffffu, ah = a >> 32, bl = b & 0xffffffffu, bh = b >> 32;
    std::uint64_t middle = ah * bl + (al * bl >> 32), lower = al * bh + (middle & 0xffffffffu);
    return ah * bh + (middle >> 32) + (lower >> 32);
#endif
}

/* Adds to a number of words from one of them on. */
inline void add(std::uint64_t* to, int at, int words, std::uint64_t value) {
    for (; value != 0 && at < words; at++) {
        to[at] += value;
        value = to[at] < value;
    }
}

inline Wide times(const Wide& a, const Wide& b) {
    std::uint64_t product[6] = {};
    for (int i = 0; i < 3; i++) {
        std::uint64_t carry = 0;
        for (int j = 0; j < 3; j++) {
            std::uint64_t lower = a.w[i] * b.w[j] + carry, upper = high(a.w[i], b.w[j]) + (lower < carry);
            product[i + j] += lower;
            carry = upper + (product[i + j] < lower);
        }
        product[i + 3] = carry;
    }
    return {{product[3], product[4], product[5]}};
}

/* a - b, not below 0; of a = 0 that is 1 - b. */
inline Wide minus(const Wide& a, const Wide& b) {
    std::uint64_t first = a.w[0] - b.w[0], second = a.w[1] - b.w[1];
    std::uint64_t borrow = a.w[0] < b.w[0], next = (a.w[1] < b.w[1]) + (second < borrow);
    return {{first, second - borrow, a.w[2] - b.w[2] - next}};
}

/* Divides by a small whole number. */
constexpr Wide divided(Wide a, std::uint64_t by) {
    std::uint64_t rest = 0;
    for (int k = 2; k >= 0; k--) {
        std::uint64_t upper = rest << 32 | a.w[k] >> 32;
        std::uint64_t lower = upper % by << 32 | (a.w[k] & 0xffffffffu);
        a.w[k] = upper / by << 32 | lower / by;
        rest = lower % by;
    }
    return a;
}

inline int zerosAhead(std::uint64_t word) {
    int zeros = 0;
    for (; zeros < 64 && !(word >> (63 - zeros) & 1); zeros++) { }
    return zeros;
}

/* The nearest double to a fraction of at least 2^-64. */
inline double nearest(const Wide& a) {
    int zeros = zerosAhead(a.w[2]);
    std::uint64_t digits = zeros == 64 ? a.w[1] : a.w[2] << zeros | a.w[1] >> 1 >> (63 - zeros);
    std::uint64_t rounded = (digits >> 11) + (digits >> 10 & 1);
    return number((static_cast<std::uint64_t>(1021 - zeros) << 52) + rounded);
}

/* The binary digits of 2 / pi behind the point, two words of zeros ahead. */
constexpr std::uint64_t TWO_OVER_PI[] = {
    0, 0, 0xa2f9836e4e441529u, 0xfc2757d1f534ddc0u, 0xdb6295993c439041u, 0xfe5163abdebbc561u, 0xb7246e3a424dd2e0u,
    0x06492eea09d1921cu, 0xfe1deb1cb129a73eu, 0xe88235f52ebb4484u, 0xe99c7026b45f7e41u, 0x3991d639835339f4u,
    0x9c845f8bbdf9283bu, 0x1ff897ffde05980fu, 0xef2f118b5a0a6d1fu, 0x6d367ecf27cb09b7u, 0x4f463f669e5fea2du,
    0x7527bac7ebe5f17bu, 0x3d0739f78a5292eau, 0x6bfb5fb11f8d5d08u, 0x56033046fc7b6babu, 0xf0cfbc209af4361du
};

inline std::uint64_t digitsOfTwoOverPi(int word, int shift) {
    return TWO_OVER_PI[word] << shift | TWO_OVER_PI[word + 1] >> 1 >> (63 - shift);
}

constexpr int LAST_POWER = 43;                         // (pi/4)^44 / 44! is below 2^-195

/* 1/n!, cut off. */
struct Reciprocals {
    Wide of[LAST_POWER + 1];
    constexpr Reciprocals() : of{} {
        of[2] = {{0, 0, 1ull << 63}};
        for (int n = 3; n <= LAST_POWER; n++) {
            of[n] = divided(of[n - 1], static_cast<std::uint64_t>(n));
        }
    }
};
inline constexpr Reciprocals RECIPROCALS{};

/* The square of an angle times (1/first! - square/(first + 2)! + ...). */
inline Wide alternating(const Wide& square, int last, int first) {
    Wide sum = {};
    for (int n = last; n >= first; n -= 2) {
        sum = times(minus(RECIPROCALS.of[n], sum), square);
    }
    return sum;
}

/* Both of any finite angle, correctly rounded (Payne and Hanek's reduction; worst cases need 168 digits). */
inline void turnSlowly(double angle, double& cosine, double& sine) {
    double positive = number(bits(angle) & ~0ull >> 1);
    if (positive < 0x1p-27) {                          // the sine is nearest to the angle, the cosine to 1
        cosine = 1;
        sine = angle;
        return;
    }
    std::uint64_t word = bits(positive), mantissa = (word & ((1ull << 52) - 1)) | 1ull << 52;
    int position = static_cast<int>(word >> 52) - 1023 - 54 + 128;
    std::uint64_t turns[5] = {};                       // the fraction of a turn, 256 digits, the least word first
    for (int k = 0; k < 4; k++) {
        std::uint64_t digits = digitsOfTwoOverPi((position >> 6) + 3 - k, position & 63);
        add(turns, k, 5, mantissa * digits);
        add(turns, k + 1, 5, high(mantissa, digits));
    }
    int quarter = static_cast<int>((turns[3] + (1ull << 61)) >> 62);
    std::uint64_t rest = turns[3] - (static_cast<std::uint64_t>(quarter) << 62);
    std::uint64_t sign = rest >> 63 ? ~0ull : 0;
    std::uint64_t w[4] = {turns[0] ^ sign, turns[1] ^ sign, turns[2] ^ sign, rest ^ sign};
    Wide eighths = {{w[1] << 3 | w[0] >> 61, w[2] << 3 | w[1] >> 61, w[3] << 3 | w[2] >> 61}};
    Wide reduced = times(eighths, {{0x29024e088a67cc74u, 0xc4c6628b80dc1cd1u, 0xc90fdaa22168c234u}});
    Wide square = times(reduced, reduced);
    double c = nearest(minus({}, alternating(square, LAST_POWER - 1, 2)));
    double s = nearest(minus(reduced, times(alternating(square, LAST_POWER, 3), reduced)));
    s = sign != 0 ? -s : s;
    bool odd = (quarter & 1) != 0;
    double turnedCosine = odd ? s : c, turnedSine = odd ? c : s;
    quarter &= 3;
    cosine = quarter == 1 || quarter == 2 ? -turnedCosine : turnedCosine;
    sine = (quarter >= 2) != (angle < 0) ? -turnedSine : turnedSine;
}

/* ---- Sine and cosine, quickly: a table, short polynomials, and a test whether the rounding is certain. ---- */

/* sin(k pi / 128), k = 0..64: a multiple of 2^-26 and the rest. */
constexpr double FIRST_QUARTER[] = {
    0, 0, 0x1.92156p-6, -0x1.0b933040d8eb2p-31, 0x1.91f66p-5, -0x1.de44fd832257ap-30, 0x1.2d5208p-4,
    0x1.2ce19f5ccbeefp-28, 0x1.917a6cp-4, -0x1.eb25ea0f138c7p-31, 0x1.f564e4p-4, 0x1.6a9730e344e09p-28, 0x1.2c8106p-3,
    0x1.d1cc27444c003p-28, 0x1.5e2144p-3, 0x1.22cff19531ff7p-29, 0x1.8f8b84p-3, -0x1.cb2cfaa4da337p-30, 0x1.c0b826p-3,
    0x1.4fc9ec5f943afp-28, 0x1.f19f98p-3, -0x1.37a839542deefp-29, 0x1.111d26p-2, 0x1.58fb3bb049841p-29, 0x1.294063p-2,
    -0x1.2a60fa574a369p-30, 0x1.4135c9p-2, 0x1.05d98050c97c5p-28, 0x1.58f9a7p-2, 0x1.6ac7f73f8409p-28, 0x1.708853p-2,
    0x1.f48b3d5da731p-31, 0x1.87de2ap-2, 0x1.abaa58b469891p-28, 0x1.9ef794p-2, 0x1.d476c516da813p-29, 0x1.b5d101p-2,
    -0x1.87a8cff5264eap-28, 0x1.cc66eap-2, -0x1.b38ee87a5ebc7p-28, 0x1.e2b5d4p-2, -0x1.fe4271387c9dcp-28,
    0x1.f8ba4ep-2, -0x1.01d951812ec2p-28, 0x1.0738798p-1, 0x1.22ffed9697fafp-29, 0x1.11eb358p-1,
    -0x1.f25a6ebde476dp-28, 0x1.1c73b38p-1, 0x1.ae68c86c9774ap-29, 0x1.26d055p-1, -0x1.917690abb4e88p-28,
    0x1.30ff8p-1, -0x1.8f47e58f7e631p-28, 0x1.3affa28p-1, 0x1.2050b93c7c4bcp-29, 0x1.44cf328p-1,
    -0x1.7b7114f3fc4afp-28, 0x1.4e6cab8p-1, 0x1.f1f2f489e149fp-28, 0x1.57d6938p-1, -0x1.b989b02eae413p-28,
    0x1.610b758p-1, -0x1.7169909251b35p-28, 0x1.6a09e68p-1, -0x1.80c4336f74d05p-29, 0x1.72d0838p-1,
    -0x1.00069bcac43c4p-33, 0x1.7b5df2p-1, 0x1.3557d76f0ac85p-28, 0x1.83b0e08p-1, 0x1.ffcbb6e90bdfp-28,
    0x1.8bc8068p-1, 0x1.8a8ba05a743dap-28, 0x1.93a2248p-1, 0x1.9263fb4f5066ap-29, 0x1.9b3e048p-1,
    -0x1.8f17e98771434p-34, 0x1.a29a7ap-1, 0x1.189e0776ba27fp-31, 0x1.a9b6628p-1, 0x1.0ea1a3033ec62p-29,
    0x1.b090a58p-1, 0x1.501ff9b64974p-33, 0x1.b728348p-1, -0x1.7348e1378d3e6p-28, 0x1.bd7c0bp-1,
    -0x1.c8356b304b4e6p-28, 0x1.c38b2fp-1, 0x1.80bdb0d23e9d1p-29, 0x1.c954b2p-1, 0x1.3411f4f68244fp-29,
    0x1.ced7af8p-1, -0x1.e19c46879edafp-28, 0x1.d4134dp-1, 0x1.4dc939ac42b5bp-29, 0x1.d906bdp-1,
    -0x1.9ae573aea067cp-30, 0x1.ddb13b8p-1, -0x1.333dc39f0f20ep-29, 0x1.e212108p-1, -0x1.84bc8da0298eep-28,
    0x1.e6288fp-1, -0x1.db8f7708b5ab8p-28, 0x1.e9f4158p-1, -0x1.39d225a27d387p-29, 0x1.ed740e8p-1,
    -0x1.2f6d3985f4e1cp-30, 0x1.f0a7ef8p-1, 0x1.c9186b952c7aep-28, 0x1.f38f3bp-1, -0x1.cd8d3b9d7bafbp-28,
    0x1.f6297dp-1, -0x1.1469faa77a357p-34, 0x1.f8764f8p-1, 0x1.38a5d49ab2567p-28, 0x1.fa7558p-1,
    -0x1.eeb5d2bd05465p-30, 0x1.fc2647p-1, 0x1.c33fa68f64334p-30, 0x1.fd88dap-1, 0x1.e89292cf04139p-28, 0x1.fe9cdbp-1,
    -0x1.7f3be2f56f099p-28, 0x1.ff621ep-1, 0x1.bcb6bef1d421fp-28, 0x1.ffd886p-1, 0x1.099a19765595dp-30, 1, 0
};

/* Per direction of 256 the two parts of the sine, then of the cosine. */
struct Directions {
    double row[256][4];
    constexpr Directions() : row() {
        for (int k = 0; k < 256; k++) {
            for (int part = 0; part < 4; part++) {
                int at = (k + (part < 2 ? 0 : 64)) % 256, half = at % 128, mirrored = half <= 64 ? half : 128 - half;
                double value = FIRST_QUARTER[2 * mirrored + part % 2];
                row[k][part] = at < 128 ? value : -value;
            }
        }
    }
};
inline constexpr Directions DIRECTIONS{};

#if STEWARD_SSE2
/* Two columns of four rows. */
STEWARD_INLINE void column(const double* const* rows, int at, V& first, V& second) {
    __m128d a = _mm_loadu_pd(rows[0] + at), b = _mm_loadu_pd(rows[1] + at);
    __m128d c = _mm_loadu_pd(rows[2] + at), d = _mm_loadu_pd(rows[3] + at);
    first = {{_mm_unpacklo_pd(a, b)}, {_mm_unpacklo_pd(c, d)}};
    second = {{_mm_unpackhi_pd(a, b)}, {_mm_unpackhi_pd(c, d)}};
}
#elif !STEWARD_AVX2
STEWARD_INLINE void column(const double* const* rows, int at, V& first, V& second) {
    first = {{rows[0][at], rows[1][at]}, {rows[2][at], rows[3][at]}};
    second = {{rows[0][at + 1], rows[1][at + 1]}, {rows[2][at + 1], rows[3][at + 1]}};
}
#endif

/* The rows of the directions given by the last eight bits of numbers, as columns. */
STEWARD_INLINE void directions(V shifted, V& s1, V& s2, V& c1, V& c2) {
#if STEWARD_AVX2
    alignas(32) std::uint64_t at[4];
    _mm256_store_si256(reinterpret_cast<__m256i*>(at), _mm256_castpd_si256(shifted));
    V r0 = load(DIRECTIONS.row[at[0] & 255]), r1 = load(DIRECTIONS.row[at[1] & 255]);
    V r2 = load(DIRECTIONS.row[at[2] & 255]), r3 = load(DIRECTIONS.row[at[3] & 255]);
    V low01 = _mm256_unpacklo_pd(r0, r1), high01 = _mm256_unpackhi_pd(r0, r1);
    V low23 = _mm256_unpacklo_pd(r2, r3), high23 = _mm256_unpackhi_pd(r2, r3);
    s1 = _mm256_permute2f128_pd(low01, low23, 0x20);
    s2 = _mm256_permute2f128_pd(high01, high23, 0x20);
    c1 = _mm256_permute2f128_pd(low01, low23, 0x31);
    c2 = _mm256_permute2f128_pd(high01, high23, 0x31);
#else
    double numbers[PODS];
    store(numbers, shifted);
    const double* rows[PODS];
    for (int pod = 0; pod < PODS; pod++) {
        rows[pod] = DIRECTIONS.row[bits(numbers[pod]) & 255];
    }
    column(rows, 0, s1, s2);
    column(rows, 2, c1, c2);
#endif
}

/* The angle is k pi/128 + r; with S, C of k pi/128, sin = S cos r + C sin r. First parts S1, C1, r1, cos1 are multiples
   of 2^-26, so that the heads below are exact; the rests are off by less than 2^-70.3 (Tang 1991, Ziv 1991; the proof
   of each step stands in Steward's SineCosine). If rests greater and less by 2^-70 round alike, so does the truth. */
STEWARD_INLINE void turn(V angle, M wanted, V& cosine, V& sine) {
    const V toWhole = all(0x1.8p52), toGrid = all(0x1.8p26), one = all(1), half = all(0.5), error = all(0x1p-70);
    V shifted = angle * all(0x1.45f306dc9c883p5) + toWhole;
    V steps = shifted - toWhole;
    V near = angle - steps * all(0x1.921fb5444p-6);
    V low = steps * all(0x1.68c234c4c6629p-45);
    V r1 = (near + toGrid) - toGrid;
    V r2 = (near - r1) - low;
    V r = near - low;
    V square = r * r;
    V halfSquare = (half * r1) * r1;
    V fourth = square * square;
    V sineTail = (r * square) * ((all(-1.0 / 6) + square * all(1.0 / 120)) + fourth * all(-1.0 / 5040));
    V cosineTail = fourth * (all(0x1.5555555549e75p-5) + square * all(-0x1.6c165d6916d32p-10));
    V sin2 = r2 + sineTail;
    V cos1 = ((one + toGrid) - halfSquare) - toGrid;
    V cos2 = ((one - cos1) - halfSquare) + (cosineTail - half * (r2 * (r1 + r)));
    V s1, s2, c1, c2;
    directions(shifted, s1, s2, c1, c2);
    V s = s1 + s2, c = c1 + c2;
    V headOfSine = s1 * cos1 + c1 * r1;
    V restOfSine = (s2 * cos1 + c2 * r1) + (s * cos2 + c * sin2);
    V headOfCosine = c1 * cos1 - s1 * r1;
    V restOfCosine = (c2 * cos1 - s2 * r1) + (c * cos2 - s * sin2);
    sine = headOfSine + (restOfSine + error);
    cosine = headOfCosine + (restOfCosine + error);
    M certain = both(equal(sine, headOfSine + (restOfSine - error)),
        both(equal(cosine, headOfCosine + (restOfCosine - error)), atMost(size(angle), all(0x1p10))));
    if (any(without(wanted, certain))) {
        int doubtful = lanesOf(without(wanted, certain));
        double angles[PODS], cosines[PODS], sines[PODS];
        store(angles, angle);
        store(cosines, cosine);
        store(sines, sine);
        for (int pod = 0; pod < PODS; pod++) {
            if (doubtful >> pod & 1) {
                turnSlowly(angles[pod], cosines[pod], sines[pod]);
            }
        }
        cosine = load(cosines);
        sine = load(sines);
    }
}

/* Cosines and sines of headings, for other files: by a call, so that these keep their own flags to themselves. */
STEWARD_ONE_CALL inline void directionsOf(const double* headings, double* cosines, double* sines) {
    V heading = load(headings), cosine, sine;
    turn(heading, equal(heading, heading), cosine, sine);
    store(cosines, cosine);
    store(sines, sine);
}

/* ---- The arc tangent of StrictMath: fdlibm's reductions, polynomial and order of operations. ---- */

STEWARD_INLINE V atan2(V y, V x) {
    const V one = all(1), pi = all(PI), piLow = all(0x1.1a62633145c07p-53), halfPi = all(PI / 2);
    V ratio = size(y / x);
    M range1 = atMost(all(0.4375), ratio), range2 = atMost(all(0.6875), ratio);
    M range3 = atMost(all(1.1875), ratio), range4 = atMost(all(2.4375), ratio);
    // rest = (p ratio - q) / (p + q ratio), and atan(ratio) = atan(q / p) + atan(rest)
    V p = select(range2, select(range4, all(0), one), select(range1, all(2), one));
    V q = select(range3, select(range4, one, all(1.5)), onlyIf(range1, one));
    V up = select(range2, select(range3, select(range4, halfPi, all(0x1.f730bd281f69bp-1)), all(PI / 4)),
        onlyIf(range1, all(0x1.dac670561bb4fp-2)));
    V upLow = select(range2, select(range3, select(range4, all(0x1.1a62633145c07p-54), all(0x1.007887af0cbbdp-56)),
        all(0x1.1a62633145c07p-55)), onlyIf(range1, all(0x1.a2b7f222f65e2p-56)));
    V rest = (p * ratio - q) / (p + q * ratio);
    V z = rest * rest, w = z * z;
    V even = z * (all(0x1.555555555550dp-2) + w * (all(0x1.24924920083ffp-3) + w * (all(0x1.745cdc54c206ep-4)
        + w * (all(0x1.10d66a0d03d51p-4) + w * (all(0x1.97b4b24760debp-5) + w * all(0x1.0ad3ae322da11p-6))))));
    V odd = w * (all(-0x1.999999998ebc4p-3) + w * (all(-0x1.c71c6fe231671p-4) + w * (all(-0x1.3b0f2af749a6dp-4)
        + w * (all(-0x1.dde2d52defd9ap-5) + w * all(-0x1.2b4442c6a6c2fp-5)))));
    V angle = up - ((rest * (even + odd) - upLow) - rest);
    M small = less(ratio, all(0x1p-28)), great = less(all(0x1p58), ratio);       // great if x is 0, too
    M special = either(small, great);
    if (any(special)) {
        angle = select(great, halfPi, select(small, ratio, angle));
    }
    return withSign(select(atMost(all(0), x), angle, pi - (angle - piLow)), y);
}

/* ---- Headings. ---- */

/* Sizes modulo FULL_TURN. */
STEWARD_ONE_CALL inline void remainders(double* sizes) {
    for (int pod = 0; pod < PODS; pod++) {
        sizes[pod] = std::fmod(sizes[pod], FULL_TURN);
    }
}

/* The heading after a turn towards another by at most 18 degrees; the other if there is none yet. The rules take
   delta = (other - heading) % FULL_TURN and 2 delta % FULL_TURN - delta, which is delta below half a turn and
   delta - FULL_TURN from there on: differences within a factor of 2 are exact. */
STEWARD_INLINE V turned(V heading, V other) {
    const V turn = all(FULL_TURN), half = all(PI), most = all(MAXIMUM_TURN);
    V difference = other - heading;
    V delta = size(difference), once = delta - turn, twice = once - turn;
    V shortest = select(less(delta, half), delta, select(less(once, half), once, twice));
    if (any(atMost(turn, once))) {                     // two turns or more between them
        double sizes[PODS];
        store(sizes, delta);
        remainders(sizes);
        delta = load(sizes);
        shortest = select(less(delta, half), delta, delta - turn);
    }
    V side = withSign(most, oppositeIf(shortest, difference));
    return select(atMost(most, size(shortest)), heading + side, other);
}

/* ---- Impacts. ---- */

/* Pairs as bits in the order of the referee's scan: 3-2, 3-1, 3-0, 2-1, 2-0, 1-0. */
constexpr int FIRST[] = {3, 3, 3, 2, 2, 1}, SECOND[] = {2, 1, 0, 1, 0, 0};

/* True if two circles whose centres are (dx, dy) apart surely stay farther apart than they may, the square of which is
   reach less 1, until time: then the rules' own expressions find no impact (proof in Steward's OfficialAdvance). */
STEWARD_INLINE M staysFar(V dx, V dy, V wx, V wy, V time, V reach) {
    const V zero = all(0);
    V c = all(1 - 0x1p-40) * (dx * dx + dy * dy) - reach;
    V b = dx * wx + dy * wy;
    M far = less(zero, c + (b - size(b)) * time);
    if (every(far)) {
        return far;
    }
    V a = wx * wx + wy * wy;
    V late = (a * time + all(2) * b) * time + c;
    M laterFar = either(both(atMost(a * time, zero - b), less(zero, late)),
        both(less(zero - b, a * time), less(b * b - a * c, zero)));
    return either(far, both(less(zero, c), laterFar));
}

/* Places and velocities of the pods. */
struct Motion {
    V x, y, vx, vy;

    STEWARD_INLINE void fly(double time) {
        x = x + vx * all(time);
        y = y + vy * all(time);
    }
};

/* The pairs that may meet before the time left is over. */
STEWARD_INLINE int nearPairs(const Motion& of, double left) {
    const V time = all(left), reach = all(TOUCH * TOUCH + 1);
    int next = lanesOf(staysFar(of.x - nextPods(of.x), of.y - nextPods(of.y), of.vx - nextPods(of.vx),
        of.vy - nextPods(of.vy), time, reach));
    int opposite = lanesOf(staysFar(of.x - oppositePods(of.x), of.y - oppositePods(of.y),
        of.vx - oppositePods(of.vx), of.vy - oppositePods(of.vy), time, reach));
    if ((next & opposite) == EVERY) {
        return 0;
    }
    next ^= EVERY;
    opposite ^= EVERY;
    return (next >> 2 & 1) | (opposite & 2) | (next >> 3 & 1) << 2 | (next >> 1 & 1) << 3 | (opposite & 1) << 4
        | (next & 1) << 5;
}

/* The pods in a turn with impacts, and the corners of their paths: one an impact, a later one at the same time replaces
   it. */
struct Flight {
    struct Corner { double time, x, y; int pod; };

    alignas(32) double x[PODS], y[PODS], vx[PODS], vy[PODS];
    double inverseMass[PODS];
    int corners = 0, last[PODS] = {-1, -1, -1, -1};
    Corner some[32];
    std::vector<Corner> more;

    Flight(const Motion& from, const std::int32_t* flags) {
        store(x, from.x);
        store(y, from.y);
        store(vx, from.vx);
        store(vy, from.vy);
        for (int pod = 0; pod < PODS; pod++) {
            inverseMass[pod] = flags[pod] & HEAVY ? 1.0 / 10 : 1;
        }
    }

    Motion motion() const { return {load(x), load(y), load(vx), load(vy)}; }

    const Corner& corner(int k) const { return k < 32 ? some[k] : more[k - 32]; }

    void addCorner(int pod, double time) {
        if (last[pod] < 0 || corner(last[pod]).time != time) {
            if (corners >= 32) {
                more.push_back({});
            }
            last[pod] = corners++;
        }
        int at = last[pod];
        (at < 32 ? some[at] : more[at - 32]) = {time, x[pod], y[pod], pod};
    }

    void fly(double time) {
        for (int pod = 0; pod < PODS; pod++) {
            x[pod] += vx[pod] * time;
            y[pod] += vy[pod] * time;
        }
    }

    void react(int a, int b, double time) {
        double dx = x[b] - x[a], dy = y[b] - y[a];
        double distance = std::sqrt(dx * dx + dy * dy);
        double nx = distance == 0 ? 1 : dx / distance, ny = distance == 0 ? 0 : dy / distance;
        double inverse = inverseMass[a] + inverseMass[b];
        double first = (nx * (vx[a] - vx[b]) + ny * (vy[a] - vy[b])) / inverse;
        double impulse = first + (first > 120 ? first : 120);
        vx[a] -= nx * impulse * inverseMass[a];
        vy[a] -= ny * impulse * inverseMass[a];
        vx[b] += nx * impulse * inverseMass[b];
        vy[b] += ny * impulse * inverseMass[b];
        if (distance <= TOUCH) {
            double each = (TOUCH - distance) / 2 + PUSH_OUT;
            x[a] -= nx * each;
            y[a] -= ny * each;
            x[b] += nx * each;
            y[b] += ny * each;
        }
        addCorner(a, time);
        addCorner(b, time);
    }

    /* Plays the impacts of the turn. Returns false if there are too many. */
    bool collide(int near) {
        double now = 0;
        for (int left = MOST_IMPACTS;;) {
            double times[6];
            int pairs[6], found = 0;
            for (; near != 0; near &= near - 1) {
                int pair = lowest(near);
                double time;
                if (meets(FIRST[pair], SECOND[pair], 1 - now, time)) {
                    int k = found++;
                    for (; k > 0 && times[k - 1] > now + time; k--) {
                        times[k] = times[k - 1];
                        pairs[k] = pairs[k - 1];
                    }
                    times[k] = now + time;
                    pairs[k] = pair;
                }
            }
            if (found == 0 || left <= 0) {
                fly(1 - now);
                return found == 0;
            }
            fly(times[0] - now);
            now = times[0];
            for (int k = 0; k < found && times[k] - now <= WINDOW; k++, left--) {
                react(FIRST[pairs[k]], SECOND[pairs[k]], times[k]);
            }
            near = nearPairs(motion(), 1 - now);
        }
    }

    bool meets(int i, int j, double left, double& time) const {
        double dx = x[i] - x[j], dy = y[i] - y[j];
        double square = dx * dx + dy * dy;
        time = 0;
        if (square <= TOUCH * TOUCH) {                 // exactly when its root is at most 800
            return true;
        }
        double wx = vx[i] - vx[j], wy = vy[i] - vy[j];
        double b = dx * wx + dy * wy;
        if (b >= 0) {                                  // then the time is not above 0
            return false;
        }
        double a = wx * wx + wy * wy, c = square - TOUCH * TOUCH;
        double discriminant = b * b - a * c;
        if (!(discriminant > 0) || a == 0) {
            return false;
        }
        time = (-b - std::sqrt(discriminant)) / a;
        return time > 0 && time <= left;
    }
};

/* The square of the distance of a point from the segment a-b, by the operations of java.awt.geom.Line2D.ptSegDist, which
   takes the root of it, and of 0 if rounding makes it less. */
inline double squareOfDistance(double x, double y, double ax, double ay, double bx, double by) {
    double dx = bx - ax, dy = by - ay, ex = x - ax, ey = y - ay, projected = 0;
    double along = ex * dx + ey * dy;
    if (along > 0) {
        ex = dx - ex;
        ey = dy - ey;
        along = ex * dx + ey * dy;
        if (along > 0) {
            projected = along * along / (dx * dx + dy * dy);
        }
    }
    return ex * ex + ey * ey - projected;
}

/* True if a point is surely more than CHECKPOINT from the segment a-b, by the rules' operations too: it is farther from
   a than CHECKPOINT and the segment together, as (r + s)^2 is at most 2 (r^2 + s^2). */
inline bool isFar(double x, double y, double ax, double ay, double bx, double by) {
    double dx = bx - ax, dy = by - ay, ex = x - ax, ey = y - ay, square = dx * dx + dy * dy;
    return square < SHORT * SHORT && ex * ex + ey * ey > 2 * (square + (CHECKPOINT * CHECKPOINT + 1));
}

} // namespace podrace

/// The state of four pods between two turns. Copy it by assignment; change it by Map::set.
struct alignas(32) State {
    double x[4], y[4];             ///< in u, whole after a turn
    double vx[4], vy[4];           ///< in u per turn, whole after a turn
    double heading[4];             ///< in radians, not normalised; NaN while unset
    std::int32_t flags[4];         ///< see timer and boostLeft
    std::int32_t passed[4];        ///< checkpoints passed since the start
    std::int32_t next[4];          ///< number of the next checkpoint
    std::int32_t left[2];          ///< turns left, per player, to pass a checkpoint

    /// 4 after the turn of the shield, counting down to 0.
    int timer(int pod) const { return flags[pod] & podrace::TIMER; }
    bool boostLeft(int pod) const { return (flags[pod] & podrace::BOOST_LEFT) != 0; }
};
static_assert(sizeof(State) <= 256, "a state is copied often");

/// One command per pod; none at first. A command stays until another is set.
struct alignas(32) Commands {
    double x[4], y[4];             ///< the target; of a command by angle the radians and NaN
    std::int32_t thrust[4];

    Commands() : x(), y(), thrust{NO_COMMAND, NO_COMMAND, NO_COMMAND, NO_COMMAND} { }

    /// Steers as a bot's answer. Coordinates: 0 or 2^-300..2^300 in size. Thrust: 0..650, SHIELD, BOOST, NO_COMMAND.
    void target(int pod, double targetX, double targetY, int power) {
        x[pod] = targetX;
        y[pod] = targetY;
        thrust[pod] = power;
    }

    /// Turns by -18..18 degrees, more count as 18, 0 or from 2^-300 on; positive is clockwise on the screen. A pod
    /// without a heading neither turns nor thrusts.
    void turn(int pod, double degrees, int power) {
        x[pod] = (degrees < -18 ? -18 : degrees < 18 ? degrees : 18) * 0.017453292519943295;
        y[pod] = podrace::number(0x7ff8000000000000u);
        thrust[pod] = power;
    }
};

/// A map with its rules, and the turn. Immutable: many threads may use one.
class Map {
public:
    /// Throws std::invalid_argument for a map that cannot be, std::runtime_error if the arithmetic is not exact.
    explicit Map(const std::vector<std::pair<double, double>>& checkpoints, Rules rules = Rules::live)
        : squareOfPath(rules == Rules::live ? podrace::WITHIN_CHECKPOINT : podrace::AT_CHECKPOINT),
          squareOfEnd(rules == Rules::live ? podrace::AT_CHECKPOINT : -1) {
        require(checkpoints.size() >= 2, "fewer than two checkpoints");
        require(checkpoints[0] != checkpoints[1], "checkpoints 0 and 1 in one place");
        for (const auto& place : checkpoints) {
            require(fits(place.first) && fits(place.second), "a checkpoint out of range");
            x.push_back(place.first);
            y.push_back(place.second);
        }
        const char* problem = selfCheck();
        if (problem != nullptr) {
            throw std::runtime_error(std::string("steward_podrace.hpp: ") + problem);
        }
    }

    int checkpoints() const { return static_cast<int>(x.size()); }
    double checkpointX(int k) const { return x[k]; }
    double checkpointY(int k) const { return y[k]; }

    /// The pods on their start places, headings unset.
    State start() const {
        State state = {};
        double dx = x[1] - x[0], dy = y[1] - y[0];
        double length = std::sqrt(dx * dx + dy * dy);
        for (int pod = 0; pod < podrace::PODS; pod++) {
            double side = (pod % 2 == 0 ? -1 : 1) * (pod < 2 ? 500 : 1500);
            set(state, pod, std::floor(x[0] - side * dy / length + 0.5), std::floor(y[0] + side * dx / length + 0.5),
                0, 0, std::nan(""), 0, true, 0);
        }
        state.left[0] = state.left[1] = 100;
        return state;
    }

    /// Sets a pod: u, u per turn (each 0 or 2^-100..2^30 in size), radians (0 or from 2^-300 on) or NaN, timer 0..4,
    /// checkpoints passed. At timer 4 it weighs 10 until its next command. Throws std::invalid_argument if a number is
    /// out of range.
    void set(State& state, int pod, double px, double py, double vx, double vy, double heading, int timer,
             bool boostLeft, int passed) const {
        require(pod >= 0 && pod < podrace::PODS, "pod out of range");
        require(fits(px) && fits(py) && fits(vx) && fits(vy), "place or speed out of range");
        double size = podrace::number(podrace::bits(heading) & ~0ull >> 1);
        require(!(size > 0 && size < 0x1p-300) && podrace::bits(size) != 0x7ff0000000000000u, "heading out of range");
        require(timer >= 0 && timer <= 4 && passed >= 0 && passed <= 1000000, "timer or passed out of range");
        state.x[pod] = px;
        state.y[pod] = py;
        state.vx[pod] = vx;
        state.vy[pod] = vy;
        state.heading[pod] = heading;
        state.flags[pod] = timer | (timer == 4 ? podrace::HEAVY : 0) | (boostLeft ? podrace::BOOST_LEFT : 0);
        state.passed[pod] = passed;
        state.next[pod] = (passed + 1) % checkpoints();
    }

    /// The distance of a pod from its next checkpoint, in u.
    double toNext(const State& state, int pod) const {
        double dx = x[state.next[pod]] - state.x[pod], dy = y[state.next[pod]] - state.y[pod];
        return std::sqrt(dx * dx + dy * dy);
    }

    /// Plays one turn. Returns false if it had more than 14,000 impacts; then the state is not the referee's.
    STEWARD_ONE_CALL bool play(State& state, const Commands& commands) const {
        podrace::Motion motion = steer(state, commands);
        state.left[0]--;
        state.left[1]--;
        int near = podrace::nearPairs(motion, 1);
        if (near != 0) {
            return collide(state, motion, near);
        }
        motion.fly(1);
        end(state, motion, nullptr);
        return true;
    }

    /// Moves to other checkpoints under the rules it has; allocates nothing if it had as many before. Each as the
    /// constructor takes them, which is not checked here.
    void place(const double* px, const double* py, int count) {
        x.assign(px, px + count);
        y.assign(py, py + count);
    }

    /// The hash of the state after a turn, as it stands in a replay of Steward. A player who is out has the turn of it.
    std::uint64_t hash(const State& state, int turn, int out0 = 0x7fffffff, int out1 = 0x7fffffff) const {
        std::uint64_t h = mix(0, static_cast<std::uint64_t>(turn));
        for (int pod = 0; pod < podrace::PODS; pod++) {
            double numbers[] = {state.x[pod], state.y[pod], state.vx[pod], state.vy[pod], state.heading[pod]};
            for (double value : numbers) {
                std::uint64_t word = podrace::bits(value);
                h = mix(h, (word & ~0ull >> 1) > 0x7ff0000000000000u ? 0x7ff8000000000000u : word);
            }
            h = mix(h, static_cast<std::uint64_t>(state.timer(pod)));
            h = mix(h, state.boostLeft(pod));
            h = mix(h, static_cast<std::uint64_t>(state.passed[pod]));
            h = mix(h, podrace::bits(state.flags[pod] & podrace::HEAVY ? 10.0 : 1.0));
        }
        for (int player = 0; player < 2; player++) {
            h = mix(h, static_cast<std::uint64_t>(static_cast<std::int64_t>(state.left[player])));
            h = mix(h, static_cast<std::uint64_t>(player == 0 ? out0 : out1));
        }
        return h;
    }

private:
    std::vector<double> x, y;
    double squareOfPath, squareOfEnd;

    Map(const double* px, const double* py, int count)
        : x(px, px + count), y(py, py + count), squareOfPath(podrace::WITHIN_CHECKPOINT),
          squareOfEnd(podrace::AT_CHECKPOINT) { }

    static void require(bool fulfilled, const char* found) {
        if (!fulfilled) {
            throw std::invalid_argument(std::string("steward_podrace.hpp: ") + found);
        }
    }

    static bool fits(double value) {
        double size = podrace::number(podrace::bits(value) & ~0ull >> 1);
        return size == 0 || (size >= podrace::TINY && size <= podrace::FAR_OUT);
    }

    static std::uint64_t mix(std::uint64_t h, std::uint64_t value) {
        std::uint64_t z = h + value + 0x9E3779B97F4A7C15u;
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
        z = (z ^ z >> 27) * 0x94D049BB133111EBu;
        return z ^ z >> 31;
    }

    /* The motion of a turn in which some pairs may meet, and its end. */
    STEWARD_ONE_CALL bool collide(State& state, const podrace::Motion& motion, int near) const {
        podrace::Flight flight(motion, state.flags);
        bool whole = flight.collide(near);
        end(state, flight.motion(), &flight);
        return whole;
    }

    /* Shields, boosts and timers: the thrust of each pod. */
    static void order(State& state, const Commands& commands, std::int32_t* power) {
        using namespace podrace;
#if STEWARD_AVX2 || STEWARD_SSE2
        __m128i thrusts = _mm_load_si128(reinterpret_cast<const __m128i*>(commands.thrust));
        if (_mm_movemask_ps(_mm_castsi128_ps(thrusts)) == 0) {
            __m128i* at = reinterpret_cast<__m128i*>(state.flags);
            __m128i flags = _mm_load_si128(at), zero = _mm_setzero_si128();
            __m128i timer = _mm_and_si128(flags, _mm_set1_epi32(TIMER));
            timer = _mm_add_epi32(timer, _mm_cmpgt_epi32(timer, zero));
            _mm_store_si128(at, _mm_or_si128(timer, _mm_and_si128(flags, _mm_set1_epi32(BOOST_LEFT))));
            _mm_store_si128(reinterpret_cast<__m128i*>(power), _mm_and_si128(thrusts, _mm_cmpeq_epi32(timer, zero)));
            return;
        }
#endif
        for (int pod = 0; pod < PODS; pod++) {
            int thrust = commands.thrust[pod], flags = state.flags[pod];
            int timer = thrust == SHIELD ? 4 : (flags & TIMER) > 0 ? (flags & TIMER) - 1 : 0;
            int heavy = thrust == SHIELD ? HEAVY : thrust == NO_COMMAND ? flags & HEAVY : 0;
            int boost = thrust == BOOST ? 0 : flags & BOOST_LEFT;
            state.flags[pod] = timer | heavy | boost;
            thrust = thrust == BOOST ? (flags & BOOST_LEFT ? 650 : 200) : thrust < 0 ? 0 : thrust;
            power[pod] = timer == 0 ? thrust : 0;
        }
    }

    /* Commands and headings. Returns places and speeds at the beginning of the turn. */
    STEWARD_INLINE static podrace::Motion steer(State& state, const Commands& commands) {
        using namespace podrace;
        alignas(16) std::int32_t powers[PODS];
        order(state, commands, powers);
        V px = load(state.x), py = load(state.y), heading = load(state.heading);
        V vx = load(state.vx), vy = load(state.vy), power = whole(powers);
        V targetX = load(commands.x), targetY = load(commands.y);
        V dx = targetX - px, dy = targetY - py;
        M byAngle = isNan(targetY);
        M drifts = either(equal(whole(commands.thrust), all(NO_COMMAND)),
            either(both(byAngle, isNan(heading)), both(equal(dx, all(0)), equal(dy, all(0)))));
        V wanted = heading;
        if (!every(byAngle)) {
            wanted = turned(heading, podrace::atan2(dy, dx));
        }
        if (any(byAngle)) {
            wanted = select(byAngle, select(equal(targetX, all(0)), heading, heading + targetX), wanted);
        }
        heading = select(drifts, heading, wanted);
        M pushed = without(less(all(0), power), drifts);
        V cosine, sine;
        turn(heading, pushed, cosine, sine);
        // The rules divide both by the root n of this sum, which is 1 - 2^-52, 1 - 2^-53, 1 or 1 + 2^-52, as both
        // are correctly rounded. So n is 1 - 2^-53 or 1, and a quotient by 1 - 2^-53 is the next greater double.
        M shortened = less(cosine * cosine + sine * sine, all(1));
        store(state.heading, heading);
        return {px, py, select(pushed, vx + next(shortened, cosine) * power, vx),
            select(pushed, vy + next(shortened, sine) * power, vy)};
    }

    /* Drag, rounding and checkpoints. */
    STEWARD_INLINE void end(State& state, const podrace::Motion& motion, const podrace::Flight* flight) const {
        using namespace podrace;
        const V zero = all(0), half = all(0.5), keep = all(KEEP);
        V toX = roundDown(motion.x + half), toY = roundDown(motion.y + half);
        V fromX = load(state.x), fromY = load(state.y), pathX = toX - fromX, pathY = toY - fromY;
        store(state.x, toX);
        store(state.y, toY);
        store(state.vx, cut(motion.vx * keep) + zero);
        store(state.vy, cut(motion.vy * keep) + zero);
        M far = staysFar(fromX - placesOf(x, state.next), fromY - placesOf(y, state.next), pathX, pathY, all(1),
            all(CHECKPOINT * CHECKPOINT + 1));
        far = both(far, less(size(pathX) + size(pathY), all(SHORT)));
        int mayPass = lanesOf(far) ^ EVERY;
        for (int pod = 0; flight != nullptr && pod < PODS; pod++) {
            mayPass |= flight->last[pod] >= 0 ? 1 << pod : 0;
        }
        if (mayPass != 0) {
            double startX[PODS], startY[PODS];
            store(startX, fromX);
            store(startY, fromY);
            pass(state, startX, startY, mayPass, flight);
        }
    }

    static podrace::V placesOf(const std::vector<double>& of, const std::int32_t* next) {
#if STEWARD_AVX2
        return _mm256_set_pd(of[next[3]], of[next[2]], of[next[1]], of[next[0]]);
#elif STEWARD_SSE2
        return {{_mm_set_pd(of[next[1]], of[next[0]])}, {_mm_set_pd(of[next[3]], of[next[2]])}};
#else
        return {{of[next[0]], of[next[1]]}, {of[next[2]], of[next[3]]}};
#endif
    }

    /* Counts the checkpoints on the paths of some pods, on behind the finish too, each once at most. */
    STEWARD_ONE_CALL void pass(State& state, const double* startX, const double* startY, int pods,
                               const podrace::Flight* flight) const {
        for (; pods != 0; pods &= pods - 1) {
            int pod = podrace::lowest(pods);
            for (int most = checkpoints(); most > 0 && passes(state, pod, startX[pod], startY[pod], flight); most--) {
                state.passed[pod]++;
                state.next[pod] = state.next[pod] + 1 < checkpoints() ? state.next[pod] + 1 : 0;
                state.left[pod / 2] = 100;
            }
        }
    }

    bool passes(const State& state, int pod, double fromX, double fromY, const podrace::Flight* flight) const {
        double cx = x[state.next[pod]], cy = y[state.next[pod]];
        for (int k = 0; flight != nullptr && k < flight->corners; k++) {
            const podrace::Flight::Corner& corner = flight->corner(k);
            if (corner.pod == pod) {
                if (reaches(cx, cy, fromX, fromY, corner.x, corner.y)) {
                    return true;
                }
                fromX = corner.x;
                fromY = corner.y;
            }
        }
        double dx = cx - state.x[pod], dy = cy - state.y[pod];
        return reaches(cx, cy, fromX, fromY, state.x[pod], state.y[pod]) || dx * dx + dy * dy <= squareOfEnd;
    }

    bool reaches(double cx, double cy, double ax, double ay, double bx, double by) const {
        return !podrace::isFar(cx, cy, ax, ay, bx, by)
            && podrace::squareOfDistance(cx, cy, ax, ay, bx, by) <= squareOfPath;
    }

    /* Some turns of a brawl whose last bits are known, and operations that careless compilers change. */
    STEWARD_ONE_CALL static const char* selfCheck() {
        volatile double tiny = 0x1p-1060, third = 1.0 / 3, great = 0x1p53, one = 1;
        double t = third, g = great;
        if (tiny * 0.5 == 0) {
            return "numbers below 2^-1022 are flushed to zero; link without -Ofast and -ffast-math";
        }
        if (t * t - 0.1111111111111111 != 0 || (g + one) - g != 0) {
            return "operations are contracted or reordered; compile without -ffast-math and -Ofast";
        }
        const double px[] = {12460, 10540, 3580}, py[] = {1350, 5980, 5180};
        Map map(px, py, 3);
        State state = map.start();
        Commands commands;
        std::uint64_t h = 0;
        for (int turn = 0; turn < 24; turn++) {
            for (int pod = 0; pod < podrace::PODS; pod++) {
                int other = (pod + 1 + turn / 8) % podrace::PODS;
                commands.target(pod, state.x[other] + 37 * pod, state.y[other] - 11 * turn,
                    turn == 13 && pod == 1 ? static_cast<int>(SHIELD) : 200 - 7 * pod);
            }
            map.play(state, commands);
            h = mix(h, map.hash(state, turn));
        }
        return h == 0x6cd2d08c053f5020u ? nullptr : "its turns are not the referee's; are there flags that change arithmetic?";
    }
};

} // namespace steward

#undef STEWARD_AVX2
#undef STEWARD_SSE2
#undef STEWARD_ONE_CALL
#undef STEWARD_INLINE
#if defined(__clang__) || defined(_MSC_VER)
#pragma float_control(pop)
#elif defined(__GNUC__)
#pragma GCC pop_options
#endif
#endif
