#pragma once

// HOST_DEVICE marks a function that runs on the host and on a device. nvcc needs the mark; other compilers see nothing.
#if defined(__CUDACC__)
#define HOST_DEVICE __host__ __device__
#else
#define HOST_DEVICE
#endif
