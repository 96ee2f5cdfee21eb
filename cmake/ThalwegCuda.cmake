# THALWEG_CUDA: whether the solver's core for NVIDIA GPUs is built. AUTO builds it where the CUDA Toolkit (12 or newer) is;
# a machine without gets everything else. Sets THALWEG_HAS_CUDA and THALWEG_HAS_GPU, and enables the language.
set(THALWEG_CUDA "AUTO" CACHE STRING "Build the CUDA core: AUTO (where nvcc is), ON, OFF")
set_property(CACHE THALWEG_CUDA PROPERTY STRINGS AUTO ON OFF)

set(THALWEG_HAS_CUDA OFF)
set(THALWEG_HAS_GPU OFF)
if(THALWEG_CUDA STREQUAL "OFF")
  return()
endif()

execute_process(COMMAND nvidia-smi -L RESULT_VARIABLE no_gpu OUTPUT_QUIET ERROR_QUIET)
if(no_gpu EQUAL 0)
  set(THALWEG_HAS_GPU ON)
endif()
if(NOT DEFINED CMAKE_CUDA_ARCHITECTURES AND NOT DEFINED ENV{CUDAARCHS})
  # Code for A100 and H100/H200, and text (PTX) that newer drivers compile for newer GPUs; "native" or any list may be given.
  set(CMAKE_CUDA_ARCHITECTURES 80-real 90)
  if(THALWEG_HAS_GPU)
    set(CMAKE_CUDA_ARCHITECTURES native)
  endif()
endif()

find_program(THALWEG_NVCC nvcc HINTS ENV CUDA_PATH ENV CUDA_HOME PATH_SUFFIXES bin PATHS /usr/local/cuda/bin)
if(THALWEG_NVCC AND NOT DEFINED CMAKE_CUDA_COMPILER)
  set(CMAKE_CUDA_COMPILER "${THALWEG_NVCC}")
endif()
include(CheckLanguage)
check_language(CUDA)
if(NOT CMAKE_CUDA_COMPILER)
  if(THALWEG_CUDA STREQUAL "ON")
    message(FATAL_ERROR "THALWEG_CUDA is ON and no CUDA compiler works here: install the CUDA Toolkit, name its nvcc with "
                        "-DCMAKE_CUDA_COMPILER=…, or configure with -DTHALWEG_CUDA=AUTO")
  endif()
  message(STATUS "no CUDA Toolkit found: the solver will run on CPU cores only")
  return()
endif()
enable_language(CUDA)
if(CMAKE_CUDA_COMPILER_VERSION VERSION_LESS 12)
  set(too_old "CUDA ${CMAKE_CUDA_COMPILER_VERSION} is too old for C++20 (12 or newer is needed)")
  if(THALWEG_CUDA STREQUAL "ON")
    message(FATAL_ERROR "${too_old}; name a newer nvcc with -DCMAKE_CUDA_COMPILER=…")
  endif()
  message(STATUS "${too_old}: the solver will run on CPU cores only")
  return()
endif()
if(NOT CMAKE_CUDA20_STANDARD_COMPILE_OPTION)  # unknown to CMake 3.25
  set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION "-std=c++20")
  set(CMAKE_CUDA20_EXTENSION_COMPILE_OPTION "-std=c++20")
endif()
if(THALWEG_CCACHE)
  set(CMAKE_CUDA_COMPILER_LAUNCHER "${THALWEG_CCACHE}")
endif()
set(THALWEG_HAS_CUDA ON)
message(STATUS "CUDA ${CMAKE_CUDA_COMPILER_VERSION}, for ${CMAKE_CUDA_ARCHITECTURES}")

# The settings of thalweg_settings (ThalwegTarget.cmake) in nvcc's words. The bodies of passes are lambdas for host and device, and
# call constexpr functions of the standard library; EIGEN_NO_CUDA keeps Eigen, which no kernel uses, plain. Division and root in
# one instruction (errors of 1 to 2 units in the last place, as in the CPU's lanes) take the momentum sweep from 272 to 160 instructions.
function(thalweg_cuda_settings target)
  target_include_directories(${target} PUBLIC "${PROJECT_SOURCE_DIR}")
  target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CUDA>:--extended-lambda --expt-relaxed-constexpr
    --ftz=true --prec-div=false --prec-sqrt=false
    $<$<BOOL:${THALWEG_WARNINGS_ARE_ERRORS}>:-Werror=all-warnings> -Xptxas=-v -Xfatbin=-compress-all -Xcompiler=-Wall,-Wextra,-fvisibility=hidden>)
  target_compile_definitions(${target} PRIVATE EIGEN_NO_CUDA)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
endfunction()
