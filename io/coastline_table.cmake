# Compiles data/coastline/ne_110m_coastline.csv into the library: sets coastline_table to the source to build.
set(coastline_csv "${PROJECT_SOURCE_DIR}/data/coastline/ne_110m_coastline.csv")
set(coastline_table "${CMAKE_CURRENT_BINARY_DIR}/coastline_table.cpp")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${coastline_csv}")
file(READ "${coastline_csv}" coastline_rows)
string(REPLACE "line,lon,lat\n" "" coastline_rows "${coastline_rows}")
string(REGEX REPLACE "([^,\n]+),([^,\n]+),([^,\n]+)\n"
       "    {\\1, static_cast<float>(\\2), static_cast<float>(\\3)},\n" coastline_rows "${coastline_rows}")
configure_file("${CMAKE_CURRENT_SOURCE_DIR}/coastline_table.cpp.in" "${coastline_table}" @ONLY)
