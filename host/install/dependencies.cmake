# Libraries outside Offing that its libraries may link: how an installed Offing finds each again, from CMake and
# from pkg-config. A library that is linked and has no row here stops the configuration, so the list cannot rot.
# GPL libraries (FFTW, CGAL) have no row on purpose: only tests, offing-bench and mesh_tools link them.

# offing_dependency(<target> CMAKE <statement...> [PKG_CONFIG <modules...>] [PKG_CONFIG_LIBRARIES <flags...>]
#                   [DEBIAN <packages...>])
# PKG_CONFIG_LIBRARIES is for libraries that no module of pkg-config knows; DEBIAN names the packages that hold them.
function(offing_dependency target)
  cmake_parse_arguments(ARG "" "" "CMAKE;PKG_CONFIG;PKG_CONFIG_LIBRARIES;DEBIAN" ${ARGN})
  list(JOIN ARG_CMAKE "\n" statements)
  set_property(GLOBAL PROPERTY "OFFING_DEPENDENCY_CMAKE_${target}" "${statements}")
  set_property(GLOBAL PROPERTY "OFFING_DEPENDENCY_PKG_CONFIG_${target}" "${ARG_PKG_CONFIG}")
  set_property(GLOBAL PROPERTY "OFFING_DEPENDENCY_LIBRARIES_${target}" "${ARG_PKG_CONFIG_LIBRARIES}")
  set_property(GLOBAL PROPERTY "OFFING_DEPENDENCY_DEBIAN_${target}" "${ARG_DEBIAN}")
endfunction()

offing_dependency(fmt::fmt CMAKE "find_dependency(fmt)" PKG_CONFIG fmt DEBIAN libfmt-dev)
offing_dependency(spdlog::spdlog CMAKE "find_dependency(spdlog)" PKG_CONFIG spdlog DEBIAN libspdlog-dev)
offing_dependency(Threads::Threads CMAKE "find_dependency(Threads)")
offing_dependency(glm::glm CMAKE "find_dependency(glm)" DEBIAN libglm-dev)
offing_dependency(OpenCL::OpenCL CMAKE "find_dependency(OpenCL)" PKG_CONFIG OpenCL DEBIAN ocl-icd-opencl-dev opencl-headers)
offing_dependency(OpenEXR::OpenEXR CMAKE "find_dependency(OpenEXR)" PKG_CONFIG OpenEXR DEBIAN libopenexr-dev)
offing_dependency(PNG::PNG CMAKE "find_dependency(PNG)" PKG_CONFIG libpng DEBIAN libpng-dev)
offing_dependency(tomlplusplus::tomlplusplus CMAKE "find_dependency(tomlplusplus)" PKG_CONFIG tomlplusplus DEBIAN libtomlplusplus-dev)
offing_dependency(nlohmann_json::nlohmann_json CMAKE "find_dependency(nlohmann_json)" PKG_CONFIG nlohmann_json DEBIAN nlohmann-json3-dev)
offing_dependency(ZLIB::ZLIB CMAKE "find_dependency(ZLIB)" PKG_CONFIG zlib DEBIAN zlib1g-dev)
offing_dependency(dl CMAKE "" PKG_CONFIG_LIBRARIES -ldl)
