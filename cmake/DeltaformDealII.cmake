# deltaform_make_global(<target>...): make imported targets of this folder known outside of it: a project that has deltaform as a
# subfolder links the library there. Those that the project has found itself are not this folder's.
function(deltaform_make_global)
  get_property(_own DIRECTORY PROPERTY IMPORTED_TARGETS)
  foreach(_target IN LISTS ARGN)
    if(_target IN_LIST _own)
      set_target_properties(${_target} PROPERTIES IMPORTED_GLOBAL TRUE)
    endif()
  endforeach()
endfunction()

# deltaform_deal_ii(<DEBUG or RELEASE>): the target deltaform::deal_ii, what a program needs that includes headers of
# deltaform: deal.II's headers, definitions and library in this flavour, without its compiler flags, which are nobody else's
# business. Used by the build and, installed, by find_package(deltaform).
function(deltaform_deal_ii flavour)
  if(TARGET deltaform::deal_ii)
    return()
  endif()
  # deal.II 9.4 makes its targets only when its macro is called.
  if(NOT TARGET "${DEAL_II_TARGET_${flavour}}" AND DEAL_II_TARGET_CONFIG)
    include(${DEAL_II_TARGET_CONFIG})
    set(DEAL_II_TARGET_CONFIG_INCLUDED TRUE PARENT_SCOPE)
  endif()
  deltaform_make_global(${DEAL_II_TARGET_${flavour}})
  add_library(deltaform::deal_ii INTERFACE IMPORTED GLOBAL)
  set(_definitions ${DEAL_II_USER_DEFINITIONS} ${DEAL_II_USER_DEFINITIONS_${flavour}})
  list(REMOVE_ITEM _definitions NDEBUG)
  target_include_directories(deltaform::deal_ii SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS})
  target_compile_definitions(deltaform::deal_ii INTERFACE ${_definitions})
  target_link_libraries(deltaform::deal_ii INTERFACE ${DEAL_II_TARGET_${flavour}})
  # deal.II names a hundred libraries; what a program does not refer to it need not load.
  target_link_options(deltaform::deal_ii INTERFACE -Wl,--as-needed)
endfunction()
