# Warnings and sanitizers of every target below this directory. They are options of the directory, not of the targets,
# so nothing of them reaches the installed package.
add_compile_options(-Wall -Wextra -Wconversion -Wsign-conversion -Wshadow)
# Where the standard library is in a precompiled header, g++ 12 sees bounds overstepped inside of std::string that are
# not (GCC bug 105651), and does not know that it is a system header.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  add_compile_options(-Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread)
endif()
if(MDM_WERROR)
  add_compile_options(-Werror)
endif()
if(MDM_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "MDM_FUZZ needs clang: configure with -DCMAKE_CXX_COMPILER=clang++ or --preset ci-clang")
  endif()
  if(NOT MDM_SANITIZE)
    set(MDM_SANITIZE address,undefined)
  endif()
endif()
if(MDM_SANITIZE)
  add_compile_options(-fsanitize=${MDM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${MDM_SANITIZE})
endif()
