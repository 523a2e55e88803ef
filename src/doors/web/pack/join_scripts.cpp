// Joins the scripts that a page packs: join_scripts OUTPUT FOLDER
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include "web/pack/page_scripts.h"

int main(int n_arguments, char** arguments) {
    if (n_arguments != 3) {
        std::cerr << "usage: join_scripts OUTPUT FOLDER\n";
        return 2;
    }
    const auto text_of = [folder = std::string(arguments[2])](const std::string& name) {
        std::ostringstream text;
        text << std::ifstream(folder + "/" + name).rdbuf();
        return text.str();
    };
    std::ofstream output(arguments[1], std::ios::binary);
    output << poinsot::joined_scripts(poinsot::page_scripts(text_of).packed, text_of);
    output.close();
    return output ? 0 : 3;
}
