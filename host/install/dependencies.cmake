# Libraries outside Offing that its libraries may link: how an installed Offing finds each again, from CMake and
# from pkg-config. A library that is linked and has no row here stops the configuration, so the list cannot rot.
# GPL libraries (FFTW, CGAL) have no row on purpose: only tests, offing-bench and mesh_tools link them.

# offing_dependency(<target> CMAKE <statement...> [PKG_CONFIG <modules...>] [PKG_CONFIG_LIBRARIES <flags...>]); the
# last for libraries that no module of pkg-config knows.
function(offing_dependency target)
  cmake_parse_arguments(ARG "" "" "CMAKE;PKG_CONFIG;PKG_CONFIG_LIBRARIES" ${ARGN})
  list(JOIN ARG_CMAKE "\n" statements)
  set_property(GLOBAL PROPERTY "OFFING_DEPENDENCY_CMAKE_${target}" "${statements}")
  set_property(GLOBAL PROPERTY "OFFING_DEPENDENCY_PKG_CONFIG_${target}" "${ARG_PKG_CONFIG}")
  set_property(GLOBAL PROPERTY "OFFING_DEPENDENCY_LIBRARIES_${target}" "${ARG_PKG_CONFIG_LIBRARIES}")
endfunction()

offing_dependency(fmt::fmt CMAKE "find_dependency(fmt)" PKG_CONFIG fmt)
offing_dependency(spdlog::spdlog CMAKE "find_dependency(spdlog)" PKG_CONFIG spdlog)
offing_dependency(Threads::Threads CMAKE "find_dependency(Threads)")
offing_dependency(glm::glm CMAKE "find_dependency(glm)")
offing_dependency(OpenCL::OpenCL CMAKE "find_dependency(OpenCL)" PKG_CONFIG OpenCL)
offing_dependency(OpenEXR::OpenEXR CMAKE "find_dependency(OpenEXR)" PKG_CONFIG OpenEXR)
offing_dependency(Imath::Imath CMAKE "find_dependency(Imath)" PKG_CONFIG Imath)
offing_dependency(GDAL::GDAL CMAKE "find_dependency(GDAL)" PKG_CONFIG gdal)
offing_dependency(PNG::PNG CMAKE "find_dependency(PNG)" PKG_CONFIG libpng)
offing_dependency(PkgConfig::NETCDF
  CMAKE "find_dependency(PkgConfig)" "pkg_check_modules(NETCDF REQUIRED QUIET IMPORTED_TARGET netcdf)"
  PKG_CONFIG netcdf)
offing_dependency(tomlplusplus::tomlplusplus CMAKE "find_dependency(tomlplusplus)" PKG_CONFIG tomlplusplus)
offing_dependency(nlohmann_json::nlohmann_json CMAKE "find_dependency(nlohmann_json)" PKG_CONFIG nlohmann_json)
offing_dependency(PkgConfig::CAIRO
  CMAKE "find_dependency(PkgConfig)" "pkg_check_modules(CAIRO REQUIRED QUIET IMPORTED_TARGET cairo)"
  PKG_CONFIG cairo)
offing_dependency(openvdb CMAKE "" PKG_CONFIG_LIBRARIES -lopenvdb)
offing_dependency(TBB::tbb CMAKE "find_dependency(TBB)" PKG_CONFIG tbb)
offing_dependency(ZLIB::ZLIB CMAKE "find_dependency(ZLIB)" PKG_CONFIG zlib)
