# Debian packages of what is installed, made by `./dev package`: offing (programs, scenes and the shared library) and
# offing-dev (static libraries and headers). The source archive is made by `git archive`, which takes committed files alone.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME offing)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL programs development)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_SOURCE_DIR}/debian/prepare_files.cmake)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
# A domain that exists for nobody (RFC 2606); who publishes the package names another.
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "Offing developers <offing@offing.invalid>")
set(CPACK_DEBIAN_PACKAGE_VERSION ${PROJECT_VERSION})

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME offing)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
# What Debian wants of a package with a shared library: its name for others, and that the loader's cache is renewed.
get_target_property(interface offing_shared SOVERSION)
file(CONFIGURE OUTPUT debian/shlibs CONTENT "liboffing ${interface} offing (>= ${PROJECT_VERSION})\n")
file(CONFIGURE OUTPUT debian/triggers CONTENT "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_CONTROL_EXTRA
    ${CMAKE_CURRENT_BINARY_DIR}/debian/shlibs ${CMAKE_CURRENT_BINARY_DIR}/debian/triggers)
# Programs open an OpenCL implementation and Mesa's drivers while they run, so that shlibdeps cannot see them.
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS "pocl-opencl-icd | opencl-icd, libegl1, libgl1-mesa-dri")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS ffmpeg)
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION
"Offing computes calibrated seas from wave spectra, and terrain without
meshes, on any OpenCL device. It writes OpenEXR maps, pictures, volumes and
animations, and answers queries about water and terrain.
.
The programs are offing (maps, measurements and queries), offing-view (a
window, pictures and videos of a scene) and offing-mesh (check, repair and
curvature of meshes). The library liboffing has the C interface.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME offing-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
list(APPEND debian_packages "offing (= ${PROJECT_VERSION})")  # the modules
list(JOIN debian_packages ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
"Static libraries, C++ headers and a C header for programs that compute seas,
terrain, clouds and highlights with Offing. CMake finds them by
find_package(Offing), other build systems by pkg-config offing.")

# What Debian wants in each package, and no other installation has. With SOURCE_DATE_EPOCH, two builds are equal.
string(TIMESTAMP package_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(debian/changelog.in changelog @ONLY)
execute_process(COMMAND gzip --best --no-name --stdout changelog
  OUTPUT_FILE changelog.gz WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} COMMAND_ERROR_IS_FATAL ANY)
foreach(component programs development)
  string(TOUPPER ${component} key)
  install(FILES debian/copyright ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${key}_PACKAGE_NAME} COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()

include(CPack)
