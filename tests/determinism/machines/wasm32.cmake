# WebAssembly with the system interface WASI, by Clang and LLVM's C++ library. Its file system is what the one who
# runs it lends it: see wasi_run.mjs.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_SYSROOT /usr)
