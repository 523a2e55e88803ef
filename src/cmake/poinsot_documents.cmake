# --target docs: the pages and the schema, generated from the program's tables and the scene files.
add_custom_target(docs
    COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/tests/docs/scene_reference.py write $<TARGET_FILE:poinsot>
    COMMAND $<TARGET_FILE:poinsot> list schema > ${PROJECT_SOURCE_DIR}/scenes/scene.schema.json
    COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/tests/golden/gallery.py text VERBATIM)

# --target gallery: the pictures of docs/gallery.md and README.md.
add_custom_target(gallery
    COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/tests/golden/gallery.py draw $<TARGET_FILE:poinsot> VERBATIM)
