# Run by cpack in the staged tree: /usr/lib/python3.11/dist-packages becomes /usr/lib/python3/dist-packages.
file(GLOB _versions ${CPACK_TEMPORARY_DIRECTORY}/usr/lib/python3.*)
foreach(_version IN LISTS _versions)
  file(RENAME ${_version} ${CPACK_TEMPORARY_DIRECTORY}/usr/lib/python3)
endforeach()
