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

# For what spends its time in the libraries, not in itself: at -O1 the command's and the Python
# module's sources take three quarters of the time to compile. GCC's look for uninitialised values
# errs at that level.
function(rgimp_optimise_little target)
  target_compile_options(${target} PRIVATE
    $<$<CONFIG:Release>:-O1> $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endfunction()
