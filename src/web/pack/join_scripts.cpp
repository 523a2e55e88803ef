// Joins the scripts that a page packs: join_scripts OUTPUT FOLDER
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include "web/pack/compact_script.h"
#include "web/pack/page_scripts.h"

int main(int n_arguments, char** arguments) {
    if (n_arguments != 3) {
        std::cerr << "usage: join_scripts OUTPUT FOLDER\n";
        return 2;
    }
    std::ofstream output(arguments[1], std::ios::binary);
    for (const std::string_view name : poinsot::packed_scripts) {
        std::ostringstream text;
        text << std::ifstream(std::string(arguments[2]) + "/" + std::string(name)).rdbuf();
        output << poinsot::compact_script(text.str());
    }
    output.close();
    return output ? 0 : 3;
}
