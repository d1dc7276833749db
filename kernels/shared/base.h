// Scalar types both compilers read. Structs built from them hold scalars and arrays of scalars only, because vector
// types differ in size and alignment between OpenCL C and the host's maths library.
#ifndef LACUNA_SHARED_BASE_H
#define LACUNA_SHARED_BASE_H

#ifdef __OPENCL_C_VERSION__
typedef int s_int;
typedef uint s_uint;
typedef float s_float;
#define SHARED_CHECK(type, bytes) typedef char type##_size_check[sizeof(type) == (bytes) ? 1 : -1]
#else
#include <cstdint>
typedef std::int32_t s_int;
typedef std::uint32_t s_uint;
typedef float s_float;
#define SHARED_CHECK(type, bytes) static_assert(sizeof(type) == (bytes), "layout differs between host and device")
#endif

#endif
