# OpenFOAM v1912 or newer as the target OpenFOAM::finiteVolume: include directories, flags and libraries of interFoam.
#
# A sourced OpenFOAM environment (WM_PROJECT_DIR with FOAM_SRC and FOAM_LIBBIN) is used if there is one. Otherwise
# FRAZIL_OPENFOAM_ROOT (CMake or environment variable; default $XDG_CACHE_HOME/frazil/openfoam-1912 or
# ~/.cache/frazil/openfoam-1912, where `./frazil setup` puts the headers of Debian's package) with Debian's libraries.

if(TARGET OpenFOAM::finiteVolume)
    return()
endif()

if(DEFINED ENV{FOAM_SRC} AND DEFINED ENV{FOAM_LIBBIN} AND EXISTS "$ENV{FOAM_SRC}/OpenFOAM/lnInclude")
    set(root $ENV{WM_PROJECT_DIR})
    set(OpenFOAM_SRC $ENV{FOAM_SRC})
    set(libraryHints $ENV{FOAM_LIBBIN} $ENV{FOAM_LIBBIN}/$ENV{FOAM_MPI})
    set(libraryOptions NO_DEFAULT_PATH)
    set(labelSize $ENV{WM_LABEL_SIZE})
    set(precision $ENV{WM_PRECISION_OPTION})
else()
    set(root ${FRAZIL_OPENFOAM_ROOT})
    if(NOT root)
        set(root $ENV{FRAZIL_OPENFOAM_ROOT})
    endif()
    if(NOT root AND DEFINED ENV{XDG_CACHE_HOME})
        set(root $ENV{XDG_CACHE_HOME}/frazil/openfoam-1912)
    elseif(NOT root)
        set(root $ENV{HOME}/.cache/frazil/openfoam-1912)
    endif()
    set(OpenFOAM_SRC ${root}/src)
    set(libraryHints /lib /usr/lib)
    set(libraryOptions)
endif()
if(NOT labelSize)
    set(labelSize 32)
endif()
if(NOT precision)
    set(precision DP)
endif()

if(NOT EXISTS ${OpenFOAM_SRC}/finiteVolume/lnInclude/fvCFD.H)
    message(FATAL_ERROR
        "OpenFOAM's headers are not in ${OpenFOAM_SRC}.\n"
        "Run ./frazil setup (it fetches the headers of Debian's OpenFOAM package), source an OpenFOAM v1912 or newer "
        "environment, or give the folder that holds src/ with -DFRAZIL_OPENFOAM_ROOT=...")
endif()

set(api 1912)
if(EXISTS ${root}/META-INFO/api-info)
    file(STRINGS ${root}/META-INFO/api-info apiLine REGEX "^api=[0-9]+")
    string(REGEX REPLACE "^api=" "" api "${apiLine}")
endif()

set(includes)
foreach(folder
        OpenFOAM OSspecific/POSIX finiteVolume meshTools sampling surfMesh fileFormats dynamicMesh dynamicFvMesh
        transportModels/incompressible transportModels/interfaceProperties transportModels/twoPhaseMixture
        transportModels/twoPhaseProperties transportModels/immiscibleIncompressibleTwoPhaseMixture
        TurbulenceModels/turbulenceModels TurbulenceModels/incompressible fvOptions)
    if(EXISTS ${OpenFOAM_SRC}/${folder}/lnInclude)
        list(APPEND includes ${OpenFOAM_SRC}/${folder}/lnInclude)
    endif()
endforeach()
list(APPEND includes ${OpenFOAM_SRC}/transportModels)
foreach(solver VoF interFoam)
    list(APPEND includes ${root}/applications/solvers/multiphase/${solver})
endforeach()

set(libraries)
foreach(name
        OpenFOAM Pstream finiteVolume fvOptions meshTools sampling surfMesh fileFormats dynamicMesh dynamicFvMesh
        incompressibleTransportModels interfaceProperties twoPhaseMixture immiscibleIncompressibleTwoPhaseMixture
        turbulenceModels incompressibleTurbulenceModels waveModels)
    # Not from the cache: a build folder that was configured for another OpenFOAM would keep its libraries
    unset(OpenFOAM_${name}_LIBRARY CACHE)
    find_library(OpenFOAM_${name}_LIBRARY NAMES ${name} PATHS ${libraryHints} ${libraryOptions})
    if(NOT OpenFOAM_${name}_LIBRARY AND NOT name MATCHES "^(twoPhaseMixture|fileFormats)$")
        message(FATAL_ERROR "OpenFOAM's library lib${name}.so is not in ${libraryHints}.\n"
            "Run ./frazil setup (it installs the packages openfoam and libopenfoam) or source your OpenFOAM.")
    elseif(OpenFOAM_${name}_LIBRARY)
        list(APPEND libraries ${OpenFOAM_${name}_LIBRARY})
    endif()
endforeach()

# OpenFOAM declares the operands of its field loops __restrict__, yet `a & b` of two temporaries writes its result into
# b's memory. A compiler that believes it and vectorises (g++ 12 with -O3) computes products of tensors and vectors from
# overwritten components: U on any mesh whose cells are not aligned with the axes. Without the word, loops are vectorised
# behind a check of the addresses. The libraries as installed may have the fault; a sourced one can be built with -O2.
set(noFalsePromise "__restrict__=")

# Run-time selection lives in static objects of libraries that no symbol refers to, hence --no-as-needed.
add_library(OpenFOAM::finiteVolume INTERFACE IMPORTED GLOBAL)
set_target_properties(OpenFOAM::finiteVolume PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${includes}"
    INTERFACE_COMPILE_DEFINITIONS
        "WM_${precision};WM_LABEL_SIZE=${labelSize};NoRepository;OPENFOAM=${api};OMPI_SKIP_MPICXX;${noFalsePromise}"
    INTERFACE_COMPILE_OPTIONS "-ftemplate-depth-100"
    INTERFACE_LINK_LIBRARIES "-Wl,--no-as-needed;${libraries};dl;m")
set(OpenFOAM_FOUND TRUE)
if(NOT OpenFOAM_FIND_QUIETLY)
    message(STATUS "OpenFOAM v${api}: headers in ${OpenFOAM_SRC}")
endif()
