#include "cli/program.hpp"

int main(int argc, char** argv) { return delone::cli::run_program(argc, argv); }
