#include <deltaform/app/program.h>

int
main(int argc, char *argv[])
{
  return deltaform::run_program(argc, argv);
}
