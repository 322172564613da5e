# What every RGIMP target shares: warnings, sanitizers, rounding after every operation: users' flags
# (-march=native) would let compilers fuse some, each another choice, and change results; and calls
# that stay inside a shared library, such as the Python module, and so can be inlined.
function(rgimp_configure target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                           -Wno-sign-conversion -ffp-contract=off
                                           -fno-semantic-interposition)
  if(RGIMP_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(RGIMP_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${RGIMP_SANITIZE}
                                             -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${RGIMP_SANITIZE})
  endif()
endfunction()
