// Writes the workbench, poinsot.html: make_workbench OUTPUT SCHEMA SCENE… [--new SCENE…]
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "web/pack/page_job.h"

int main(int n_arguments, char** arguments) {
    using namespace poinsot;
    try {
        const std::vector<std::string> given(arguments + 1, arguments + n_arguments);
        if (given.size() < 3) {
            std::cerr << "usage: make_workbench OUTPUT SCHEMA SCENE... [--new SCENE...]\n";
            return 2;
        }
        WorkbenchRequest workbench;
        workbench.schema_file = given[1];
        std::vector<SceneRequest>* scenes = &workbench.scenes;
        for (std::size_t i = 2; i < given.size(); ++i) {
            if (given[i] == "--new") {
                scenes = &workbench.starts;
                continue;
            }
            SceneRequest request;
            request.file = given[i];
            scenes->push_back(request);
        }
        LazyRenderer renderer;
        write_workbench(workbench, given[0], renderer);
    } catch (const std::exception& error) {
        std::cerr << "make_workbench: " << error.what() << "\n";
        return 3;
    }
    return 0;
}
