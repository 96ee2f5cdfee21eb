#pragma once

// Marks a function for host and device; the physics headers include nothing else of Thalweg.
#if defined(__CUDACC__)
#define HOST_DEVICE __host__ __device__
#else
#define HOST_DEVICE
#endif
