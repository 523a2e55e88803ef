# What is made from tables, scene files and pictures, and committed. Needs the program alone, not the tests.

# The scene reference, the schema and the gallery's tables: cmake --build build/release --target docs
add_custom_target(docs
    COMMAND /usr/bin/python3 ${CMAKE_SOURCE_DIR}/tests/docs/scene_reference.py write $<TARGET_FILE:poinsot>
    COMMAND $<TARGET_FILE:poinsot> list schema > ${CMAKE_SOURCE_DIR}/scenes/scene.schema.json
    COMMAND /usr/bin/python3 ${CMAKE_SOURCE_DIR}/tests/golden/gallery.py text VERBATIM)

# The gallery's pictures: cmake --build build/release --target gallery
add_custom_target(gallery
    COMMAND /usr/bin/python3 ${CMAKE_SOURCE_DIR}/tests/golden/gallery.py draw $<TARGET_FILE:poinsot> VERBATIM)
