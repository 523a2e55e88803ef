// Writes the workbench, poinsot.html: make_workbench OUTPUT SCHEMA SCENE…
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "production/pages/page_job.h"

int main(int n_arguments, char** arguments) {
    using namespace poinsot;
    try {
        const std::vector<std::string> given(arguments + 1, arguments + n_arguments);
        if (given.size() < 3) {
            std::cerr << "usage: make_workbench OUTPUT SCHEMA SCENE...\n";
            return 2;
        }
        std::vector<SceneRequest> scenes;
        for (std::size_t i = 2; i < given.size(); ++i) {
            SceneRequest request;
            request.file = given[i];
            scenes.push_back(request);
        }
        LazyRenderer renderer;
        write_workbench(scenes, given[1], given[0], renderer);
    } catch (const std::exception& error) {
        std::cerr << "make_workbench: " << error.what() << "\n";
        return 3;
    }
    return 0;
}
