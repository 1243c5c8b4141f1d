# Takes clang where it is installed, for its libFuzzer; otherwise the system's compiler.
find_program(ISOSCOPE_CLANG NAMES clang clang-19 clang-18 clang-17 clang-16 clang-15 clang-14)
find_program(ISOSCOPE_CLANGXX NAMES clang++ clang++-19 clang++-18 clang++-17 clang++-16 clang++-15 clang++-14)
if(ISOSCOPE_CLANG AND ISOSCOPE_CLANGXX)
  set(CMAKE_C_COMPILER ${ISOSCOPE_CLANG})
  set(CMAKE_CXX_COMPILER ${ISOSCOPE_CLANGXX})
endif()
